#pragma once

#include "renderer/gl/names.h"
#include "renderer/gl/program_source.h"

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <map>
#include <span>
#include <string>

namespace limner::gl {

/// A linked program. Setting what the program does not read does nothing: a feature that is not in it has no uniform.
class Program {
  public:
    /// Throws Error(noOpenGl) with the first message of the compiler, its place in the feature's file.
    Program(const Functions& gl, const ProgramSource& vertex, const ProgramSource& fragment);

    void use() const;
    // The program must be in use.
    void set(const std::string& name, float v);
    void set(const std::string& name, int v);
    void set(const std::string& name, const glm::vec2& v);
    void set(const std::string& name, const glm::ivec2& v);
    void set(const std::string& name, const glm::vec3& v);
    void set(const std::string& name, const glm::ivec3& v);
    void set(const std::string& name, const glm::vec4& v);
    void set(const std::string& name, const glm::mat3& v);
    void set(const std::string& name, std::span<const float> v);
    void set(const std::string& name, std::span<const glm::vec4> v);

  private:
    GLint place(const std::string& name);

    const Functions* gl_;
    ProgramName program_;
    std::map<std::string, GLint> places_;
};

} // namespace limner::gl
