#pragma once

#include "core/figure/figure.h"

#include <glm/vec3.hpp>

#include <vector>

namespace limner {

/// Exact evaluation of a one-dimensional style transfer function (spec style-transfer-functions.md 2). Double
/// precision; what the reference backend uses and what the tables are baked from.

/// Opacity of the reference length at value s: linear between points, right-continuous at a step, constant outside.
/// No points: 0.
double opacityAt(const std::vector<glm::dvec2>& points, double s);

/// Fractional node index of value s: i in [0, N-1]; right-continuous where two nodes share one value.
double nodeIndexAt(const std::vector<TransferNode>& nodes, double s);

/// `tft` of one layer, baked over [low, high] with `size` entries read by linear interpolation; entry k stands for
/// low + k * (high - low) / (size - 1).
struct TransferTable {
    double low = 0;
    double high = 1;
    std::vector<float> opacity; ///< of the reference length, layer opacity included
    std::vector<float> index;   ///< fractional node index
};

/// Entries: at least 1024 for 8-bit and 4096 for 16-bit and float data, over the volume's used range; where that is
/// not too many, a whole number of entries per stored number. Every entry is the exact function, rounded to float.
TransferTable bakeTransfer(const Layer& layer, const Volume& volume);

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
StyleIndex indexStyles(const Figure& figure, const Transfer& transfer);

} // namespace limner
