#pragma once

#include "core/figure/figure.h"

#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <vector>

namespace limner {

/// Exact evaluation of style transfer functions (spec style-transfer-functions.md 2 and 3). Double
/// precision; what the reference backend uses and what the tables are baked from.

/// Opacity of the reference length at value s: linear between points, right-continuous at a step, constant outside.
/// No points: 0.
double opacityAt(const std::vector<glm::dvec2>& points, double s);

/// Fractional node index of value s: i in [0, N-1]; right-continuous where two nodes share one value.
double nodeIndexAt(const std::vector<TransferNode>& nodes, double s);

/// What an axis of a transfer function measures.
enum class TransferAxis { value, gradient, label, distance, importance, curvature, second };

/// The axis of that name; names are those of the figure document. An unknown name is `value` (validation refuses it).
TransferAxis transferAxis(const std::string& name);

/// The transfer's first axis, and its second where it has two dimensions.
TransferAxis firstAxis(const Transfer& transfer);
std::optional<TransferAxis> secondAxis(const Transfer& transfer);

/// Opacity of the reference length over two axes: the greatest of the shapes at (x, y), 1 where there are none, times
/// the curve at x, 1 where there is none. On a label axis a position is a label number.
double opacity2dAt(const Transfer& transfer, double x, double y);

/// Column or row of a node grid for a position; on a label axis -1 where no row holds for the label.
double gridIndexAt(const std::vector<double>& positions, double at, bool categorical);

/// `tft` of one layer, baked over [low, high] with `size` entries read by linear interpolation; entry k stands for
/// low + k * (high - low) / (size - 1).
struct TransferTable {
    double low = 0;
    double high = 1;
    std::vector<float> opacity; ///< of the reference length, layer opacity included; 2D: the greatest over all rows
    std::vector<float> index;   ///< fractional node index (2D: column)

    /// Two-dimensional transfers only; row r stands for lowY + r * (highY - lowY) / (rows - 1), or for `labels[r]`.
    int rows = 0;
    double lowY = 0;
    double highY = 1;
    std::vector<int> labels;      ///< categorical second axis: label of each row, -1: all others
    std::vector<float> rowIndex;  ///< fractional node row of every row
    std::vector<float> opacity2d; ///< rows * opacity.size(), row after row, layer opacity included
};

/// Ranges that tables have to cover, beside the volume's own.
struct AxisRanges {
    ValueRange second{0, 1};    ///< of the second volume
    ValueRange distance{0, 1};  ///< mm
    ValueRange curvature{0, 1}; ///< 1/mm
};

/// One dimension over the value: at least 1024 entries for 8-bit and 4096 for 16-bit and float data, over the volume's
/// used range; where that is not too many, a whole number of entries per stored number. Two dimensions: at most 2048
/// entries and 256 rows (the data's own steps where there are fewer; a row per label). Every entry is the exact
/// function, rounded to float.
TransferTable bakeTransfer(const Layer& layer, const Volume& volume, const AxisRanges& ranges = {});

/// `ift`: node -> position in the list of distinct styles. Nodes with a plain colour get a style of their own (a
/// constant sphere), equal colours one and the same.
struct StyleIndex {
    struct Entry {
        std::shared_ptr<const LitSphere> sphere; ///< null: plain colour
        glm::dvec3 rgb{0};                       ///< the colour, or the sphere's mean
    };
    std::vector<int> nodeToStyle;
    std::vector<Entry> styles;
};

/// A node whose style id is unknown or not resolved counts as mid grey, and so does a transfer without nodes (which
/// then has one entry for the index 0 that `nodeIndexAt` gives). A node's style goes before its colour.
/// A grid's nodes are counted row by row: `nodeToStyle[row * columns + column]`; its cells that begin with '#' are
/// plain colours.
StyleIndex indexStyles(const Figure& figure, const Transfer& transfer);

} // namespace limner
