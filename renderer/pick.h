#pragma once

#include "renderer/plan/render_plan.h"

#include <optional>

namespace limner {

/// What one sees at a place of the picture.
struct Pick {
    glm::dvec3 pointMm{0};
    double value = 0; ///< there, in the data's unit
};

/// The first place along the ray through a point of the plan's picture (pixels from the top left corner) where the
/// layers' composed opacity passes one half, halfway into the step that does it; nothing where the picture is more
/// paper than matter. Importance is left aside: it changes what shows, not where the matter is. In double, some
/// tenths of a millisecond; thread-safe.
std::optional<Pick> pickMatter(const RenderPlan& plan, const glm::dvec2& positionPixel);

} // namespace limner
