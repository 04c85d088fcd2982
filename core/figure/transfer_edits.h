#pragma once

#include "core/figure/figure.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace limner {

struct Style;

/// Changes of a one-dimensional transfer function as functions from value to value: what editors are made of. Indices
/// must exist. Orders are kept: points and nodes rise, two points at one value are a step.

using OpacityPoints = std::vector<glm::dvec2>; ///< (value, opacity)

/// The point goes to `to`, held between its neighbours' values and in 0..1.
OpacityPoints withPointMoved(OpacityPoints points, std::size_t index, glm::dvec2 to);
/// All points go sideways by the same amount.
OpacityPoints withPointsShifted(OpacityPoints points, double by);

struct AddedPoint {
    OpacityPoints points;
    std::size_t index = 0; ///< of the new point
};
/// A new point where its value belongs; after equal values.
AddedPoint withPointAdded(const OpacityPoints& points, glm::dvec2 point);
OpacityPoints withPointRemoved(OpacityPoints points, std::size_t index);
/// The curve stays at the previous point's opacity (0 at the first) up to this point's value and jumps there. A point
/// that is a step already stays as it is.
OpacityPoints withStepAt(OpacityPoints points, std::size_t index);

using TransferNodes = std::vector<TransferNode>;

/// The node goes to `at`, held between its neighbours.
TransferNodes withNodeMoved(TransferNodes nodes, std::size_t index, double at);
/// Index of the node to insert before, for a new node at that value.
std::size_t nodePlace(const TransferNodes& nodes, double at);

/// A grid of one empty cell that holds for the whole plane, on label axes for all labels.
TransferGrid wholePlane(const Transfer& transfer);

/// Puts a style onto one node of a layer, or onto all of them: the style joins the figure's list (`joinStyle`), the
/// layer is shaded by styles from now on, and styles that nothing uses any more leave the list (`dropUnusedStyles`). A
/// layer without nodes gets one in the middle of its opacity points. Nodes of a grid are its cells, counted row by row.
Figure withStyle(const Figure& figure, std::size_t layer, std::optional<std::size_t> node, const Style& style);
/// A new node with the style at that value.
Figure withStyleNode(const Figure& figure, std::size_t layer, double at, const Style& style);

} // namespace limner
