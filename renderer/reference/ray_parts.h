#pragma once

#include "renderer/plan/render_plan.h"

#include <cstddef>
#include <vector>

namespace limner::reference {

/// What one layer adds to a pixel at one sample of its ray.
struct RayPart {
    std::size_t layer = 0; ///< of the plan
    long sample = 0;       ///< of the ray's lattice
    glm::dvec3 positionVoxel{0};
    double value = 0;  ///< there, in the data's unit
    double weight = 0; ///< its share of the pixel, above 0
};

/// Of the ray through a point of the plan's picture, front to back, importance counted as in the picture: with the
/// paper's share their weights add up to 1. Nothing where the ray misses all. In double; thread-safe.
std::vector<RayPart> rayParts(const RenderPlan& plan, const glm::dvec2& positionPixel);

} // namespace limner::reference
