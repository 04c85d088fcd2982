#pragma once

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
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
        float rank; ///< place in the order over kCount, in [0, 1)
    };

    /// Calls `use(place, rank, number)` for the points of [low, high) of the plane whose rank is below `end`, unit
    /// square by unit square; `place` in the plane's own coordinates, `number` of the point in the tile.
    template <typename Use>
    void forEachIn(const glm::dvec2& low, const glm::dvec2& high, float end, const Use& use) const;

    /// Share of a plane that dots of one size cover, `density` being their areas' sum over the plane's: less than the
    /// density where they overlap, and more than dots at random cover. Measured on the tile.
    [[nodiscard]] double coverage(double density) const;
    /// The density that covers that share, at most `kMostDensity`.
    [[nodiscard]] double densityFor(double coverage) const;

    static constexpr double kMostDensity = 3; ///< covers all but some thousandths

  private:
    static constexpr int kSquareEdge = 4; ///< of the squares that points are found by
    static constexpr int kSquares = kSize / kSquareEdge;

    void measureCoverage();

    std::vector<Point> points_;              ///< square by square, rows first, each by rank
    std::vector<std::uint32_t> squareStart_; ///< first point of each, one more at the end
    std::vector<float> coverage_;            ///< over densities from 0 to kMostDensity
};

/// The pattern that figures are drawn with; made on first use, from any thread.
const DotPattern& dotPattern();

template <typename Use>
void DotPattern::forEachIn(const glm::dvec2& low, const glm::dvec2& high, float end, const Use& use) const {
    constexpr int mask = kSquares - 1;
    static_assert((kSquares & mask) == 0 && kSquares * kSquareEdge == kSize);
    const auto first = [](double x) { // rounded down without a call
        const double square = x * (1.0 / kSquareEdge);
        const auto whole = static_cast<std::int64_t>(square);
        return whole - (static_cast<double>(whole) > square ? 1 : 0);
    };
    for (std::int64_t row = first(low.y); static_cast<double>(row * kSquareEdge) < high.y; ++row) {
        for (std::int64_t column = first(low.x); static_cast<double>(column * kSquareEdge) < high.x; ++column) {
            const auto square = static_cast<std::uint32_t>((row & mask) * kSquares + (column & mask));
            const glm::dvec2 origin(static_cast<double>(column * kSquareEdge), static_cast<double>(row * kSquareEdge));
            for (std::uint32_t i = squareStart_[square]; i < squareStart_[square + 1]; ++i) {
                const Point& point = points_[i];
                if (point.rank >= end) {
                    break; // a square's points are in their order
                }
                const glm::dvec2 place(origin.x + point.x, origin.y + point.y);
                if (place.x >= low.x && place.x < high.x && place.y >= low.y && place.y < high.y) {
                    use(place, point.rank, i);
                }
            }
        }
    }
}

} // namespace limner
