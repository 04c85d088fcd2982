#pragma once

#include "renderer/backend.h"
#include "renderer/gl/device.h"

namespace limner::gl {

/// What a device keeps from picture to picture.
struct CastingMemory {
    /// Where pictures are drawn: colours, and the state of the rays.
    struct Target {
        Texture colours;
        Texture state;
        Framebuffer framebuffer;
    };
    std::vector<Target> targets;
    Target sums; ///< of the counts
    VertexArray vertices;
    int slice = 256; ///< sub-pixels along an edge that are drawn between two looks at the task
    int loop = -1;   ///< 1: march, then shade; 0: the plain loop; -1: not tried yet
};

/// Draws a tile of a plan, its context being current. Throws Error(cancelled), Error(noOpenGl), Error(noResources).
RenderResult castTile(Device& device, CastingMemory& memory, const RenderPlan& plan, const Tile& tile, Task& task);

} // namespace limner::gl
