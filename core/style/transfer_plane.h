#pragma once

#include "core/figure/layer.h"

#include <vector>

namespace limner {

/// What evaluating and baking transfer functions share. Internal to core/style.

/// Positions of the nodes along the document's axes; one axis: the second is empty.
struct NodePositions {
    std::vector<double> first;
    std::vector<double> second;
};
NodePositions nodePositions(const Transfer& transfer);

/// What the curve of a transfer over two axes multiplies the shapes with.
double planeCurveAt(const Transfer& transfer, double first);

} // namespace limner
