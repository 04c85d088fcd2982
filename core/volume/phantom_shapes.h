#pragma once

#include <glm/vec3.hpp>

#include <functional>
#include <vector>

namespace limner::phantom {

/// The built-in head's anatomy as painted shapes (LPS, mm, the head's middle at the origin, the face towards -y).
using Vec = glm::vec3;

/// A tissue of a shape, from `insetMm` below the shape's surface inwards.
struct Layer {
    float insetMm = 0;
    float hu = 0;
};

/// A shape laid over what was painted before it.
struct Paint {
    Vec middle{0};                             ///< of the box that holds it
    Vec half{0};                               ///< half the box's sides
    std::vector<Layer> layers;                 ///< from the surface inwards
    std::function<float(const Vec&)> distance; ///< to the surface in mm, negative inside; an estimate
};

/// The half with x >= 0, in order of painting; the other half is its mirror image.
std::vector<Paint> headPaints();

} // namespace limner::phantom
