#pragma once

#include "renderer/gl/context.h"

namespace limner {

/// OpenGL contexts by Qt, without a window: for systems where neither EGL nor OSMesa is. To be called on the
/// interface's thread, where the surface has to be made; the factory and its contexts may be used on any.
gl::ContextFactory qtContexts();

} // namespace limner
