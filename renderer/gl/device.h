#pragma once

#include "renderer/gl/context.h"
#include "renderer/gl/names.h"
#include "renderer/gl/program.h"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace limner::gl {

/// A texture's shape and how its texels come.
struct TextureForm {
    GLenum target = GL_TEXTURE_3D;
    GLint inside = GL_R16;
    GLenum format = GL_RED;
    GLenum type = GL_UNSIGNED_SHORT;
    GLint filter = GL_LINEAR; ///< of texels; GL_NEAREST for whole numbers
    glm::ivec3 size{1};
};

/// A context with what has been put on it: programs by their source, and textures of things that figures share. Calls
/// come from one thread at a time, with the context current.
class Device {
  public:
    /// Throws Error(noOpenGl).
    explicit Device(std::unique_ptr<Context> context);
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    [[nodiscard]] const Functions& gl() const { return gl_; }
    [[nodiscard]] const ContextFacts& facts() const { return facts_; }
    /// False: the context is lost, and all that was on it.
    bool makeCurrent();
    void release() { context_->release(); }
    /// Whether the driver has reset the context, or a test has said so (`lose`).
    bool isLost();
    /// Takes the context away, as a driver's reset does.
    void lose();

    /// The linked program of these sources; made once. Throws Error(noOpenGl).
    Program& program(const ProgramSource& vertex, const ProgramSource& fragment);

    /// The texture of something that plans share, made by `upload` (bound, its parameters set) where it is not there
    /// yet. `part`: which of several textures of it. Kept while `source` lives and there is room.
    GLuint texture(const std::shared_ptr<const void>& source, const std::string& part, std::uint64_t bytes,
                   const std::function<void(Texture&)>& upload);
    /// The same of a buffer.
    GLuint buffer(const std::shared_ptr<const void>& source, const std::string& part, std::uint64_t bytes,
                  const std::function<void(Buffer&)>& upload);
    /// Bytes that these may take; what was used longest ago goes first.
    void setRoom(std::uint64_t bytes) { room_ = bytes; }
    [[nodiscard]] std::uint64_t room() const { return room_; }
    [[nodiscard]] std::uint64_t used() const { return used_; }

    /// Makes the last texture unit the active one: no shader reads it, so what is bound there to be filled replaces
    /// nothing.
    void useSpareUnit() const;
    /// A new texture, bound to the spare unit, with its parameters and without texels.
    Texture makeTexture(const TextureForm& form) const;
    /// What the driver has called an error so far, its own words; where it tells them (KHR_debug).
    [[nodiscard]] const std::vector<std::string>& complaints() const { return complaints_; }
    /// Throws Error(noOpenGl) where a call before has failed; `doing` says what it was.
    void check(const char* doing) const;

  private:
    struct Resident {
        std::weak_ptr<const void> source;
        Texture texture; ///< one of the two
        Buffer buffer;
        std::uint64_t bytes = 0;
        std::uint64_t lastUse = 0;
    };
    using Key = std::pair<const void*, std::string>;
    Resident& resident(const std::shared_ptr<const void>& source, const std::string& part, std::uint64_t bytes,
                       const std::function<void(Resident&)>& upload);
    void makeRoom(std::uint64_t bytes);
    void drop(std::map<Key, Resident>::iterator which);

    std::unique_ptr<Context> context_;
    std::vector<std::string> complaints_;
    Functions gl_;
    ContextFacts facts_;
    std::map<std::string, std::unique_ptr<Program>> programs_;
    std::map<Key, Resident> residents_;
    std::uint64_t room_ = 0;
    std::uint64_t used_ = 0;
    std::uint64_t uses_ = 0;
};

} // namespace limner::gl
