#include "core/optics/contour.h"
#include "core/optics/importance.h"
#include "core/optics/measures.h"
#include "core/optics/mip.h"
#include "core/optics/shading.h"
#include "core/optics/stipple.h"
#include "core/optics/transparency.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

// What the formulas owe beyond the test vectors (tests/renderer/accuracy), in double.

namespace limner::optics {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(SafePower, HasItsEnds) {
    EXPECT_EQ(powc(0.0, 0.0), 1);
    EXPECT_EQ(powc(-2.0, 0.0), 1);
    EXPECT_EQ(powc(0.0, 0.3), 0);
    EXPECT_EQ(powc(-2.0, 2.0), 0);
    EXPECT_EQ(powc(1.0, 1e9), 1);
    EXPECT_NEAR(powc(0.3, 2.5), std::pow(0.3, 2.5), 1e-16);
    EXPECT_NEAR(spow(-0.3, 2.0), -0.09, 1e-16);
    EXPECT_NEAR(spow(0.3, 2.0), 0.09, 1e-16);
    EXPECT_EQ(spow(0.0, 0.5), 0);
    EXPECT_TRUE(std::isnan(powc(kNaN, 0.5)));
}

TEST(FiniteOr, ReplacesWhatIsNotFinite) {
    EXPECT_EQ(finiteOr(1e308, 7.0), 1e308);
    EXPECT_EQ(finiteOr(-1e308, 7.0), -1e308);
    EXPECT_EQ(finiteOr(kInfinity, 7.0), 7);
    EXPECT_EQ(finiteOr(-kInfinity, 7.0), 7);
    EXPECT_EQ(finiteOr(kNaN, 7.0), 7);
}

TEST(Curvature, OfABallAlongTheViewIsThatOfItsRadius) {
    // The field r^2: gradient 2 r n, second derivatives 2 in every direction.
    const double radius = 5;
    const Hessian<double> hessian{2, 2, 2, 0, 0, 0};
    const Vector3<double> normal{0.6, 0, 0.8};
    const double facing = normal.z; // seen along z
    const Vector3<double> tangent{-facing * normal.x, -facing * normal.y, 1 - facing * normal.z};
    EXPECT_NEAR(curvatureAlongView(quadraticForm(hessian, tangent), dot(tangent, tangent), 2 * radius), 1 / radius,
                1e-15);
    EXPECT_EQ(curvatureAlongView(0.0, 0.0, 2 * radius), 0); // along the normal
    EXPECT_EQ(curvatureAlongView(1.0, 1.0, 0.0), 0);        // no gradient
}

TEST(Curvature, QuadraticFormIsTheDirectionalSecondDerivative) {
    // f = x^2 + 3 y^2 - z^2 + 5 x y - x z + 2 y z, so t' H t = 2 f(t)
    const Hessian<double> hessian{2, 6, -2, 5, -1, 2};
    const Vector3<double> t{0.3, -0.7, 1.1};
    const double f = t.x * t.x + 3 * t.y * t.y - t.z * t.z + 5 * t.x * t.y - t.x * t.z + 2 * t.y * t.z;
    EXPECT_NEAR(quadraticForm(hessian, t), 2 * f, 1e-15);
}

TEST(Curvature, KnowsNoLengths) {
    const Vector3<double> a{0.3, 0.4, 0.5};
    const Vector3<double> b{0.31, 0.38, 0.52};
    const double expected = curvatureOfNormals<double>(a, b, 2);
    EXPECT_NEAR(curvatureOfNormals<double>(scaled(a, 1e20), scaled(b, 1e-20), 2), expected, 1e-13 * expected);
    EXPECT_NEAR(curvatureOfNormals<double>(scaled(a, 1e-20), scaled(b, 1e20), 2), expected, 1e-13 * expected);
}

TEST(Transparency, TakesAnUnclampedCosineAndGradient) {
    EXPECT_EQ(illustrativeOpacity(1.0, 0.25, 1 + 1e-6, 0.0, 0.0), illustrativeOpacity(1.0, 0.25, 1.0, 0.0, 0.0));
    EXPECT_EQ(illustrativeOpacity(1.0, 0.25, 0.9, 0.0, 3.0), 0.5);
    EXPECT_EQ(illustrativeOpacity(1.0, kNaN, 0.9, 0.0, 0.5), 0); // what has no opacity is not seen
}

TEST(Measures, StayInTheirRanges) {
    EXPECT_EQ(intensityImportance(1.5), 1);
    EXPECT_EQ(intensityImportance(-0.5), 0);
    EXPECT_EQ(gradientImportance(0.25), 0.25);
    EXPECT_EQ(gradientImportance(2.0), 1);
    EXPECT_EQ(extinctionImportance(-3.0), 0);
    EXPECT_EQ(extinctionImportance(kInfinity), std::log1p(kGreatestExtinction)); // an opaque sample
    EXPECT_EQ(unocclusionImportance(0.0), 20);
    EXPECT_EQ(unocclusionImportance(5.0), 15);
    EXPECT_EQ(unocclusionImportance(kInfinity), 0);
    EXPECT_EQ(silhouetteDarkening(0.0), 1);
    EXPECT_NEAR(silhouetteDarkening(1.0), std::exp(-4.0), 1e-17);
}

TEST(Measures, EqualEdgesAreAStep) {
    EXPECT_EQ(silhouetteness<double>(1, 0.5, {1.7, 0.5, 0.5}), 1);
    EXPECT_EQ(silhouetteness<double>(1, 0.5 + 1e-9, {1.7, 0.5, 0.5}), 0);
    EXPECT_EQ(silhouetteness<double>(0, 0, {1.7, 0.4, 1}), 0);
    EXPECT_EQ(silhouetteness<double>(0, 0, {0, 0.4, 1}), 1);
}

TEST(Measures, TheirSumIsBounded) {
    EXPECT_EQ(totalImportance(2.0, 3.0), 6);
    EXPECT_EQ(totalImportance(100.0, 3.0), 64);
    EXPECT_EQ(totalImportance(1.0, -3.0), 0);
    EXPECT_EQ(totalImportance(kNaN, 3.0), 0);
    EXPECT_EQ(totalImportance(kInfinity, 3.0), 0);
}

TEST(Measures, WhatCannotBeSeenIsNotImportant) {
    EXPECT_EQ(importanceOfVisible(5.0, 0.02, 0.02), 0);
    EXPECT_NEAR(importanceOfVisible(5.0, 0.05, 0.02), 2.5, 1e-15);
    EXPECT_EQ(importanceOfVisible(5.0, 0.08, 0.02), 5);
    EXPECT_EQ(importanceOfVisible(5.0, 0.0, 0.0), 5);
}

TEST(Lighting, DropsTheHighlightWhereLightAndViewAreOpposite) {
    const auto none = halfwayDirection<double>({0, 0, -1}, {0, 0, 1});
    EXPECT_EQ(dot(none, none), 0);
    const auto half = halfwayDirection<double>({1, 0, 0}, {0, 0, 1});
    EXPECT_NEAR(half.x, std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(half.z, std::sqrt(0.5), 1e-15);
}

TEST(Lighting, PowersAreExact) {
    for (const unsigned exponent : {0U, 1U, 2U, 5U, 30U, 50U}) {
        EXPECT_NEAR(wholePower(0.97, exponent), std::pow(0.97, exponent), 1e-15);
        EXPECT_EQ(wholePower(0.0, exponent), exponent == 0 ? 1 : 0);
    }
    EXPECT_NEAR(lightingImportance(0.9, 0.5, 0.25, {2, 1, 3}), 3 - 0.81 - 0.5 - 0.421875, 1e-15);
}

TEST(MipLevel, TurnIsHowFarThePlaceOnTheSphereMoves) {
    // Across a ball of radius 20 the place of the next ray is f / 20 farther on, at the middle and near the rim.
    constexpr double radius = 20;
    constexpr double footprint = 0.5;
    for (const double x : {0.0, 5.0, 12.0, 18.0}) {
        const auto at = [&](double across) {
            const Vector3<double> normal = {across / radius, 0, std::sqrt(1 - across * across / (radius * radius))};
            return litSpherePoint(normal).x;
        };
        EXPECT_NEAR(at(x + footprint) - at(x), turnOverFootprint(footprint, -1 / radius), 1e-12) << x;
    }
    EXPECT_EQ(turnOverFootprint(footprint, 0.0), footprint / kStructureVoxels);
}

TEST(MipLevel, GrowsByOneForEveryDoubling) {
    EXPECT_EQ(mipLevel(16.0, 2.0, 0.0), 0); // a texel a ray
    EXPECT_EQ(mipLevel(16.0, 4.0, 0.0), 1);
    EXPECT_EQ(mipLevel(16.0, 16.0, 0.0), 3);
    EXPECT_EQ(mipLevel(16.0, 2.0, 0.25), 3);
    EXPECT_EQ(mipLevel(32.0, 2.0, 0.25), 4);
    EXPECT_EQ(mipLevel(2.0, 4.0, 0.0), 0); // never finer than the finest
}

TEST(MipLevel, BeginsWhereRaysAreWiderThanVoxels) {
    for (const double footprint : {0.0, 0.3, 1.0}) {
        EXPECT_EQ(mipLevel(200.0, footprint, 0.5), 0);
    }
    double last = 0;
    for (double footprint = 1; footprint < 3; footprint += 1e-3) { // and nothing jumps
        const double level = mipLevel(200.0, footprint, 0.5);
        EXPECT_GE(level, last);
        EXPECT_LT(level - last, 0.02);
        last = level;
    }
    EXPECT_EQ(mipLevel(200.0, 2.0, kInfinity), kInfinity); // the chain's end, to be clamped
}

TEST(Lens, FallsOffFromItsMiddle) {
    EXPECT_EQ(circularLens(4.0, 0.18, 0.18), 4);
    EXPECT_EQ(circularLens(4.0, 0.1801, 0.18), 0);
    EXPECT_EQ(gaussianLens(4.0, 0.0, 0.18), 4);
    EXPECT_NEAR(gaussianLens(4.0, 0.09, 0.18), 4 * std::exp(-0.5), 1e-15); // one sigma
    EXPECT_EQ(gaussianLens(4.0, 0.0, 0.0), 0);
}

struct Sample {
    double colour, opacity, importance;
};

ImportanceState<double> cast(const std::vector<Sample>& samples) {
    auto ray = startOfRay<double>();
    for (const Sample& s : samples) {
        ray = withSample<double>(ray, {s.colour, s.colour, s.colour}, s.opacity, s.importance);
    }
    return ray;
}

std::vector<Sample> randomRay(std::mt19937& random, int count, double spread) {
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<Sample> samples;
    for (int i = 0; i < count; ++i) {
        samples.push_back({unit(random), unit(random) * unit(random), spread * unit(random)});
    }
    return samples;
}

/// The paper's own form (importance-composition.md), which is good in double while importances are small.
Sample published(const std::vector<Sample>& samples) {
    double colour = 0;
    double opacity = 0;
    double importance = 0;
    for (const auto& [c, a, s] : samples) {
        const double rest = s <= importance ? 1 : std::exp(importance - s);
        const double m = opacity <= rest ? 1 : rest / opacity;
        const double mixedColour = m * colour + (1 - m * opacity) * a * c;
        const double mixedOpacity = m * opacity * (1 - a) + a;
        opacity = opacity * (1 - a) + a;
        colour = mixedOpacity > 0 ? opacity / mixedOpacity * mixedColour : 0;
        if (s > importance) {
            importance = std::max(importance, s + std::log(a + (1 - a) * std::exp(importance - s)));
        }
    }
    return {colour, opacity, importance};
}

TEST(Importance, IsThePublishedComposition) {
    std::mt19937 random(1);
    for (int i = 0; i < 500; ++i) {
        const auto samples = randomRay(random, 12, i % 6);
        const auto ray = cast(samples);
        const Sample expected = published(samples);
        EXPECT_NEAR(composed(ray).g, expected.colour, 1e-12);
        EXPECT_NEAR(composed(ray).a, expected.opacity, 1e-14);
        EXPECT_NEAR(importanceSoFar(ray), expected.importance, 1e-13);
    }
}

TEST(Importance, IsTheSameWithExponentials) {
    std::mt19937 random(11);
    const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
    for (int ray = 0; ray < 2000; ++ray) {
        ImportanceState<double> state = startOfRay<double>();
        ExponentialState<double> scaled{0, 1};
        for (int k = 0; k < 40; ++k) {
            const double opacity = std::pow(unit(), 4);
            const double importance = kGreatestImportance * unit() * unit();
            const double kept = stepOfSample(state, opacity, importance).kept;
            state = withSample<double>(state, {unit(), unit(), unit()}, opacity, importance);
            ASSERT_NEAR(keptBehind(scaled, opacity, std::exp(importance)), kept, 1e-11);
            ASSERT_NEAR(scaled.opacity, state.opacity, 1e-12);
            ASSERT_NEAR(std::log(scaled.exponential), importanceSoFar(state), 1e-10);
        }
        const double background = kGreatestImportance * unit();
        EXPECT_NEAR(shareBeforeBackground(state, background),
                    std::min(state.opacity, std::exp(importanceSoFar(state) - background)), 1e-12);
    }
}

TEST(Importance, StaysBetweenTheColoursForAnyImportance) {
    std::mt19937 random(2);
    for (const double spread : {1.0, 700.0, 1e6, 1e300}) {
        const auto ray = cast(randomRay(random, 200, spread));
        EXPECT_GE(ray.colour.r, 0);
        EXPECT_LE(ray.colour.r, 1);
        EXPECT_GT(ray.share, 0);
        EXPECT_LE(ray.share, 1);
        EXPECT_TRUE(std::isfinite(importanceSoFar(ray)));
    }
}

TEST(Importance, KeepsAtLeastItsCertainShare) {
    std::mt19937 random(3);
    double tightest = 1;
    for (int i = 0; i < 2000; ++i) {
        auto samples = randomRay(random, 8, 1 + i % 8);
        const std::size_t seen = 1 + random() % 7;
        double ahead = 0;
        for (std::size_t k = 0; k < samples.size(); ++k) {
            samples[k].colour = k < seen ? 1 : 0;
            ahead = k < seen ? ahead : std::max(ahead, samples[k].importance);
        }
        const double certain = certainShare(cast({samples.begin(), samples.begin() + static_cast<long>(seen)}), ahead);
        const double kept = composed(cast(samples)).r;
        EXPECT_GE(kept, certain - 1e-14);
        tightest = std::min(tightest, kept - certain);
    }
    EXPECT_LT(tightest, 1e-3); // the bound says something
    // An opaque ray is not done while something important is ahead, and is where nothing is.
    const auto opaque = cast({{1, 1, 0}});
    EXPECT_NEAR(certainShare(opaque, 3.0), std::exp(-3.0), 1e-16);
    EXPECT_EQ(certainShare(opaque, 0.0), 1);
    EXPECT_EQ(certainShare(opaque, 1e6), 0);
    EXPECT_EQ(certainShare(cast({{1, 1, 1e6}}), 0.0), 1);
}

TEST(Stipple, CountsPointsByTheArea) { // numerics.md 2e
    EXPECT_NEAR(mostPoints<double>(1, 512 * 512, {256, 256, 256}), 4, 1e-12);
    EXPECT_NEAR(mostPoints<double>(1, 512 * 512, {512, 512, 1}), 64, 1e-11);
    EXPECT_NEAR(mostPoints<double>(1, 512 * 512, {512, 512, 0.1}), 64, 1e-11);
    EXPECT_NEAR(mostPoints<double>(4, 8192.0 * 8192, {2048, 2048, 2048}), 64, 1e-11);
    EXPECT_EQ(mostPoints<double>(4, 0, {2048, 2048, 2048}), 0);
    EXPECT_EQ(mostPoints<double>(4, -1, {2048, 2048, 2048}), 0);
}

TEST(Stipple, FactorsStayInTheirRange) {
    EXPECT_EQ(boundaryFactor<double>(1, 1, {0.9, 0.9, 1}), 1);
    EXPECT_EQ(silhouetteFactor<double>(1, 1 + 1e-7, {0, 1, 0.5}), 0); // |n.e| over 1 by rounding
    EXPECT_EQ(silhouetteFactor<double>(1, -0.6, {0, 1, 1}), silhouetteFactor<double>(1, 0.6, {0, 1, 1}));
    EXPECT_EQ(resolutionFactor(kInfinity, 1.0, 1.0, 2.0), 1);
    EXPECT_EQ(distanceFactor(0.5, 1.0, 0.0), 1);
    double before = 0;
    for (double depth = -1; depth <= 1; depth += 0.125) { // the nearer the more, for an even exponent too
        const double factor = distanceFactor(depth, 1.0, 2.0);
        EXPECT_GE(factor, before);
        EXPECT_LE(factor, 1);
        before = factor;
    }
}

} // namespace
} // namespace limner::optics
