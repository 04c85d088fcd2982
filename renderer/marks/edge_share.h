#pragma once

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace limner {

/// Four numbers side by side, for processors that count so; compilers make a loop of it for the others.
using Four = float __attribute__((vector_size(16)));

inline Four atLeast0(Four x) { return x > 0 ? x : Four{}; }

/// The share of a pixel that lies on the inner side of a straight edge: `inside` is its middle's distance to the edge,
/// (a, b) the edge's unit normal.
inline float halfPlane(float inside, float a, float b) {
    a = std::abs(a);
    b = std::abs(b);
    const float most = 0.5F * (a + b);
    if (std::abs(inside) >= most)
        return inside > 0 ? 1.0F : 0.0F;
    const float flat = 0.5F * std::abs(a - b);
    if (std::abs(inside) <= flat)
        return 0.5F + inside / std::max(a, b);
    const float corner = (most - std::abs(inside)) * (most - std::abs(inside)) / (2 * a * b);
    return inside > 0 ? 1 - corner : corner;
}

/// How much of a pixel lies on the inner side of straight edges of one direction, as differences of squares: exact, and
/// without a branch.
class EdgeShare {
  public:
    explicit EdgeShare(glm::vec2 normal) {
        constexpr float kLeast = 1e-3F; // an edge along the pixels' is a ramp whose corners are that round
        const float a = std::max(std::abs(normal.x), kLeast);
        const float b = std::max(std::abs(normal.y), kLeast);
        wide_ = 0.5F * (a + b);
        flat_ = 0.5F * std::abs(a - b);
        scale_ = 1 / (2 * a * b);
    }
    [[nodiscard]] Four operator()(Four inside) const {
        return (square(inside + wide_) - square(inside + flat_) - square(inside - flat_) + square(inside - wide_)) *
               scale_;
    }

    /// As far from an edge a pixel's middle may be and see it.
    [[nodiscard]] float reach() const { return wide_; }

  private:
    static Four square(Four x) {
        x = atLeast0(x);
        return x * x;
    }
    float wide_ = 0;
    float flat_ = 0;
    float scale_ = 0;
};

} // namespace limner
