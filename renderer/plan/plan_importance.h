#pragma once

#include "renderer/plan/render_plan.h"

#include <optional>

namespace limner {

/// The importance of a plan's figure, but for the fields it reads and the bricks' bounds; nothing where it is clear
/// without them that every sample and the background matter equally, so that composition is the ordinary one. The plan
/// has its figure, volume, rays and layers.
std::optional<PlanImportance> planImportance(const RenderPlan& plan);

/// Whether nothing that can show matters, by the bricks' bounds, nor the background, and no colour is darkened.
bool mattersNowhere(const PlanImportance& importance, const std::vector<PlanLayer>& layers);

/// Whether a ray's samples can be known to have no importance of their own by what lies ahead of them: not where it
/// goes by what the ray has met.
bool settlesImportance(const RenderPlan& plan);

/// The measures that the axis "importance" of a layer reads, but for their fields; nothing where no layer does. Throws
/// Error(badInput) where the figure weighs nothing.
std::optional<PlanImportance> planAxisMeasures(const RenderPlan& plan);

/// The most that those measures add up to.
double greatestOfPlace(const Importance& importance);

/// The figure's global weight at a place of the picture, in pixels, its lenses counted; 0 for a plan without
/// importance: there the ordinary composition holds.
double globalWeightAt(const RenderPlan& plan, glm::dvec2 place);

/// Whether the samples' importance is measured on gradients.
bool readsNormal(const Importance& importance);
/// Whether labelled objects matter.
bool weighsObjects(const Importance& importance);

} // namespace limner
