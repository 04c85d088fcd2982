#pragma once

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace limner {

/// A plane of points in an order of which every beginning is spread evenly and without a pattern (blue noise): what is
/// drawn of them thins out as a stipple drawing does. Made by weighted sample elimination (Yuksel 2015, "Sample
/// elimination for generating Poisson disk sample sets") on a tile that repeats in both directions. The same on every
/// machine: sums, products and square roots alone. Immutable, thread-safe.
class DotPattern {
  public:
    static constexpr int kSize = 256; ///< edge of the tile; one point to a unit square on average
    static constexpr int kCount = kSize * kSize;

    /// Takes some tenths of a second.
    DotPattern();

    struct Point {
        float x; ///< in its square
        float y;
        float rank;           ///< place in the order over kCount, in [0, 1)
        std::uint32_t number; ///< 32 random bits of its own
    };

    /// Calls `use(place, rank, number)` for the points of [low, high) of the plane whose rank is below `end`, square by
    /// square; `place` (float) counts from `low`.
    template <typename Use>
    void forEachIn(const glm::dvec2& low, const glm::dvec2& high, float end, const Use& use) const;

    /// A place in the tile for every 32 bits: where another drawing looks at the plane.
    static glm::dvec2 offsetOf(std::uint32_t bits) {
        return glm::dvec2(bits & 0xffffU, bits >> 16U) * (kSize / 65536.0);
    }

    /// Share of a plane that dots of one size cover, `density` being their areas' sum over the plane's: less than the
    /// density where they overlap, and more than dots at random cover. Measured on the tile.
    [[nodiscard]] double coverage(double density) const;
    /// The density that covers that share, at most `kMostDensity`.
    [[nodiscard]] double densityFor(double coverage) const;

    /// What `coverage` and `densityFor` interpolate: over densities from 0 to kMostDensity, at even steps.
    [[nodiscard]] std::span<const float> coverageTable() const { return coverage_; }

    static constexpr double kMostDensity = 3; ///< covers all but some thousandths

  private:
    /// The points, found by squares: square by square, rows first, each square's by rank.
    struct Squares {
        int edge = 4;
        std::vector<Point> points;
        std::vector<std::uint32_t> start; ///< first point of each square, one more at the end
    };
    static constexpr int kEdges[] = {4, 16, 64}; ///< few points are found sooner in large squares

    static Squares inSquares(int edge, const std::vector<glm::dvec2>& inOrder);
    void measureCoverage();

    [[nodiscard]] const Squares& squaresFor(float end) const {
        // Two points to a square, so that neither squares nor points are looked at in vain.
        return squares_[end > 2.0F / (kEdges[1] * kEdges[1]) * 4   ? 0
                        : end > 2.0F / (kEdges[2] * kEdges[2]) * 4 ? 1
                                                                   : 2];
    }

    Squares squares_[3];
    std::vector<float> coverage_; ///< over densities from 0 to kMostDensity
};

/// The pattern that figures are drawn with; made on first use, from any thread.
const DotPattern& dotPattern();

template <typename Use>
void DotPattern::forEachIn(const glm::dvec2& low, const glm::dvec2& high, float end, const Use& use) const {
    const Squares& squares = squaresFor(end);
    const int edge = squares.edge;
    const int perRow = kSize / edge;
    const int mask = perRow - 1;
    const glm::vec2 size(high - low);
    const double perEdge = 1.0 / edge;
    const auto first = [&](double x) { // rounded down without a call
        const double square = x * perEdge;
        const auto whole = static_cast<std::int64_t>(square);
        return whole - (static_cast<double>(whole) > square ? 1 : 0);
    };
    for (std::int64_t row = first(low.y); static_cast<double>(row * edge) < high.y; ++row) {
        for (std::int64_t column = first(low.x); static_cast<double>(column * edge) < high.x; ++column) {
            const auto square = static_cast<std::size_t>((row & mask) * perRow + (column & mask));
            const glm::vec2 origin(static_cast<double>(column * edge) - low.x, static_cast<double>(row * edge) - low.y);
            for (std::uint32_t i = squares.start[square]; i < squares.start[square + 1]; ++i) {
                const Point& point = squares.points[i];
                if (point.rank >= end) {
                    break; // a square's points are in their order
                }
                const glm::vec2 place(origin.x + point.x, origin.y + point.y);
                if (place.x >= 0 && place.x < size.x && place.y >= 0 && place.y < size.y) {
                    use(place, point.rank, point.number);
                }
            }
        }
    }
}

} // namespace limner
