#include "core/style/transfer_function.h"

#include "core/figure/quantity.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

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
        const double share = (s - left) / (at(*above) - left);
        position.weight = share > 0 ? std::min(share, 1.0) : 0; // points out of order, which validation refuses
    }
    return position;
}

/// Slope of the smooth curve at a point: the weighted harmonic mean of the slopes on both sides, 0 where they part in
/// sign, where there is only one, and beside a step. It is at most three times the smaller one, whatever the distances:
/// what keeps a cubic monotone.
double smoothSlope(const std::vector<glm::dvec2>& points, std::size_t k) {
    if (k == 0 || k + 1 == points.size()) {
        return 0;
    }
    const glm::dvec2 before = points[k] - points[k - 1];
    const glm::dvec2 after = points[k + 1] - points[k];
    if (!(before.x > 0 && after.x > 0 && before.y * after.y > 0)) {
        return 0;
    }
    const double weightBefore = 2 * after.x + before.x;
    const double weightAfter = after.x + 2 * before.x;
    return (weightBefore + weightAfter) / (weightBefore * before.x / before.y + weightAfter * after.x / after.y);
}

/// The Hermite cubic between the points around `p`.
double smoothBetween(const std::vector<glm::dvec2>& points, const Position& p) {
    const glm::dvec2 left = points[p.below - 1];
    const glm::dvec2 right = points[p.below];
    const double width = right.x - left.x;
    const double t = p.weight;
    const double u = 1 - t;
    const double opacity = u * u * (1 + 2 * t) * left.y + t * t * (1 + 2 * u) * right.y +
                           width * t * u * (u * smoothSlope(points, p.below - 1) - t * smoothSlope(points, p.below));
    return std::clamp(opacity, std::min(left.y, right.y), std::max(left.y, right.y)); // rounding alone would pass them
}

constexpr glm::dvec3 kMidGrey{0.5};

using Entry = StyleIndex::Entry;

/// The style of that id; mid grey where it is unknown or not resolved.
Entry styleEntry(const Figure& figure, const std::string& id) {
    const StyleEntry* style = figure.findStyle(id);
    if (style == nullptr || style->sphere == nullptr) {
        return {nullptr, kMidGrey};
    }
    const Rgba& mean = style->sphere->mean();
    const bool textured = style->texture && style->texture->tile && style->texture->strength > 0;
    return {style->sphere, glm::dvec3(mean.r, mean.g, mean.b), textured ? style->texture : std::nullopt};
}

std::vector<Entry> entriesOfNodes(const Figure& figure, const std::vector<TransferNode>& nodes) {
    std::vector<Entry> entries;
    for (const TransferNode& node : nodes) {
        entries.push_back(node.style.empty() ? Entry{nullptr, node.rgb.value_or(kMidGrey)}
                                             : styleEntry(figure, node.style));
    }
    return entries;
}

std::vector<Entry> entriesOfGrid(const Figure& figure, const TransferGrid& grid) {
    std::vector<Entry> entries;
    for (std::size_t y = 0; y < grid.y.size(); ++y) {
        for (std::size_t x = 0; x < grid.x.size(); ++x) {
            const bool present = y < grid.styles.size() && x < grid.styles[y].size();
            const std::string cell = present ? grid.styles[y][x] : "";
            const auto colour = plainColour(cell);
            entries.push_back(colour ? Entry{nullptr, *colour} : styleEntry(figure, cell));
        }
    }
    return entries;
}

} // namespace

double opacityAt(const std::vector<glm::dvec2>& points, double s, OpacityCurve curve) {
    if (points.empty()) {
        return 0;
    }
    const Position p = positionOf(points, s, [](const glm::dvec2& point) { return point.x; });
    if (p.below == 0) {
        return points.front().y;
    }
    const double left = points[p.below - 1].y;
    if (p.below == points.size() || curve == OpacityCurve::step) {
        return left;
    }
    if (curve == OpacityCurve::smooth) {
        return smoothBetween(points, p);
    }
    return left + p.weight * (points[p.below].y - left);
}

double curveOpacityAt(const Transfer& transfer, double s) { return opacityAt(transfer.opacity, s, transfer.curve); }

double nodeIndexAt(const std::vector<TransferNode>& nodes, double s) {
    const Position p = positionOf(nodes, s, [](const TransferNode& node) { return node.at; });
    return p.below == 0 ? 0 : static_cast<double>(p.below - 1) + p.weight;
}

double gridIndexAt(const std::vector<double>& positions, double at, bool categorical) {
    if (categorical) {
        const auto columnOf = [&](double label) {
            const auto holds = [label](double position) { return std::round(position) == label; };
            return std::find_if(positions.begin(), positions.end(), holds);
        };
        const auto own = columnOf(std::round(at));
        const auto held = own != positions.end() ? own : columnOf(-1);
        return held != positions.end() ? static_cast<double>(held - positions.begin()) : -1;
    }
    const Position p = positionOf(positions, at, [](double position) { return position; });
    return p.below == 0 ? 0 : static_cast<double>(p.below - 1) + p.weight;
}

StyleIndex indexStyles(const Figure& figure, const Transfer& transfer) {
    std::vector<Entry> entries;
    if (!secondAxis(transfer)) {
        entries = entriesOfNodes(figure, transfer.nodes);
    } else if (transfer.grid) {
        entries = entriesOfGrid(figure, *transfer.grid);
    }
    if (entries.empty()) {
        entries.push_back({nullptr, kMidGrey});
    }
    StyleIndex index;
    index.nodeToStyle.reserve(entries.size());
    for (Entry& entry : entries) {
        const auto same = std::find_if(index.styles.begin(), index.styles.end(), [&](const Entry& other) {
            return other.sphere == entry.sphere && other.texture == entry.texture &&
                   (entry.sphere != nullptr || other.rgb == entry.rgb);
        });
        index.nodeToStyle.push_back(static_cast<int>(same - index.styles.begin()));
        if (same == index.styles.end()) {
            index.styles.push_back(std::move(entry));
        }
    }
    return index;
}

} // namespace limner
