#include "core/figure/shape_edits.h"

#include "core/figure/quantity.h"
#include "core/style/transfer_function.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace limner {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();
constexpr int kMaskCells = 64; // along each axis: finer than a hand paints over a few hundred pixels

ValueRange extentOf(const std::vector<double>& corners) {
    if (corners.empty())
        return {0, 0};
    const auto [low, high] = std::minmax_element(corners.begin(), corners.end());
    return {*low, *high};
}

/// Sets one of several rising numbers, held between its neighbours.
void setRising(std::vector<double>& numbers, int index, double to) {
    if (index < 0)
        return;
    const auto i = static_cast<std::size_t>(index);
    const double low = i > 0 ? numbers[i - 1] : -kNoLimit;
    const double high = i + 1 < numbers.size() ? numbers[i + 1] : kNoLimit;
    numbers[i] = std::max(low, std::min(high, to));
}

/// The same for a grid's positions, no two of which may be one.
void setStrictlyRising(std::vector<double>& positions, std::size_t i, double to) {
    assert(i < positions.size());
    const double low = i > 0 ? std::nextafter(positions[i - 1], kNoLimit) : -kNoLimit;
    const double high = i + 1 < positions.size() ? std::nextafter(positions[i + 1], -kNoLimit) : kNoLimit;
    positions[i] = std::max(low, std::min(high, to));
}

/// A new position in a grid's list, as near to `at` as no other is; the index it gets.
std::size_t insertRising(std::vector<double>& positions, double at) {
    while (std::find(positions.begin(), positions.end(), at) != positions.end())
        at = std::nextafter(at, kNoLimit);
    const auto place = std::upper_bound(positions.begin(), positions.end(), at);
    const auto index = static_cast<std::size_t>(place - positions.begin());
    positions.insert(place, at);
    return index;
}

/// Copies the neighbour on the near side: the plane looks as before.
std::size_t copiedFrom(std::size_t index) { return index > 0 ? index - 1 : 0; }

void growSide(std::vector<double>& numbers, double to, double soft) {
    ValueRange side = extentOf(numbers);
    // Where `to` lies `soft` of half the new extent inside the border: far - e * soft / 2 = to, e = far - other end.
    const double inside = 1 - std::clamp(soft, 0.0, 0.95) / 2;
    const auto reached = [&](double near) { return near + (to - near) / inside; };
    if (to > side.high - (side.high - side.low) * (1 - inside))
        side.high = std::max(side.high, reached(side.low));
    if (to < side.low + (side.high - side.low) * (1 - inside))
        side.low = std::min(side.low, reached(side.high));
    const ValueRange old = extentOf(numbers);
    const double scale = old.high > old.low ? (side.high - side.low) / (old.high - old.low) : 1;
    for (double& number : numbers)
        number = side.low + (number - old.low) * scale;
    if (!(old.high > old.low) && !numbers.empty()) {
        numbers.front() = side.low;
        numbers.back() = side.high;
    }
}

/// Trapezoids: the flank moves out as a whole, so that its ramp stays as steep as it was.
void growRamps(std::vector<double>& corners, double to) {
    if (to < corners[1]) {
        corners[0] -= corners[1] - to;
        corners[1] = to;
    } else if (to > corners[2]) {
        corners[3] += to - corners[2];
        corners[2] = to;
    }
}

} // namespace

PlaneBox boxOf(const OpacityShape& shape) {
    const ValueRange x = extentOf(shape.x);
    const ValueRange y = extentOf(shape.y);
    return {{x.low, y.low}, {x.high, y.high}};
}

OpacityShape freshShape(const std::string& kind, const PlaneBox& box) {
    OpacityShape shape;
    shape.shape = kind;
    shape.opacity = 0.8; // what lies behind is still guessed
    const glm::dvec2 size = box.high - box.low;
    const glm::dvec2 middle = (box.low + box.high) * 0.5;
    shape.x = {box.low.x, box.high.x};
    shape.y = {box.low.y, box.high.y};
    if (kind == "trapezoid") {
        shape.x = {box.low.x, box.low.x + size.x / 3, box.high.x - size.x / 3, box.high.x};
        shape.y = {box.low.y, box.low.y, box.high.y, box.high.y};
    } else if (kind == "polygon") {
        shape.x = {middle.x, box.high.x, middle.x, box.low.x};
        shape.y = {box.low.y, middle.y, box.high.y, middle.y};
    } else if (kind == "mask") {
        shape.columns = kMaskCells;
        shape.values.assign(static_cast<std::size_t>(kMaskCells) * kMaskCells, 0.0);
    }
    return shape;
}

Transfer withShapeAdded(Transfer plane, const OpacityShape& shape) {
    if (plane.opacity2d.empty() && plane.opacity.size() == 1 && plane.opacity.front().y == 0)
        plane.opacity.clear();
    plane.opacity2d.push_back(shape);
    return plane;
}

Transfer withShapeRemoved(Transfer plane, std::size_t shape) {
    assert(shape < plane.opacity2d.size());
    plane.opacity2d.erase(plane.opacity2d.begin() + static_cast<std::ptrdiff_t>(shape));
    if (plane.opacity2d.empty() && plane.opacity.empty())
        plane.opacity = {{0, 0}};
    return plane;
}

std::vector<ShapeHandle> handlesOf(const OpacityShape& shape) {
    std::vector<ShapeHandle> handles;
    const PlaneBox box = boxOf(shape);
    const glm::dvec2 middle = (box.low + box.high) * 0.5;
    if (shape.shape == "polygon") {
        for (std::size_t i = 0; i < std::min(shape.x.size(), shape.y.size()); ++i)
            handles.push_back({{shape.x[i], shape.y[i]}, static_cast<int>(i), static_cast<int>(i)});
        return handles;
    }
    if (shape.shape == "trapezoid" && shape.x.size() == 4 && shape.y.size() == 4) {
        const glm::dvec2 full((shape.x[1] + shape.x[2]) / 2, (shape.y[1] + shape.y[2]) / 2);
        for (int i = 0; i < 4; ++i)
            handles.push_back({{shape.x[static_cast<std::size_t>(i)], full.y}, i, -1});
        for (int i = 0; i < 4; ++i)
            handles.push_back({{full.x, shape.y[static_cast<std::size_t>(i)]}, -1, i});
        return handles;
    }
    if (shape.x.size() != 2 || shape.y.size() != 2)
        return handles;
    for (const int y : {0, 1, -1})
        for (const int x : {0, 1, -1}) {
            const double atX = x < 0 ? middle.x : shape.x[static_cast<std::size_t>(x)];
            const double atY = y < 0 ? middle.y : shape.y[static_cast<std::size_t>(y)];
            if (x >= 0 || y >= 0)
                handles.push_back({{atX, atY}, x, y});
        }
    return handles;
}

OpacityShape withShapeMoved(OpacityShape shape, const glm::dvec2& by) {
    for (double& x : shape.x)
        x += by.x;
    for (double& y : shape.y)
        y += by.y;
    return shape;
}

OpacityShape withHandleMoved(OpacityShape shape, std::size_t handle, const glm::dvec2& to) {
    const std::vector<ShapeHandle> handles = handlesOf(shape);
    assert(handle < handles.size());
    if (shape.shape == "polygon") {
        shape.x[handle] = to.x;
        shape.y[handle] = to.y;
        return shape;
    }
    setRising(shape.x, handles[handle].x, to.x);
    setRising(shape.y, handles[handle].y, to.y);
    return shape;
}

AddedCorner withCornerAdded(const OpacityShape& polygon, const glm::dvec2& at, const glm::dvec2& scale) {
    const std::size_t count = std::min(polygon.x.size(), polygon.y.size());
    const auto corner = [&](std::size_t i) { return glm::dvec2(polygon.x[i % count], polygon.y[i % count]) / scale; };
    double nearest = kNoLimit;
    AddedCorner added{polygon, count};
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec2 along = corner(i + 1) - corner(i);
        const glm::dvec2 to = at / scale - corner(i);
        const double length2 = along.x * along.x + along.y * along.y;
        const double share = length2 > 0 ? std::clamp((to.x * along.x + to.y * along.y) / length2, 0.0, 1.0) : 0;
        const glm::dvec2 off = to - share * along;
        const double distance2 = off.x * off.x + off.y * off.y;
        if (distance2 < nearest) {
            nearest = distance2;
            added.index = i + 1;
        }
    }
    added.shape.x.insert(added.shape.x.begin() + static_cast<std::ptrdiff_t>(added.index), at.x);
    added.shape.y.insert(added.shape.y.begin() + static_cast<std::ptrdiff_t>(added.index), at.y);
    return added;
}

OpacityShape withCornerRemoved(OpacityShape polygon, std::size_t index) {
    assert(index < polygon.x.size() && index < polygon.y.size());
    constexpr std::size_t kTriangle = 3;
    if (polygon.x.size() <= kTriangle)
        return polygon;
    polygon.x.erase(polygon.x.begin() + static_cast<std::ptrdiff_t>(index));
    polygon.y.erase(polygon.y.begin() + static_cast<std::ptrdiff_t>(index));
    return polygon;
}

OpacityShape withMaskPainted(OpacityShape mask, const MaskStroke& stroke) {
    const int columns = mask.columns;
    if (columns <= 0 || mask.x.size() != 2 || mask.y.size() != 2)
        return mask;
    const int rows = static_cast<int>(mask.values.size()) / columns;
    const glm::dvec2 cell((mask.x[1] - mask.x[0]) / columns, (mask.y[1] - mask.y[0]) / std::max(1, rows));
    const double fade = std::clamp(stroke.softness, 1e-6, 1.0);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const glm::dvec2 centre(mask.x[0] + (column + 0.5) * cell.x, mask.y[0] + (row + 0.5) * cell.y);
            const glm::dvec2 off = (centre - stroke.at) / stroke.radius;
            const double far = std::sqrt(off.x * off.x + off.y * off.y);
            if (far >= 1)
                continue;
            const double strength = std::min(1.0, (1 - far) / fade);
            double& value = mask.values[static_cast<std::size_t>(row * columns + column)];
            // The stroke passes a cell many times: the strongest touch counts, not their number.
            const double painted = stroke.towards >= 0.5 ? std::max(value, stroke.towards * strength)
                                                         : std::min(value, 1 - (1 - stroke.towards) * strength);
            value = std::clamp(painted, 0.0, 1.0);
        }
    return mask;
}

double membershipAt(const OpacityShape& shape, const glm::dvec2& at) {
    Transfer alone;
    alone.kind = TransferKind::twoDimensional;
    alone.axes = {"value", "gradient"};
    alone.opacity2d = {shape};
    alone.opacity2d.front().opacity = 1;
    return opacity2dAt(alone, at.x, at.y);
}

OpacityShape withShapeGrown(OpacityShape shape, const glm::dvec2& to) {
    if (shape.shape == "trapezoid" && shape.x.size() == 4 && shape.y.size() == 4) {
        growRamps(shape.x, to.x);
        growRamps(shape.y, to.y);
        return shape;
    }
    const double before = membershipAt(shape, to);
    if (shape.shape == "rectangle" ? before >= 1 : before > 0)
        return shape;
    // An ellipse or a polygon holds less than its box: it grows on until it reaches the place.
    constexpr int kMostTries = 40;
    const PlaneBox box = boxOf(shape);
    const glm::dvec2 middle = (box.low + box.high) * 0.5;
    glm::dvec2 aim = to;
    for (int i = 0; i < kMostTries; ++i) {
        growSide(shape.x, aim.x, shape.soft);
        growSide(shape.y, aim.y, shape.soft);
        if (shape.shape == "rectangle" || shape.shape == "mask" || membershipAt(shape, to) > 0)
            break;
        constexpr double kFurther = 1.1;
        aim = middle + (aim - middle) * kFurther;
    }
    return shape;
}

TransferNode nodeOfCell(const TransferGrid& grid, std::size_t cell) {
    const std::size_t columns = std::max<std::size_t>(1, grid.x.size());
    const std::size_t row = cell / columns;
    const std::size_t column = cell % columns;
    if (column >= grid.x.size() || row >= grid.styles.size() || column >= grid.styles[row].size())
        return {};
    const std::string& look = grid.styles[row][column];
    const auto rgb = plainColour(look);
    return {grid.x[column], rgb ? std::string() : look, rgb};
}

TransferGrid withColumnAdded(TransferGrid grid, double at) {
    const std::size_t column = insertRising(grid.x, at);
    for (auto& row : grid.styles) {
        row.resize(grid.x.size() - 1);
        const std::string look = row.empty() ? std::string() : row[copiedFrom(column)];
        row.insert(row.begin() + static_cast<std::ptrdiff_t>(column), look);
    }
    return grid;
}

TransferGrid withRowAdded(TransferGrid grid, double at) {
    const std::size_t row = insertRising(grid.y, at);
    grid.styles.resize(grid.y.size() - 1);
    const auto looks = grid.styles.empty() ? std::vector<std::string>(grid.x.size()) : grid.styles[copiedFrom(row)];
    grid.styles.insert(grid.styles.begin() + static_cast<std::ptrdiff_t>(row), looks);
    return grid;
}

TransferGrid withColumnRemoved(TransferGrid grid, std::size_t column) {
    assert(column < grid.x.size());
    if (grid.x.size() < 2)
        return grid;
    grid.x.erase(grid.x.begin() + static_cast<std::ptrdiff_t>(column));
    for (auto& row : grid.styles)
        if (column < row.size())
            row.erase(row.begin() + static_cast<std::ptrdiff_t>(column));
    return grid;
}

TransferGrid withRowRemoved(TransferGrid grid, std::size_t row) {
    assert(row < grid.y.size());
    if (grid.y.size() < 2)
        return grid;
    grid.y.erase(grid.y.begin() + static_cast<std::ptrdiff_t>(row));
    if (row < grid.styles.size())
        grid.styles.erase(grid.styles.begin() + static_cast<std::ptrdiff_t>(row));
    return grid;
}

TransferGrid withColumnMoved(TransferGrid grid, std::size_t column, double at) {
    setStrictlyRising(grid.x, column, at);
    return grid;
}

TransferGrid withRowMoved(TransferGrid grid, std::size_t row, double at) {
    setStrictlyRising(grid.y, row, at);
    return grid;
}

} // namespace limner
