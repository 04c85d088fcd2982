#pragma once

#include "renderer/gl/functions.h"

#include <utility>

namespace limner::gl {

/// Move-only owners of OpenGL's names. Made and destroyed while their context is current; after a context's loss they
/// let go of nothing. The functions must outlive them.

template <typename Kind>
class Name {
  public:
    Name() = default;
    explicit Name(const Functions& gl) : gl_(&gl), id_(Kind::make(gl)) {}
    Name(Name&& other) noexcept : gl_(other.gl_), id_(std::exchange(other.id_, 0)) {}
    Name& operator=(Name&& other) noexcept {
        if (this != &other) {
            reset();
            gl_ = other.gl_;
            id_ = std::exchange(other.id_, 0);
        }
        return *this;
    }
    Name(const Name&) = delete;
    Name& operator=(const Name&) = delete;
    ~Name() { reset(); }

    void reset() {
        if (id_ != 0 && !gl_->lost) {
            Kind::remove(*gl_, id_);
        }
        id_ = 0;
    }
    [[nodiscard]] GLuint id() const { return id_; }
    explicit operator bool() const { return id_ != 0; }

  private:
    const Functions* gl_ = nullptr;
    GLuint id_ = 0;
};

#define LIMNER_GL_KIND(kind, gen, del)                                                                                 \
    struct kind##Kind {                                                                                                \
        static GLuint make(const Functions& gl) {                                                                      \
            GLuint id = 0;                                                                                             \
            gl.gen(1, &id);                                                                                            \
            return id;                                                                                                 \
        }                                                                                                              \
        static void remove(const Functions& gl, GLuint id) { gl.del(1, &id); }                                         \
    };                                                                                                                 \
    using kind = Name<kind##Kind>;
LIMNER_GL_KIND(Texture, GenTextures, DeleteTextures)
LIMNER_GL_KIND(Buffer, GenBuffers, DeleteBuffers)
LIMNER_GL_KIND(Framebuffer, GenFramebuffers, DeleteFramebuffers)
LIMNER_GL_KIND(VertexArray, GenVertexArrays, DeleteVertexArrays)
#undef LIMNER_GL_KIND

struct ProgramKind {
    static GLuint make(const Functions& gl) { return gl.CreateProgram(); }
    static void remove(const Functions& gl, GLuint id) { gl.DeleteProgram(id); }
};
using ProgramName = Name<ProgramKind>;

} // namespace limner::gl
