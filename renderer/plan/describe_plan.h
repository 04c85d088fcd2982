#pragma once

#include "renderer/plan/planner.h"

namespace limner {

/// Fills in what a plan says about itself: features used and left out, parts not drawn, bytes held.
void describePlan(RenderPlan& plan);

} // namespace limner
