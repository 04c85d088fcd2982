#pragma once

#include "renderer/plan/render_plan.h"

#include <optional>

namespace limner {

/// What one sees at a place of the picture.
struct Pick {
    glm::dvec3 pointMm{0};
    double value = 0;    ///< there, in the data's unit
    double gradient = 0; ///< |gradient| there over the plan's greatest, 0..1
};

/// The first place along the ray through a point of the plan's picture (pixels from the top left corner) where the
/// layers' composed opacity passes one half, halfway into the step that does it; nothing where the picture is more
/// paper than matter. Importance is left aside: it changes what shows, not where the matter is. In double, some
/// tenths of a millisecond; thread-safe.
std::optional<Pick> pickMatter(const RenderPlan& plan, const glm::dvec2& positionPixel);

/// A hand that goes along a structure in the picture, over places where it does not show yet.
struct PickTrail {
    ValueRange wanted;        ///< values that show by now
    double reachMm = 5;       ///< how far from place to place the structure may go to or from the eye
    std::optional<Pick> last; ///< place so far; none: the hand has met nothing
};

/// The next place of the trail, which becomes its last. What is seen there, if it is no farther from the eye or nearer
/// than the reach from the last place; else, within the reach, the place whose value is nearest to the wanted ones,
/// the first of equally near. Nothing where a trail without a last place meets nothing, or the ray misses all. As
/// quick as `pickMatter`; thread-safe for trails of one's own.
std::optional<Pick> followMatter(const RenderPlan& plan, const glm::dvec2& positionPixel, PickTrail& trail);

} // namespace limner
