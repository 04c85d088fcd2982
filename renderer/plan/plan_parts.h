#pragma once

#include "renderer/plan/plan_layer.h"

namespace limner {

/// The parts of a layer that change what its transfer function gives; nothing where none does. The layer's shading must
/// be known to the source: Phong's highlight is Phong's.
std::optional<PlanParts> planParts(const Layer& source, const LayerSurroundings& around);

/// Whether the opacity of a sample depends on the parts.
bool changesOpacity(const PlanParts& parts);

/// The most that the parts make of an opacity.
double greatestOpacity(const PlanParts& parts, double opacity);

std::optional<PlanFocus> planFocus(const Layer& source, const LayerSurroundings& around);

/// Whether a clip has a box or planes.
bool cutsAnything(const Clip& clip);

/// A clip's box and planes; the colour of a face is its style's at the plane's normal, which is the same all over the
/// plane but for the perspective.
PlanCut planCut(const Clip& clip, const Figure& figure, const RayFrame& rays);

/// Share of a cut's kept side, 0 to 1, for a stretch of `lengthMm` along `directionMm` whose middle is at `p` (mm); by
/// the plane that leaves least.
double keptShare(const PlanCut& cut, const glm::dvec3& p, const glm::dvec3& directionMm, double lengthMm);

} // namespace limner
