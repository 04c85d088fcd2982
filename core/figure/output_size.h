#pragma once

#include "core/figure/figure.h"

#include <optional>

namespace limner {

/// A wished size of the picture; what is not given stays.
struct SizeRequest {
    std::optional<glm::ivec2> pixels; ///< width and height; excludes the two lengths
    std::optional<double> widthMm;
    std::optional<double> heightMm;
    std::optional<double> dpi;
};

/// The output of that size. Pixels at the dpi make the lengths; one length alone keeps the shape; dpi alone keeps the
/// lengths. Throws Error(usage) for sizes that make no sense: not finite, not positive, over a million pixels an edge.
Output resized(const Output& output, const SizeRequest& request);

/// A camera that was fitted to a square picture, for one of that shape: a picture higher than wide sees more height,
/// so that nothing is cut off at the sides.
Camera fittedTo(const Output& output, const Camera& camera);

} // namespace limner
