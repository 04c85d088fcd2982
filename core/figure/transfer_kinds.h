#pragma once

#include "core/figure/shape_edits.h"

#include <string>

namespace limner {

/// A layer's transfer function with one axis as one with two, and back; and the widening of what it shows.

/// The same picture over the line's axis and `second`: bumps of the curve become trapezoids over all of the plane's
/// second axis, nodes a row of the grid. A curve that no trapezoids make (smooth, stepped, of several heights) stays
/// one, over a rectangle that fills `plane`, which is what the axes are shown over.
Transfer withTwoAxes(const Transfer& line, const std::string& second, const PlaneBox& plane);

/// The greatest opacity over the second axis as a curve along the first, exact for what `withTwoAxes` makes, otherwise
/// to half a percent; of the styles the grid's middle row.
Transfer withOneAxis(const Transfer& plane, const PlaneBox& shown);

/// The opacity of a line reaches out so that it shows `value`: the flank of the nearest bump moves out as a whole, its
/// inner point onto the value (of two flanks equally near the lower one). What shows the value at half of that bump's
/// opacity or more already stays as it is, and so does a curve without opacity.
Transfer withValueShown(Transfer line, double value);

/// The nearest shape grows to hold a place of the plane; one that holds it stays. Without shapes nothing changes.
/// Both axes are measured in `scale`.
Transfer withPlaceShown(Transfer plane, const glm::dvec2& at, const glm::dvec2& scale);

} // namespace limner
