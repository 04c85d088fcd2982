#pragma once

#include "core/base/task.h"
#include "core/figure/shape_edits.h"
#include "core/style/transfer_function.h"
#include "core/volume/joint_histogram.h"

#include <glm/vec2.hpp>

#include <optional>
#include <vector>

namespace limner {

/// What editors of transfer functions show: the part of each axis that matters, how the scan's voxels lie in the plane
/// of two axes, and the opacity over it.

/// Where the figure's data lie on an axis, in its unit; 0..1 where nothing says it. For labels from -1, which stands
/// for all without a place of their own, to the greatest.
ValueRange shownRange(const Figure& figure, const Transfer& transfer, TransferAxis axis);

/// Of the two axes of a transfer; one axis: the second is 0..1.
PlaneBox shownPlane(const Figure& figure, const Transfer& transfer);

/// Whether the axis can be read in the figure: label and second need their volumes, importance its measures.
bool axisThere(const Figure& figure, TransferAxis axis);

/// Counts of the scan's voxels in the plane of a two-dimensional transfer's axes, 256 bins each (one for each label up
/// to 255). Nothing where neither axis is the value, for what depends on the view or on other measures (curvature,
/// importance), and for missing fields. Takes seconds at worst; throws Error(cancelled).
std::optional<JointHistogram> planeHistogram(const Figure& figure, const Transfer& transfer, Task& task);

/// The transfer along other axes: everything it has on the changed one is stretched from where the data lay on the old
/// to where they lie on the new one. A label axis keeps one row or node, for all labels, and shows all. `place`: 0 for
/// the first axis, 1 for the second of a plane. The distance is measured from the middle of the picture where nothing
/// else is said. If the plane's other axis has that name, the two change places.
Transfer withAxis(const Figure& figure, Transfer transfer, std::size_t place, const std::string& name);

/// Opacity of a two-dimensional transfer at the middles of `pixels` cells of a part of the plane, rows from the top.
std::vector<float> planeOpacity(const Transfer& transfer, const PlaneBox& part, glm::ivec2 pixels);

} // namespace limner
