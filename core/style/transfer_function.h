#pragma once

#include "core/figure/figure.h"

#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <vector>

namespace limner {

/// Exact evaluation of style transfer functions (spec style-transfer-functions.md 2 and 3). Double
/// precision; what the reference backend uses and what the tables are baked from.

/// Opacity of the reference length at value s: right-continuous at a step, constant outside. No points: 0. Between
/// points linear, or the last point's (step), or a monotone cubic (smooth; Fritsch and Carlson 1980, slopes by Fritsch
/// and Butland 1984): never outside the two points' opacities, level at peaks, at both ends and beside a step.
double opacityAt(const std::vector<glm::dvec2>& points, double s, OpacityCurve curve = OpacityCurve::linear);
/// The same for a transfer's own curve.
double curveOpacityAt(const Transfer& transfer, double s);

/// Fractional node index of value s: i in [0, N-1]; right-continuous where two nodes share one value.
double nodeIndexAt(const std::vector<TransferNode>& nodes, double s);

/// What an axis of a transfer function measures.
enum class TransferAxis { value, gradient, label, distance, importance, curvature, second };

/// The axis of that name; names are those of the figure document. An unknown name is `value` (validation refuses it).
TransferAxis transferAxis(const std::string& name);

/// The transfer's first axis, and its second where it has two dimensions. A two-dimensional transfer that does not name
/// two axes counts as one-dimensional (validation refuses it).
TransferAxis firstAxis(const Transfer& transfer);
std::optional<TransferAxis> secondAxis(const Transfer& transfer);

/// Opacity of the reference length over two axes, x along the document's first and y along its second: the greatest of
/// the shapes at (x, y), 1 where there are none, times the curve at x, 1 where there is none. One-dimensional
/// transfers: the curve at x alone, y is ignored. On a label axis a position is a label number. A label without a node
/// position of its own counts as -1, and is invisible where -1 has none either. Shapes are closed: their border is
/// inside. Polygons that cross themselves are filled even-odd. `soft`: the share rises from 0 at the border to 1 at
/// `soft` of half the extent inside, per axis and multiplied (rectangle), along the radius (ellipse), or by the
/// distance to the nearest edge where the bounding box counts -1..1 both ways (polygon). Masks are bilinear between the
/// centres of their cells, constant from there to the box, 0 outside it.
double opacity2dAt(const Transfer& transfer, double x, double y);

/// Column or row of a node grid for a position: fractional, right-continuous at a step, constant outside, 0 without
/// positions. On a label axis a whole number: the position that rounds to the label, or else the one at -1, or else -1:
/// no row holds for the label.
double gridIndexAt(const std::vector<double>& positions, double at, bool categorical);

/// `tft` of one layer, baked over [low, high] of the axis X with `size` entries read by linear interpolation; entry k
/// stands for low + k * (high - low) / (size - 1).
/// X is never the label axis, and it is the data value where one of the axes is: roles are exchanged against the
/// document where they must be. A one-dimensional transfer over labels is a plane too: X is the value, along which
/// nothing changes (two entries, one column of nodes), and Y the label.
struct TransferTable {
    double low = 0;
    double high = 1;
    std::vector<float> opacity; ///< of the reference length, layer opacity included; two axes: the greatest of all rows
    std::vector<float> index;   ///< fractional node index along X
    /// Fractional entry of each node along X: between two of them the index is linear. Empty where it is not, by levels
    /// that a volume keeps unevenly.
    std::vector<double> nodeEntries;
    TransferAxis axisX = TransferAxis::value;

    /// Two axes only; row r stands for lowY + r * (highY - lowY) / (rows - 1), or for `labels[r]`.
    int rows = 0; ///< 0: one axis
    TransferAxis axisY = TransferAxis::value;
    double lowY = 0;
    double highY = 1;
    /// Y is the label axis: the label of each row. Row 0 is always -1, all labels without a row of their own (opacity 0
    /// where the document has no position for them), the others follow by rising number. Read with the nearest row.
    std::vector<int> labels;
    std::vector<float> rowIndex;  ///< fractional node index along Y of every row
    std::vector<double> nodeRows; ///< as `nodeEntries`; not over labels
    std::vector<float> opacity2d; ///< rows * opacity.size(), row after row, layer opacity included

    /// Node (ix, iy), counted along X and Y, has style `nodeToStyle[ix * nodeStrideX + iy * nodeStrideY]` of
    /// StyleIndex.
    int nodesX = 1;
    int nodesY = 1;
    int nodeStrideX = 1;
    int nodeStrideY = 1;
};

/// Ranges that tables have to cover, beside the volume's own.
struct AxisRanges {
    ValueRange second{0, 1};    ///< of the second volume
    ValueRange distance{0, 1};  ///< mm
    ValueRange curvature{0, 1}; ///< 1/mm
    ValueRange importance{0, 1};
};

/// One dimension: over the value at least 1024 entries for 8-bit and 4096 for 16-bit and float data, over the volume's
/// used range; where that is not too many, a whole number of entries per stored number. Over another axis 4096.
/// Two dimensions: over the value at most 2048 entries, where there are fewer stored numbers a whole number of entries
/// for each; over another axis 1024; 256 rows, or one per label. Every entry is the exact function, rounded to float.
/// The gradient ranges over [0, 1]. `entries` above 0: so many along X instead (two dimensions: at most, and labels are
/// left alone); what is narrower than an entry may then be lost. Parallel and thread-safe.
TransferTable bakeTransfer(const Layer& layer, const Volume& volume, const AxisRanges& ranges = {}, int entries = 0);

/// `ift`: node -> position in the list of distinct styles. Nodes with a plain colour get a style of their own (a
/// constant sphere), equal colours one and the same.
struct StyleIndex {
    struct Entry {
        std::shared_ptr<const LitSphere> sphere;  ///< null: plain colour
        glm::dvec3 rgb{0};                        ///< the colour, or the sphere's mean
        std::optional<StyleTexture> texture = {}; ///< resolved, with some strength; else absent
    };
    std::vector<int> nodeToStyle;
    std::vector<Entry> styles;
};

/// A node whose style id is unknown or not resolved counts as mid grey, and so does a transfer without nodes (which
/// then has one entry for the index 0 that `nodeIndexAt` gives). A node's style goes before its colour.
/// A grid's nodes are counted row by row of the document: `nodeToStyle[row * columns + column]`; cells "#rrggbb" are
/// plain colours, missing ones mid grey.
StyleIndex indexStyles(const Figure& figure, const Transfer& transfer);

} // namespace limner
