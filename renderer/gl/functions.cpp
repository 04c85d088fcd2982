#include "renderer/gl/functions.h"

#include "core/base/error.h"

namespace limner::gl {

Functions loadFunctions(const FindFunction& find) {
    Functions gl;
#define LIMNER_GL_FIND(type, name)                                                                                     \
    gl.name = reinterpret_cast<type>(find("gl" #name));                                                                \
    if (gl.name == nullptr) {                                                                                          \
        throw Error(ErrorKind::noOpenGl, {"OpenGL 4.1 cannot be used", "", "its library has no gl" #name,              \
                                          "update the graphics driver, or render with the backend cpu"});              \
    }
    LIMNER_GL_FUNCTIONS(LIMNER_GL_FIND)
#undef LIMNER_GL_FIND
    gl.DebugMessageCallback = reinterpret_cast<PFNGLDEBUGMESSAGECALLBACKPROC>(find("glDebugMessageCallback"));
    gl.GetGraphicsResetStatus =
        reinterpret_cast<PFNGLGETGRAPHICSRESETSTATUSARBPROC>(find("glGetGraphicsResetStatusARB"));
    return gl;
}

} // namespace limner::gl
