#pragma once

#include "core/figure/figure.h"

#include <functional>
#include <optional>

namespace limner {

/// Which voxels a view must hold.
struct Shows {
    std::function<int(double value)> value;                  ///< 1 where a value is drawn, else 0; empty: the whole box
    std::function<bool(const glm::dvec3& positionMm)> place; ///< false where it is clipped away; empty: nowhere
};

/// The camera with target and height set so that all that shows fits into a square figure with a little paper around.
Camera fittedCamera(const Volume& volume, Camera camera, const Shows& shows);

/// Box in physical space of what shows; nothing where nothing does.
std::optional<BoxMm> boxOfMatter(const Volume& volume, const Shows& shows);

} // namespace limner
