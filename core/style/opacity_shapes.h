#pragma once

#include "core/figure/layer.h"

#include <vector>

namespace limner {

/// A shape of opacity made ready for many positions. Internal to core/style; refers to the shape. Thread-safe.
class PreparedShape {
  public:
    explicit PreparedShape(const OpacityShape& shape);

    [[nodiscard]] double opacity() const { return shape_->opacity; }
    /// 0..1 for any corners and positions, as `opacity2dAt` documents it; 0 for what is no shape.
    [[nodiscard]] double membershipAt(double x, double y) const;

  private:
    enum class Kind { none, rectangle, trapezoid, ellipse, polygon, mask };

    /// The shape's bounds along an axis, and its corners in rising order.
    struct Side {
        double low = 0;
        double high = 0;
        double corners[4] = {};
        [[nodiscard]] bool holds(double at) const { return at >= low && at <= high; }
        /// -1 at `low`, 1 at `high`, both exactly; 0 where they are one.
        [[nodiscard]] double normalised(double at) const;
    };

    static Kind kindOf(const OpacityShape& shape);
    static Side sideOf(const std::vector<double>& corners);
    [[nodiscard]] double rectangleAt(double x, double y) const;
    [[nodiscard]] double trapezoidAt(double x, double y) const;
    [[nodiscard]] double ellipseAt(double x, double y) const;
    [[nodiscard]] double polygonAt(double x, double y) const;
    [[nodiscard]] double maskAt(double x, double y) const;

    const OpacityShape* shape_;
    Kind kind_;
    Side x_;
    Side y_;
    double soft_;
    std::vector<glm::dvec2> polygon_; ///< its points, normalised
};

/// The greatest opacity of the shapes at a position, 1 where there are none.
double shapesOpacityAt(const std::vector<PreparedShape>& shapes, double x, double y);

std::vector<PreparedShape> preparedShapes(const std::vector<OpacityShape>& shapes);

} // namespace limner
