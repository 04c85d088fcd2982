#pragma once

#include "renderer/plan/render_plan.h"

namespace limner {

/// Rays of a camera over a picture of `size` pixels. The picture's height shows `heightMm` of the target plane; its
/// width follows the pixels, which are square. Throws Error(badInput) for a camera that sees nothing: zero direction,
/// `up` along the direction, height or field of view out of range.
RayFrame makeRayFrame(const Camera& camera, const Volume& volume, glm::ivec2 size);

} // namespace limner
