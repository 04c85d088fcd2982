#include "renderer/gl/program.h"

#include "core/base/error.h"

#include <glm/gtc/type_ptr.hpp>

namespace limner::gl {

namespace {

std::string firstLine(const std::string& log) { return log.substr(0, log.find('\n')); }

Error failure(const std::string& why) {
    return {ErrorKind::noOpenGl,
            {"this figure cannot be drawn with OpenGL", "", why, "render with the backend cpu, and report this"}};
}

class Shader {
  public:
    Shader(const Functions& gl, GLenum stage, const ProgramSource& source) : gl_(gl), id_(gl.CreateShader(stage)) {
        const std::string text = source.text();
        const char* pointer = text.c_str();
        gl.ShaderSource(id_, 1, &pointer, nullptr);
        gl.CompileShader(id_);
        GLint compiled = GL_FALSE;
        gl.GetShaderiv(id_, GL_COMPILE_STATUS, &compiled);
        if (compiled != GL_TRUE) {
            std::string log(4096, '\0');
            GLsizei length = 0;
            gl.GetShaderInfoLog(id_, static_cast<GLsizei>(log.size()), &length, log.data());
            log.resize(static_cast<std::size_t>(length));
            gl.DeleteShader(id_);
            throw failure("the compiler says " + firstLine(source.readable(log)));
        }
    }
    ~Shader() { gl_.DeleteShader(id_); }
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;
    [[nodiscard]] GLuint id() const { return id_; }

  private:
    const Functions& gl_;
    GLuint id_;
};

} // namespace

Program::Program(const Functions& gl, const ProgramSource& vertex, const ProgramSource& fragment)
    : gl_(&gl), program_(gl) {
    const Shader first(gl, GL_VERTEX_SHADER, vertex);
    const Shader second(gl, GL_FRAGMENT_SHADER, fragment);
    gl.AttachShader(program_.id(), first.id());
    gl.AttachShader(program_.id(), second.id());
    gl.LinkProgram(program_.id());
    GLint linked = GL_FALSE;
    gl.GetProgramiv(program_.id(), GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE) {
        std::string log(4096, '\0');
        GLsizei length = 0;
        gl.GetProgramInfoLog(program_.id(), static_cast<GLsizei>(log.size()), &length, log.data());
        log.resize(static_cast<std::size_t>(length));
        throw failure("the linker says " + firstLine(log));
    }
}

void Program::use() const { gl_->UseProgram(program_.id()); }

GLint Program::place(const std::string& name) {
    const auto found = places_.find(name);
    if (found != places_.end()) {
        return found->second;
    }
    return places_[name] = gl_->GetUniformLocation(program_.id(), name.c_str());
}

void Program::set(const std::string& name, float v) { gl_->Uniform1fv(place(name), 1, &v); }
void Program::set(const std::string& name, int v) { gl_->Uniform1iv(place(name), 1, &v); }
void Program::set(const std::string& name, const glm::vec2& v) { gl_->Uniform2fv(place(name), 1, glm::value_ptr(v)); }
void Program::set(const std::string& name, const glm::ivec2& v) { gl_->Uniform2iv(place(name), 1, glm::value_ptr(v)); }
void Program::set(const std::string& name, const glm::vec3& v) { gl_->Uniform3fv(place(name), 1, glm::value_ptr(v)); }
void Program::set(const std::string& name, const glm::ivec3& v) { gl_->Uniform3iv(place(name), 1, glm::value_ptr(v)); }
void Program::set(const std::string& name, const glm::vec4& v) { gl_->Uniform4fv(place(name), 1, glm::value_ptr(v)); }
void Program::set(const std::string& name, const glm::mat3& v) {
    gl_->UniformMatrix3fv(place(name), 1, GL_FALSE, glm::value_ptr(v));
}
void Program::set(const std::string& name, std::span<const float> v) {
    gl_->Uniform1fv(place(name), static_cast<GLsizei>(v.size()), v.data());
}
void Program::set(const std::string& name, std::span<const glm::vec4> v) {
    gl_->Uniform4fv(place(name), static_cast<GLsizei>(v.size()), v.empty() ? nullptr : glm::value_ptr(v.front()));
}

} // namespace limner::gl
