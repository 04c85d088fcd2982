#include "core/figure/transfer_edits.h"

#include "core/figure/style_edits.h"
#include "core/style/transfer_function.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace limner {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity(); // the first and last have one neighbour

/// Puts a style onto one cell of a plane's grid, or onto all of them. A plane without a grid gets one of one cell.
void setCells(Transfer& transfer, std::optional<std::size_t> node, const std::string& id) {
    TransferGrid& grid = transfer.grid ? *transfer.grid : transfer.grid.emplace(wholePlane(transfer));
    const std::size_t columns = std::max<std::size_t>(1, grid.x.size());
    grid.styles.resize(std::max<std::size_t>(1, grid.y.size()));
    for (std::size_t y = 0; y < grid.styles.size(); ++y) {
        grid.styles[y].resize(columns);
        for (std::size_t x = 0; x < columns; ++x)
            if (!node || *node == y * columns + x)
                grid.styles[y][x] = id;
    }
}

double middleOf(const OpacityPoints& points) { return points.empty() ? 0 : (points.front().x + points.back().x) / 2; }

/// The same for a line's nodes.
void setNodes(Transfer& transfer, std::optional<std::size_t> node, const std::string& id) {
    TransferNodes& nodes = transfer.nodes;
    if (nodes.empty())
        nodes.push_back({middleOf(transfer.opacity), id, std::nullopt});
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (!node || i == *node) {
            nodes[i].style = id;
            nodes[i].rgb.reset();
        }
}

} // namespace

OpacityPoints withPointMoved(OpacityPoints points, std::size_t index, glm::dvec2 to) {
    assert(index < points.size());
    const double low = index > 0 ? points[index - 1].x : -kNoLimit;
    const double high = index + 1 < points.size() ? points[index + 1].x : kNoLimit;
    points[index] = {std::max(low, std::min(high, to.x)), std::clamp(to.y, 0.0, 1.0)};
    return points;
}

OpacityPoints withPointsShifted(OpacityPoints points, double by) {
    for (glm::dvec2& point : points)
        point.x += by;
    return points;
}

AddedPoint withPointAdded(const OpacityPoints& points, glm::dvec2 point) {
    AddedPoint added{points, 0};
    const auto place = std::upper_bound(points.begin(), points.end(), point.x,
                                        [](double value, const glm::dvec2& p) { return value < p.x; });
    added.index = static_cast<std::size_t>(place - points.begin());
    point.y = std::clamp(point.y, 0.0, 1.0);
    added.points.insert(added.points.begin() + (place - points.begin()), point);
    return added;
}

OpacityPoints withPointRemoved(OpacityPoints points, std::size_t index) {
    assert(index < points.size());
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(index));
    return points;
}

OpacityPoints withStepAt(OpacityPoints points, std::size_t index) {
    assert(index < points.size());
    const double at = points[index].x;
    const bool step =
        (index > 0 && points[index - 1].x == at) || (index + 1 < points.size() && points[index + 1].x == at);
    if (!step)
        points.insert(points.begin() + static_cast<std::ptrdiff_t>(index), {at, index > 0 ? points[index - 1].y : 0.0});
    return points;
}

TransferNodes withNodeMoved(TransferNodes nodes, std::size_t index, double at) {
    assert(index < nodes.size());
    const double low = index > 0 ? nodes[index - 1].at : -kNoLimit;
    const double high = index + 1 < nodes.size() ? nodes[index + 1].at : kNoLimit;
    nodes[index].at = std::max(low, std::min(high, at));
    return nodes;
}

std::size_t nodePlace(const TransferNodes& nodes, double at) {
    return static_cast<std::size_t>(
        std::count_if(nodes.begin(), nodes.end(), [at](const TransferNode& node) { return node.at <= at; }));
}

TransferGrid wholePlane(const Transfer& transfer) {
    const auto anywhere = [&](std::size_t axis) { // -1: all labels
        return transfer.axes.size() > axis && transferAxis(transfer.axes[axis]) == TransferAxis::label ? -1.0 : 0.0;
    };
    return {{anywhere(0)}, {anywhere(1)}, {{std::string()}}};
}

Figure withStyle(const Figure& figure, std::size_t layer, std::optional<std::size_t> node, const Style& style) {
    assert(layer < figure.layers.size());
    Figure result = figure;
    const std::string id = joinStyle(result, style);
    Layer& changed = result.layers[layer];
    if (secondAxis(changed.transfer))
        setCells(changed.transfer, node, id);
    else
        setNodes(changed.transfer, node, id);
    changed.shading = Shading::style;
    dropUnusedStyles(result);
    return result;
}

Figure withStyleNode(const Figure& figure, std::size_t layer, double at, const Style& style) {
    assert(layer < figure.layers.size());
    Figure result = figure;
    const std::string id = joinStyle(result, style);
    Layer& changed = result.layers[layer];
    TransferNodes& nodes = changed.transfer.nodes;
    nodes.insert(nodes.begin() + static_cast<std::ptrdiff_t>(nodePlace(nodes, at)), {at, id, std::nullopt});
    changed.shading = Shading::style;
    return result;
}

} // namespace limner
