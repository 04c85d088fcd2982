#pragma once

#include "core/figure/figure.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace limner {

/// Changes of the shapes of a two-dimensional transfer function as functions from value to value: what its editor is
/// made of. Positions are (first axis, second axis) in the axes' units. Indices must exist.

/// A part of the plane.
struct PlaneBox {
    glm::dvec2 low{0};
    glm::dvec2 high{0};
    friend bool operator==(const PlaneBox&, const PlaneBox&) = default;
};

PlaneBox boxOf(const OpacityShape& shape);

/// A shape that fills the box: a trapezoid with a third of the box for each ramp along the first axis, a polygon of
/// four points on the box's edges, an empty mask of 64 x 64 cells. `kind` is the document's word.
OpacityShape freshShape(const std::string& kind, const PlaneBox& box);

/// A plane that shows nothing for want of shapes has a curve of one clear point: without either all would be opaque.
/// The first shape takes that curve's place.
Transfer withShapeAdded(Transfer plane, const OpacityShape& shape);
Transfer withShapeRemoved(Transfer plane, std::size_t shape);

/// Something of a shape that can be dragged: which of its numbers follow. -1: none on that axis.
struct ShapeHandle {
    glm::dvec2 at{0};
    int x = -1; ///< index into `OpacityShape::x`
    int y = -1;
};
/// Corners and middles of the sides of boxes, ends of the ramps of trapezoids, points of polygons. Their order and
/// number depend on the kind (and a polygon's points) alone.
std::vector<ShapeHandle> handlesOf(const OpacityShape& shape);

OpacityShape withShapeMoved(OpacityShape shape, const glm::dvec2& by);
/// The handle goes to `to`; numbers that must rise are held between their neighbours.
OpacityShape withHandleMoved(OpacityShape shape, std::size_t handle, const glm::dvec2& to);

/// Polygons: a new point where `at` is nearest to an edge, both axes measured in `scale`; its index is the result's.
struct AddedCorner {
    OpacityShape shape;
    std::size_t index = 0;
};
AddedCorner withCornerAdded(const OpacityShape& polygon, const glm::dvec2& at, const glm::dvec2& scale);
/// Leaves a triangle as it is.
OpacityShape withCornerRemoved(OpacityShape polygon, std::size_t index);

/// A round brush on a mask.
struct MaskStroke {
    glm::dvec2 at{0};
    glm::dvec2 radius{1}; ///< in the axes' units
    double towards = 1;   ///< what the middle of the brush paints: 1 paint, 0 erase
    double softness = 0;  ///< share of the radius over which the brush fades
};
/// Paints what is below `towards` up to it, or above it down to it; the brush's edge leaves what is more.
OpacityShape withMaskPainted(OpacityShape mask, const MaskStroke& stroke);

/// Membership of a position in one shape, its opacity left out.
double membershipAt(const OpacityShape& shape, const glm::dvec2& at);

/// The shape's box reaches out so far that what is inside the soft border holds the position; opacity at the position
/// is then the shape's own for rectangles and trapezoids, and above 0 for the other kinds.
OpacityShape withShapeGrown(OpacityShape shape, const glm::dvec2& to);

/// A grid of styles. What stands in a cell, counted row by row, with its column's position; empty where there is none.
TransferNode nodeOfCell(const TransferGrid& grid, std::size_t cell);
TransferGrid withColumnAdded(TransferGrid grid, double at);
TransferGrid withRowAdded(TransferGrid grid, double at);
/// The last column or row stays.
TransferGrid withColumnRemoved(TransferGrid grid, std::size_t column);
TransferGrid withRowRemoved(TransferGrid grid, std::size_t row);
/// Held between the neighbours.
TransferGrid withColumnMoved(TransferGrid grid, std::size_t column, double at);
TransferGrid withRowMoved(TransferGrid grid, std::size_t row, double at);

} // namespace limner
