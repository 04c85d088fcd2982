#pragma once

#include "core/figure/figure.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace limner {

/// A camera's axes in physical space (LPS, mm) and its map to figure coordinates: (0, 0) top left, (1, 1) bottom right.
struct ViewFrame {
    glm::dvec3 right{1, 0, 0};
    glm::dvec3 up{0, 0, 1};
    glm::dvec3 forward{0, 1, 0}; ///< the way the viewer looks
    glm::dvec3 targetMm{0};
    double heightMm = 1;
    double widthMm = 1;
    double eyeDistanceMm = 0; ///< from the eye to the target; 0: orthographic

    /// `aspect`: width / height of the figure. Throws Error(badInput) where direction and up do not span a view.
    ViewFrame(const Camera& camera, double aspect);

    /// Homogeneous figure coordinates: (x w, y w, w). w > 0 in front of the eye; always 1 in orthographic views.
    [[nodiscard]] glm::dvec3 project(const glm::dvec3& pointMm) const;
    /// The linear part of `project`: how its result changes with a step in mm.
    [[nodiscard]] glm::dvec3 projectStep(const glm::dvec3& stepMm) const;
};

} // namespace limner
