#pragma once

#include "core/figure/figure_json.h"

#include <string>
#include <vector>

namespace limner {

/// Sense checks of a transfer function's axes and shapes. Internal to core/figure; `pointer` is the transfer's.

/// Axes that exist, differ, and have what they measure by.
void checkTransferAxes(const Figure& figure, const Transfer& transfer, const std::string& pointer,
                       std::vector<Problem>& problems);

/// Corners, opacities and masks of all shapes of a transfer function over two axes, and whether anything limits it.
void checkOpacityShapes(const Transfer& transfer, const std::string& pointer, std::vector<Problem>& problems);

} // namespace limner
