#pragma once

#include "core/figure/figure.h"

#include <optional>

namespace limner {

/// Where lenses are on the sheet. "On the sheet": heights of the figure from its top left corner, right and down.

/// Width of the figure over its height.
double sheetAspect(const Figure& figure);
/// A lens' middle on the sheet; nothing where its anchor is behind the eye.
std::optional<glm::dvec2> lensOnSheet(const Figure& figure, const Lens& lens);
/// The lens with its middle elsewhere on the sheet. An anchored one is anchored anew, in the plane of the camera's
/// target.
Lens lensMovedTo(const Figure& figure, Lens lens, const glm::dvec2& place);
/// The lens anchored where it is now, or let go of where it is now.
Lens lensFollowing(const Figure& figure, Lens lens, bool follows);

} // namespace limner
