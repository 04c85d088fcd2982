#include "core/style/transfer_function.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace limner {
namespace {

/// Where s lies in a rising list: behind `below` points, at `weight` of the way from the last of them to the next.
/// Points at s itself count as below, which makes every step right-continuous.
struct Position {
    std::size_t below = 0;
    double weight = 0;
};

template <typename Points, typename At>
Position positionOf(const Points& points, double s, At at) {
    const auto above =
        std::upper_bound(points.begin(), points.end(), s, [&](double value, const auto& p) { return value < at(p); });
    Position position;
    position.below = static_cast<std::size_t>(above - points.begin());
    if (position.below > 0 && above != points.end()) {
        const double left = at(*(above - 1));
        position.weight = (s - left) / (at(*above) - left);
    }
    return position;
}

/// Plain 8-bit data have at most 255 steps; four entries each are past the 1024 that the specification asks for.
constexpr std::int64_t kEntries8 = 1024;
/// Asked for 16-bit and float data.
constexpr std::int64_t kEntries16 = 4096;
/// Beyond this the two tables leave the second-level cache of small cores (128 KiB), for steps nobody can see.
constexpr std::int64_t kMostEntries = 16384;

/// Number of entries. Where the stored numbers are few enough, a whole number of entries per stored number, so that
/// a curve's knots at data values lie on entries and the table is exact there.
std::int64_t tableSize(const Volume& volume, double low, double high) {
    if (volume.type() == VoxelType::float32) {
        return kMostEntries;
    }
    const std::int64_t least = volume.type() == VoxelType::uint8 ? kEntries8 : kEntries16;
    const double steps = std::round((high - low) / std::abs(volume.contents().slope));
    if (!(steps >= 1 && steps < static_cast<double>(kMostEntries))) {
        return steps >= 1 ? kMostEntries : least;
    }
    const auto n = static_cast<std::int64_t>(steps);
    return n * ((least - 1 + n - 1) / n) + 1;
}

constexpr glm::dvec3 kMidGrey{0.5};

} // namespace

double opacityAt(const std::vector<glm::dvec2>& points, double s) {
    if (points.empty()) {
        return 0;
    }
    const Position p = positionOf(points, s, [](const glm::dvec2& point) { return point.x; });
    if (p.below == 0) {
        return points.front().y;
    }
    const double left = points[p.below - 1].y;
    return p.below == points.size() ? left : left + p.weight * (points[p.below].y - left);
}

double nodeIndexAt(const std::vector<TransferNode>& nodes, double s) {
    const Position p = positionOf(nodes, s, [](const TransferNode& node) { return node.at; });
    return p.below == 0 ? 0 : static_cast<double>(p.below - 1) + p.weight;
}

TransferTable bakeTransfer(const Layer& layer, const Volume& volume, const AxisRanges& /*ranges*/) {
    TransferTable table;
    table.low = volume.range().low;
    table.high = volume.range().high;
    if (!(table.high > table.low)) {
        // A constant volume: any width will do that does not vanish beside the value itself.
        table.high = table.low + std::max(1.0, std::abs(table.low) * 1e-6);
    }
    const std::int64_t size = tableSize(volume, table.low, table.high);
    table.opacity.resize(static_cast<std::size_t>(size));
    table.index.resize(static_cast<std::size_t>(size));
    const double last = static_cast<double>(size - 1);
    const double width = table.high - table.low;
    for (std::int64_t k = 0; k < size; ++k) {
        // Product before quotient: exact at whole data values, so that a step there falls on its own entry. Where
        // the width is huge (float data) the product could overflow, and nothing is exact anyway.
        const double share = static_cast<double>(k);
        const double offset = width < 1e300 ? share * width / last : share / last * width;
        const double s = table.low + offset;
        const double opacity = layer.opacity * opacityAt(layer.transfer.opacity, s);
        table.opacity[static_cast<std::size_t>(k)] = static_cast<float>(std::clamp(opacity, 0.0, 1.0));
        table.index[static_cast<std::size_t>(k)] = static_cast<float>(nodeIndexAt(layer.transfer.nodes, s));
    }
    return table;
}

StyleIndex indexStyles(const Figure& figure, const Transfer& transfer) {
    StyleIndex index;
    const auto positionOfEntry = [&](StyleIndex::Entry entry) {
        const auto same = std::find_if(index.styles.begin(), index.styles.end(), [&](const StyleIndex::Entry& other) {
            return other.sphere == entry.sphere && (entry.sphere != nullptr || other.rgb == entry.rgb);
        });
        if (same != index.styles.end()) {
            return static_cast<int>(same - index.styles.begin());
        }
        index.styles.push_back(std::move(entry));
        return static_cast<int>(index.styles.size()) - 1;
    };
    const auto entryOf = [&](const TransferNode& node) -> StyleIndex::Entry {
        if (node.style.empty()) {
            return {nullptr, node.rgb.value_or(kMidGrey)};
        }
        const StyleEntry* style = figure.findStyle(node.style);
        if (style == nullptr || style->sphere == nullptr) {
            return {nullptr, kMidGrey};
        }
        const Rgba& mean = style->sphere->mean();
        return {style->sphere, glm::dvec3(mean.r, mean.g, mean.b)};
    };
    index.nodeToStyle.reserve(transfer.nodes.size());
    for (const TransferNode& node : transfer.nodes) {
        index.nodeToStyle.push_back(positionOfEntry(entryOf(node)));
    }
    if (transfer.nodes.empty()) {
        index.nodeToStyle.push_back(positionOfEntry({nullptr, kMidGrey}));
    }
    return index;
}

} // namespace limner
