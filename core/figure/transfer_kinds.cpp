#include "core/figure/transfer_kinds.h"

#include "core/figure/quantity.h"
#include "core/style/transfer_function.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

namespace limner {
namespace {

using Points = std::vector<glm::dvec2>;

/// The curve with its ends drawn out to the plane's, clear beyond.
Points closedCurve(const Transfer& line, const PlaneBox& plane) {
    Points points = line.opacity;
    if (points.empty())
        return points;
    if (points.front().y > 0) {
        const double low = std::min(plane.low.x, points.front().x);
        points.insert(points.begin(), {{low, 0}, {low, points.front().y}});
    }
    if (points.back().y > 0) {
        const double high = std::max(plane.high.x, points.back().x);
        points.push_back({high, points.back().y});
        points.push_back({high, 0});
    }
    return points;
}

/// The curve as trapezoids over the whole second axis; nothing where it is not made of such.
std::optional<std::vector<OpacityShape>> trapezoidsOf(const Transfer& line, const PlaneBox& plane) {
    if (line.curve != OpacityCurve::linear)
        return std::nullopt;
    const Points points = closedCurve(line, plane);
    std::vector<OpacityShape> shapes;
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (!(points[i].y > 0))
            continue;
        std::size_t end = i;
        while (end < points.size() && points[end].y == points[i].y)
            ++end;
        if (end == points.size() || points[end].y > 0 || points[i - 1].y > 0)
            return std::nullopt;
        OpacityShape shape;
        shape.shape = "trapezoid";
        shape.x = {points[i - 1].x, points[i].x, points[end - 1].x, points[end].x};
        shape.y = {plane.low.y, plane.low.y, plane.high.y, plane.high.y};
        shape.opacity = points[i].y;
        shapes.push_back(shape);
        i = end;
    }
    return shapes;
}

std::string cellOf(const TransferNode& node) {
    if (!node.style.empty())
        return node.style;
    const glm::dvec3 rgb = node.rgb.value_or(glm::dvec3(0.5));
    const auto byte = [](double share) {
        return static_cast<unsigned>(std::lround(std::clamp(share, 0.0, 1.0) * 255));
    };
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x", byte(rgb.r), byte(rgb.g), byte(rgb.b));
    return text.data();
}

TransferGrid gridOf(const std::vector<TransferNode>& nodes, double middle, double row) {
    TransferGrid grid{{}, {row}, {{}}};
    for (const TransferNode& node : nodes) {
        double at = node.at;
        if (!grid.x.empty() && !(at > grid.x.back())) // a step: as near as columns can be
            at = std::nextafter(grid.x.back(), std::numeric_limits<double>::infinity());
        grid.x.push_back(at);
        grid.styles.front().push_back(cellOf(node));
    }
    if (nodes.empty()) {
        grid.x = {middle};
        grid.styles = {{cellOf({})}};
    }
    return grid;
}

bool spans(const OpacityShape& shape, const PlaneBox& shown) {
    const PlaneBox box = boxOf(shape);
    const bool flat = shape.shape == "trapezoid"
                          ? shape.y.size() == 4 && shape.y[0] == shape.y[1] && shape.y[2] == shape.y[3]
                          : shape.shape == "rectangle" && shape.soft == 0;
    return flat && box.low.y <= shown.low.y && box.high.y >= shown.high.y;
}

/// What `trapezoidsOf` undone gives; nothing for any other set of shapes.
std::optional<Points> curveOf(std::vector<OpacityShape> shapes, const PlaneBox& shown) {
    const auto inOrder = [](const OpacityShape& a, const OpacityShape& b) { return boxOf(a).low.x < boxOf(b).low.x; };
    std::sort(shapes.begin(), shapes.end(), inOrder);
    Points points;
    const auto add = [&](const glm::dvec2& point) {
        if (points.empty() || points.back() != point)
            points.push_back(point);
    };
    for (const OpacityShape& shape : shapes) {
        const PlaneBox box = boxOf(shape);
        if (!spans(shape, shown) || (!points.empty() && box.low.x < points.back().x))
            return std::nullopt;
        const bool ramps = shape.shape == "trapezoid";
        const double first = ramps ? shape.x[1] : box.low.x;
        const double last = ramps ? shape.x[2] : box.high.x;
        const bool fromStart = first == box.low.x && first <= shown.low.x;
        const bool toEnd = last == box.high.x && last >= shown.high.x;
        if (!fromStart)
            add({box.low.x, 0});
        add({first, shape.opacity});
        add({last, shape.opacity});
        if (!toEnd)
            add({box.high.x, 0});
    }
    if (points.size() >= 2 && points[0].y == points[1].y && points[0].x <= shown.low.x)
        points.erase(points.begin()); // the end is drawn out again by itself
    const std::size_t n = points.size();
    if (n >= 2 && points[n - 1].y == points[n - 2].y && points[n - 1].x >= shown.high.x)
        points.pop_back();
    return points;
}

/// Keeps the points that a line through the others would miss by more than `tolerance`.
void simplify(const Points& points, std::size_t first, std::size_t last, std::vector<bool>& kept) {
    constexpr double kTolerance = 0.005;
    double farthest = kTolerance;
    std::size_t split = first;
    for (std::size_t i = first + 1; i < last; ++i) {
        const double share = (points[i].x - points[first].x) / std::max(points[last].x - points[first].x, 1e-300);
        const double off = std::abs(points[first].y + share * (points[last].y - points[first].y) - points[i].y);
        if (off > farthest) {
            farthest = off;
            split = i;
        }
    }
    if (split == first)
        return;
    kept[split] = true;
    simplify(points, first, split, kept);
    simplify(points, split, last, kept);
}

/// The plane's greatest opacity over its second axis.
Points silhouetteOf(const Transfer& plane, const PlaneBox& shown) {
    constexpr int kAlong = 200;
    constexpr int kAcross = 65;
    std::vector<double> ys;
    for (int i = 0; i < kAcross; ++i)
        ys.push_back(shown.low.y + (shown.high.y - shown.low.y) * i / (kAcross - 1));
    std::vector<double> xs;
    for (int i = 0; i <= kAlong; ++i)
        xs.push_back(shown.low.x + (shown.high.x - shown.low.x) * i / kAlong);
    for (const OpacityShape& shape : plane.opacity2d) {
        const PlaneBox box = boxOf(shape);
        ys.push_back((box.low.y + box.high.y) / 2);
        xs.insert(xs.end(), shape.x.begin(), shape.x.end());
        for (const double border : {box.low.x, box.high.x}) // just outside: borders are closed
            xs.push_back(std::nextafter(border, border == box.low.x ? -1e300 : 1e300));
    }
    std::sort(xs.begin(), xs.end());
    Points points;
    for (const double x : xs) {
        double greatest = 0;
        for (const double y : ys)
            greatest = std::max(greatest, opacity2dAt(plane, x, y));
        points.push_back({x, greatest});
    }
    std::vector<bool> kept(points.size());
    kept.front() = kept.back() = true;
    simplify(points, 0, points.size() - 1, kept);
    Points simple;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (kept[i])
            simple.push_back(points[i]);
    return simple;
}

std::vector<TransferNode> nodesOf(const TransferGrid& grid) {
    std::vector<TransferNode> nodes;
    const std::size_t row = grid.styles.size() / 2;
    for (std::size_t i = 0; row < grid.styles.size() && i < std::min(grid.x.size(), grid.styles[row].size()); ++i) {
        const std::string& cell = grid.styles[row][i];
        const auto rgb = plainColour(cell);
        nodes.push_back({grid.x[i], rgb ? std::string() : cell, rgb});
    }
    return nodes;
}

/// One flank of a curve: its inner, opaque point and its outer, clear one.
struct Flank {
    std::size_t inner = 0;
    std::size_t outer = 0;
    double opacity = 0; ///< of the inner point
};

/// Of the rising sides (or falling ones) of all bumps.
std::vector<Flank> flanksOf(const Points& points, int outwards) {
    std::vector<Flank> flanks;
    const auto last = static_cast<std::ptrdiff_t>(points.size()) - 1;
    for (std::ptrdiff_t i = 0; i <= last; ++i) {
        const std::ptrdiff_t outer = i + outwards;
        const bool clearOutside = outer >= 0 && outer <= last && points[static_cast<std::size_t>(outer)].y <= 0;
        if (!(points[static_cast<std::size_t>(i)].y > 0) || !clearOutside)
            continue;
        // Up the ramp to where it stops rising.
        std::ptrdiff_t top = i;
        while (top - outwards >= 0 && top - outwards <= last &&
               points[static_cast<std::size_t>(top - outwards)].y > points[static_cast<std::size_t>(top)].y)
            top -= outwards;
        flanks.push_back(
            {static_cast<std::size_t>(top), static_cast<std::size_t>(outer), points[static_cast<std::size_t>(top)].y});
    }
    return flanks;
}

/// Moves the points from the flank's inner to its outer one by `by`, and what they pass along with them.
void moveFlank(Points& points, const Flank& flank, double by) {
    const std::size_t first = std::min(flank.inner, flank.outer);
    const std::size_t last = std::max(flank.inner, flank.outer);
    for (std::size_t i = first; i <= last; ++i)
        points[i].x += by;
    for (std::size_t i = first; i-- > 0;)
        points[i].x = std::min(points[i].x, points[i + 1].x);
    for (std::size_t i = last + 1; i < points.size(); ++i)
        points[i].x = std::max(points[i].x, points[i - 1].x);
}

} // namespace

Transfer withTwoAxes(const Transfer& line, const std::string& second, const PlaneBox& plane) {
    Transfer result = line;
    result.kind = TransferKind::twoDimensional;
    result.axes = {line.axis, second};
    result.axis = Transfer{}.axis;
    result.nodes.clear();
    const double middle = (plane.low.x + plane.high.x) / 2;
    const double row = second == "label" ? -1 : (plane.low.y + plane.high.y) / 2; // -1: all labels
    result.grid = gridOf(line.nodes, line.axis == "label" ? -1 : middle, row);
    if (auto shapes = trapezoidsOf(line, plane); shapes && !shapes->empty()) {
        result.opacity2d = std::move(*shapes);
        result.opacity.clear();
    } else {
        OpacityShape all;
        all.x = {plane.low.x, plane.high.x};
        all.y = {plane.low.y, plane.high.y};
        result.opacity2d = {all};
    }
    return result;
}

Transfer withOneAxis(const Transfer& plane, const PlaneBox& shown) {
    Transfer result = plane;
    result.kind = TransferKind::oneDimensional;
    result.axis = plane.axes.empty() ? Transfer{}.axis : plane.axes.front();
    result.axes.clear();
    result.grid.reset();
    result.opacity2d.clear();
    result.nodes = plane.grid ? nodesOf(*plane.grid) : plane.nodes;
    const auto fills = [&](const OpacityShape& shape) {
        const PlaneBox box = boxOf(shape);
        return shape.shape == "rectangle" && spans(shape, shown) && shape.opacity == 1 && box.low.x <= shown.low.x &&
               box.high.x >= shown.high.x;
    };
    const bool curveAlone =
        plane.opacity2d.empty() || std::any_of(plane.opacity2d.begin(), plane.opacity2d.end(), fills);
    if (curveAlone && !plane.opacity.empty())
        return result;
    result.curve = OpacityCurve::linear;
    const auto exact =
        plane.opacity.empty() && !plane.opacity2d.empty() ? curveOf(plane.opacity2d, shown) : std::nullopt;
    result.opacity = exact ? *exact : silhouetteOf(plane, shown);
    return result;
}

Transfer withValueShown(Transfer line, double value) {
    const Points& points = line.opacity;
    struct Reach {
        Flank flank;
        double by = 0;
    };
    std::optional<Reach> nearest;
    for (const int outwards : {-1, 1})
        for (const Flank& flank : flanksOf(points, outwards)) {
            const double by = value - points[flank.inner].x;
            const bool outside = outwards < 0 ? by < 0 : by > 0;
            if (outside && (!nearest || std::abs(by) < std::abs(nearest->by)))
                nearest = Reach{flank, by};
        }
    if (!nearest)
        return line;
    const double wanted = nearest->flank.opacity * (line.curve == OpacityCurve::step ? 1 : 0.5);
    if (curveOpacityAt(line, value) >= wanted)
        return line;
    moveFlank(line.opacity, nearest->flank, nearest->by);
    return line;
}

Transfer withPlaceShown(Transfer plane, const glm::dvec2& at, const glm::dvec2& scale) {
    std::optional<std::size_t> nearest;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < plane.opacity2d.size(); ++i) {
        const OpacityShape& shape = plane.opacity2d[i];
        constexpr double kShown = 0.5;
        if (shape.opacity > 0 && membershipAt(shape, at) >= kShown)
            return plane;
        const PlaneBox box = boxOf(shape);
        const glm::dvec2 held(std::clamp(at.x, box.low.x, box.high.x), std::clamp(at.y, box.low.y, box.high.y));
        const glm::dvec2 off = (at - held) / scale;
        const double distance = off.x * off.x + off.y * off.y;
        if (shape.opacity > 0 && distance < least) {
            least = distance;
            nearest = i;
        }
    }
    if (nearest)
        plane.opacity2d[*nearest] = withShapeGrown(plane.opacity2d[*nearest], at);
    return plane;
}

} // namespace limner
