#include "core/style/opacity_shapes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>

namespace limner {
namespace {

/// 0..1; what is not a number counts as 0.
double unit(double share) { return share > 0 ? std::min(share, 1.0) : 0; }

/// From 0 at the border (`inside` = 0) to 1 at `width`; without a width all of the closed inside counts.
double softened(double inside, double width) {
    if (!(inside >= 0)) {
        return 0;
    }
    return width > 0 ? unit(inside / width) : 1;
}

/// A trapezoid's two ramps along one axis; the corners rise. A ramp without width is a step.
double rampsAt(const double (&corners)[4], double at) {
    if (at < corners[1]) {
        return unit((at - corners[0]) / (corners[1] - corners[0]));
    }
    if (at > corners[2]) {
        return unit((corners[3] - at) / (corners[3] - corners[2]));
    }
    return 1;
}

/// Where a position lies between the centres of `count` cells.
struct CellPlace {
    std::size_t first = 0;
    std::size_t second = 0;
    double weight = 0;
};

CellPlace cellPlace(double normalised, std::size_t count) {
    const double last = static_cast<double>(count - 1);
    const double at = std::clamp((normalised + 1) / 2 * static_cast<double>(count) - 0.5, 0.0, last);
    const auto first = static_cast<std::size_t>(at);
    return {first, std::min(first + 1, count - 1), at - static_cast<double>(first)};
}

} // namespace

double PreparedShape::Side::normalised(double at) const {
    // Halves first: no difference of two finite numbers then overflows.
    const double half = high / 2 - low / 2;
    return half > 0 ? ((at / 2 - low / 2) - (high / 2 - at / 2)) / half : 0;
}

PreparedShape::Kind PreparedShape::kindOf(const OpacityShape& shape) {
    const auto finite = [](double corner) { return std::isfinite(corner); };
    if (!std::all_of(shape.x.begin(), shape.x.end(), finite) || !std::all_of(shape.y.begin(), shape.y.end(), finite)) {
        return Kind::none;
    }
    const bool box = shape.x.size() >= 2 && shape.y.size() >= 2;
    if (shape.shape == "rectangle") {
        return box ? Kind::rectangle : Kind::none;
    }
    if (shape.shape == "ellipse") {
        return box ? Kind::ellipse : Kind::none;
    }
    if (shape.shape == "trapezoid") {
        return shape.x.size() >= 4 && shape.y.size() >= 4 ? Kind::trapezoid : Kind::none;
    }
    if (shape.shape == "polygon") {
        return !shape.x.empty() && shape.x.size() == shape.y.size() ? Kind::polygon : Kind::none;
    }
    const bool painted = shape.columns > 0 && shape.values.size() >= static_cast<std::size_t>(shape.columns);
    return shape.shape == "mask" && box && painted ? Kind::mask : Kind::none;
}

PreparedShape::Side PreparedShape::sideOf(const std::vector<double>& corners) {
    std::vector<double> rising = corners;
    std::sort(rising.begin(), rising.end());
    Side side{rising.front(), rising.back(), {}};
    std::copy_n(rising.begin(), std::min(rising.size(), std::size(side.corners)), side.corners);
    return side;
}

PreparedShape::PreparedShape(const OpacityShape& shape)
    : shape_(&shape), kind_(kindOf(shape)), soft_(unit(shape.soft)) {
    if (kind_ == Kind::none) {
        return;
    }
    x_ = sideOf(shape.x);
    y_ = sideOf(shape.y);
    if (kind_ == Kind::polygon) {
        const auto corner = [&](std::size_t k) {
            return glm::dvec2(x_.normalised(shape.x[k]), y_.normalised(shape.y[k]));
        };
        for (std::size_t k = 0; k < shape.x.size(); ++k) {
            const glm::dvec2 start = corner(k);
            const glm::dvec2 end = corner((k + 1) % shape.x.size());
            const glm::dvec2 along = end - start;
            const double length2 = glm::dot(along, along);
            edges_.push_back({start, along, length2 > 0 ? along / length2 : glm::dvec2(0),
                              along.y != 0 ? along.x / along.y : 0, end.y});
        }
    }
}

double PreparedShape::membershipAt(double x, double y) const {
    if (kind_ == Kind::none || !x_.holds(x) || !y_.holds(y)) {
        return 0;
    }
    switch (kind_) {
    case Kind::rectangle: return rectangleAt(x, y);
    case Kind::trapezoid: return trapezoidAt(x, y);
    case Kind::ellipse: return ellipseAt(x, y);
    case Kind::polygon: return polygonAt(x, y);
    case Kind::mask: return maskAt(x, y);
    case Kind::none: break;
    }
    return 0;
}

double PreparedShape::rectangleAt(double x, double y) const {
    const auto ramp = [this](const Side& side, double at) {
        return softened(std::min(at - side.low, side.high - at), soft_ * (side.high / 2 - side.low / 2));
    };
    return ramp(x_, x) * ramp(y_, y);
}

double PreparedShape::trapezoidAt(double x, double y) const { return rampsAt(x_.corners, x) * rampsAt(y_.corners, y); }

double PreparedShape::ellipseAt(double x, double y) const {
    const double u = x_.normalised(x);
    const double v = y_.normalised(y);
    return softened(1 - std::sqrt(u * u + v * v), soft_);
}

double PreparedShape::polygonAt(double x, double y) const {
    const glm::dvec2 p(x_.normalised(x), y_.normalised(y));
    bool inside = false;
    double nearest2 = std::numeric_limits<double>::infinity();
    for (const Edge& edge : edges_) {
        const glm::dvec2 to = p - edge.start;
        if ((edge.start.y > p.y) != (edge.endY > p.y) && to.x < to.y * edge.slope) {
            inside = !inside;
        }
        const glm::dvec2 off = to - std::clamp(glm::dot(to, edge.perLength2), 0.0, 1.0) * edge.along;
        nearest2 = std::min(nearest2, glm::dot(off, off));
    }
    // What rounding alone may put beside an edge is on it.
    constexpr double kOnEdge2 = 1e-28;
    return inside || nearest2 <= kOnEdge2 ? softened(std::sqrt(nearest2), soft_) : 0;
}

double PreparedShape::maskAt(double x, double y) const {
    const auto columns = static_cast<std::size_t>(shape_->columns);
    const CellPlace column = cellPlace(x_.normalised(x), columns);
    const CellPlace row = cellPlace(y_.normalised(y), shape_->values.size() / columns);
    const auto along = [&](std::size_t line) {
        const double* values = shape_->values.data() + line * columns;
        return values[column.first] + column.weight * (values[column.second] - values[column.first]);
    };
    const double low = along(row.first);
    return unit(low + row.weight * (along(row.second) - low));
}

PreparedShapes::PreparedShapes(const std::vector<OpacityShape>& shapes)
    : none_(shapes.empty()), strongestFirst_(shapes.begin(), shapes.end()) {
    std::erase_if(strongestFirst_, [](const PreparedShape& shape) { return !(shape.opacity() > 0); });
    std::sort(strongestFirst_.begin(), strongestFirst_.end(),
              [](const PreparedShape& a, const PreparedShape& b) { return a.opacity() > b.opacity(); });
}

double PreparedShapes::opacityAt(double x, double y) const {
    double greatest = none_ ? 1 : 0;
    for (const PreparedShape& shape : strongestFirst_) {
        if (shape.opacity() <= greatest) {
            break; // neither this one nor a weaker one adds anything
        }
        greatest = std::max(greatest, shape.opacity() * shape.membershipAt(x, y));
    }
    return greatest;
}

} // namespace limner
