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

    /// A polygon's edge in the normalised plane.
    struct Edge {
        glm::dvec2 start;
        glm::dvec2 along;
        glm::dvec2 perLength2; ///< `along` over its squared length; 0 for an edge without length
        double slope = 0;      ///< dx / dy
        double endY = 0;
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
    std::vector<Edge> edges_; ///< of a polygon
};

/// The shapes of a transfer function. Thread-safe.
class PreparedShapes {
  public:
    explicit PreparedShapes(const std::vector<OpacityShape>& shapes);
    /// The greatest opacity of the shapes at a position, 1 where there are none.
    [[nodiscard]] double opacityAt(double x, double y) const;

  private:
    bool none_;
    std::vector<PreparedShape> strongestFirst_;
};

} // namespace limner
