#pragma once

#include "renderer/plan/render_plan.h"

#include <glm/vec4.hpp>

namespace limner::reference {

/// What the picture would be without a step size (spec accuracy.md 1.4).
struct ExactRay {
    glm::dvec4 rgba{0};    ///< premultiplied
    double errorBar = 0;   ///< largest change of a piece at the last doubling, summed over the pieces
    bool converged = true; ///< false: a piece still changed by more than the tolerance when halving stopped
};

/// The volume rendering integral of the trilinear field along the ray through a point of the picture, for plans whose
/// layers are unshaded (PlanLayer::shading == flat). The ray is split at cell faces, where the field changes its cubic,
/// and at that cubic's roots, where the transfer function has knots; each piece is integrated by nested Gauss-Legendre
/// rules, doubled until nothing moves. Several layers: extinctions add, as sample-by-sample composition does in the
/// limit of small steps. Throws Error(usage) for a layer whose colour or opacity
/// depends on more than the value.
ExactRay integrateExactly(const RenderPlan& plan, const glm::dvec2& positionPixel);

} // namespace limner::reference
