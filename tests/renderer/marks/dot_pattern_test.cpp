#include "renderer/marks/dot_pattern.h"

#include <gtest/gtest.h>

#include <complex>
#include <numbers>

namespace limner {
namespace {

std::vector<glm::dvec2> beginning(float end) {
    std::vector<glm::dvec2> points;
    dotPattern().forEachIn({0, 0}, {DotPattern::kSize, DotPattern::kSize}, end,
                           [&](const glm::vec2& p, float, std::uint32_t) { points.emplace_back(p); });
    return points;
}

/// Mean power of a ring of spatial frequencies, low to high as shares of the principal one (a wave to a point's
/// distance); points at random have 1 everywhere.
double ringPower(const std::vector<glm::dvec2>& points, double low, double high) {
    const double principal = std::sqrt(static_cast<double>(points.size())); // waves to the tile
    constexpr int rings = 6;
    constexpr int directions = 32;
    double sum = 0;
    for (int r = 0; r < rings; ++r) {
        const double waves = principal * (low + (high - low) * (r + 0.5) / rings);
        for (int i = 0; i < directions; ++i) {
            const double angle = std::numbers::pi * (i + 0.5) / directions;
            const double kx = std::round(waves * std::cos(angle));
            const double ky = std::round(waves * std::sin(angle));
            std::complex<double> wave = 0;
            for (const glm::dvec2& p : points) {
                wave += std::polar(1.0, -2 * std::numbers::pi * (kx * p.x + ky * p.y) / DotPattern::kSize);
            }
            sum += std::norm(wave) / static_cast<double>(points.size());
        }
    }
    return sum / (rings * directions);
}

TEST(DotPattern, EveryBeginningIsBlueNoise) {
    for (const float part : {0.01F, 0.1F, 0.3F, 1.0F}) {
        const auto points = beginning(part);
        // Measured: 0.10 to 0.15 below half of the principal frequency and 1.1 to 1.3 around it.
        EXPECT_LT(ringPower(points, 0.05, 0.5), 0.2) << part;
        EXPECT_GT(ringPower(points, 1.0, 1.3), 0.9) << part;
    }
}

TEST(DotPattern, NumbersOfPointsFollowTheRank) {
    for (const float part : {0.001F, 0.1F, 0.5F, 1.0F}) {
        EXPECT_NEAR(static_cast<double>(beginning(part).size()), static_cast<double>(part) * DotPattern::kCount, 1.0);
    }
}

TEST(DotPattern, RepeatsAndIsTheSameThroughAnyWindow) {
    const DotPattern& pattern = dotPattern();
    const auto count = [&](const glm::dvec2& low, const glm::dvec2& high) {
        int points = 0;
        double sum = 0;
        pattern.forEachIn(low, high, 0.5F, [&](const glm::vec2& p, float rank, std::uint32_t) {
            EXPECT_TRUE(p.x >= 0 && p.x < high.x - low.x && p.y >= 0 && p.y < high.y - low.y);
            ++points;
            sum += static_cast<double>(rank);
        });
        return std::pair(points, sum);
    };
    const glm::dvec2 low(3.7, -11.2);
    const glm::dvec2 high(31.9, 20.4);
    const auto whole = count(low, high);
    EXPECT_EQ(whole, count(low + 256.0, high + 256.0));
    EXPECT_EQ(whole, count(low - 1024.0, high - 1024.0));
    const auto left = count(low, {17.3, high.y});
    const auto right = count({17.3, low.y}, high);
    EXPECT_EQ(whole.first, left.first + right.first);
    EXPECT_GT(whole.first, 350);
}

TEST(DotPattern, CoverageRisesFromTheDotsOwnAreaToAll) {
    const DotPattern& pattern = dotPattern();
    EXPECT_NEAR(pattern.coverage(0.2), 0.2, 0.002); // dots that do not touch
    double before = 0;
    for (double density = 0.05; density <= DotPattern::kMostDensity; density += 0.05) {
        const double covered = pattern.coverage(density);
        EXPECT_GT(covered, before);
        EXPECT_GT(covered, 1 - std::exp(-density)) << "no better than dots at random at " << density;
        EXPECT_LE(covered, std::min(density * 1.01, 1.0));
        if (covered < 0.995) {
            EXPECT_NEAR(pattern.densityFor(covered), density, 2e-3);
        }
        before = covered;
    }
    EXPECT_EQ(pattern.densityFor(0), 0);
    EXPECT_EQ(pattern.densityFor(1), DotPattern::kMostDensity);
}

} // namespace
} // namespace limner
