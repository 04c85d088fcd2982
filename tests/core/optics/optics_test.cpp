#include "core/optics/opacity.h"
#include "core/optics/shading.h"
#include "support/test_data.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <random>

namespace limner::optics {
namespace {

using Vector = Vector3<double>;

Vector randomDirection(std::mt19937& random) {
    std::normal_distribution<double> normal;
    const Vector v{normal(random), normal(random), normal(random)};
    return scaled(v, 1 / std::sqrt(dot(v, v)));
}

TEST(Opacity, AgreesWithTheSixtyDigitVectors) {
    const auto file = testing::testData("../spec/vectors/vectors.jsonl");
    if (!file) {
        GTEST_SKIP();
    }
    std::ifstream lines(*file);
    int count = 0;
    for (std::string line; std::getline(lines, line);) {
        const auto vector = nlohmann::json::parse(line);
        if (vector["f"] != "opacity_per_length") {
            continue;
        }
        ++count;
        const double expected = vector["out"][0];
        const double actual = opacityOfLength<double>(vector["in"][0], vector["in"][1]);
        EXPECT_NEAR(actual, expected, 1e-12 * expected) << line; // the vectors' own bound for double
    }
    EXPECT_GT(count, 0);
}

TEST(Opacity, KeepsItsEnds) {
    EXPECT_EQ(opacityOfLength(1.0, 1e-9), 1);
    EXPECT_EQ(opacityOfLength(1.0, 7.0), 1);
    EXPECT_EQ(opacityOfLength(1.0, 0.0), 0);
    EXPECT_EQ(opacityOfLength(0.3, 0.0), 0);
    EXPECT_EQ(opacityOfLength(0.0, 5.0), 0);
    EXPECT_EQ(opacityOfDepth(opticalDepth(1.0)), 1);
    EXPECT_EQ(opticalDepth(0.0), 0);
}

TEST(Opacity, SplittingALengthChangesNothing) {
    for (const double opacity : {1e-9, 0.01, 0.5, 0.999}) {
        Accumulated<double> whole = compositeBehind<double>({0, 0, 0, 0}, {1, 0.5, 0.25}, opacity);
        Accumulated<double> parts{0, 0, 0, 0};
        for (int i = 0; i < 7; ++i) {
            parts = compositeBehind<double>(parts, {1, 0.5, 0.25}, opacityOfLength(opacity, 1.0 / 7));
        }
        EXPECT_NEAR(parts.a, whole.a, 1e-15);
        EXPECT_NEAR(parts.g, whole.g, 1e-15);
    }
}

TEST(Normal, IsUnitForAnyFiniteGradient) {
    for (const double size : {1e-300, 1e-160, 1e-20, 1.0, 1e20, 1e160, 1e300}) {
        const Vector n = normalFromGradient<double>({2 * size, -1 * size, 2 * size});
        EXPECT_NEAR(n.x, -2.0 / 3, 1e-15);
        EXPECT_NEAR(n.y, 1.0 / 3, 1e-15);
        EXPECT_NEAR(n.z, -2.0 / 3, 1e-15);
    }
    const Vector none = normalFromGradient<double>({0, 0, 0});
    EXPECT_EQ(none.x, 0);
    EXPECT_EQ(none.y, 0);
    EXPECT_EQ(none.z, 0);
}

TEST(Normal, TheRayFrameIsARotationThatTakesTheRayToTheViewDirection) {
    std::mt19937 random(1);
    for (int i = 0; i < 1000; ++i) {
        Vector ray = randomDirection(random);
        ray.z = -std::abs(ray.z);
        const Vector turned = normalInRayFrame(ray, ray);
        EXPECT_NEAR(turned.x, 0, 1e-15);
        EXPECT_NEAR(turned.y, 0, 1e-15);
        EXPECT_NEAR(turned.z, -1, 1e-15);
        const Vector a = randomDirection(random);
        const Vector b = randomDirection(random);
        const Vector a1 = normalInRayFrame(a, ray);
        const Vector b1 = normalInRayFrame(b, ray);
        EXPECT_NEAR(dot(a1, b1), dot(a, b), 1e-14);
        // The shortest rotation leaves the axis perpendicular to both directions alone.
        const double length = std::hypot(ray.x, ray.y);
        const Vector axis{-ray.y / length, ray.x / length, 0};
        const Vector axis1 = normalInRayFrame(axis, ray);
        EXPECT_NEAR(dot(axis, axis1), 1, 1e-14);
    }
}

TEST(Normal, AnOrthographicRayLeavesItAlone) {
    const Vector n{0.6, -0.64, 0.48};
    const Vector same = normalInRayFrame<double>(n, {0, 0, -1});
    EXPECT_EQ(same.x, n.x);
    EXPECT_EQ(same.y, n.y);
    EXPECT_EQ(same.z, n.z);
}

TEST(Normal, ASilhouetteReachesTheRimInPerspective) {
    // A normal at right angles to a slanted ray lands on the rim of the lit sphere.
    const double s = std::sqrt(0.5);
    const auto point = litSpherePoint(normalInRayFrame<double>({s, 0, s}, {s, 0, -s}));
    EXPECT_NEAR(point.x, 1, 1e-15);
    EXPECT_NEAR(point.y, 0, 1e-15);
}

TEST(Normal, FacesTheViewerWhenTwoSided) {
    const Vector back = facingViewer<double>({0.6, 0, -0.8});
    EXPECT_EQ(back.x, -0.6);
    EXPECT_EQ(back.z, 0.8);
    const Vector front = facingViewer<double>({0.6, 0, 0.8});
    EXPECT_EQ(front.x, 0.6);
}

TEST(Normal, RoundingNeverLeavesTheDisk) {
    const auto point = litSpherePoint<double>({0.8 * (1 + 1e-7), 0.6 * (1 + 1e-7), 0});
    EXPECT_LE(std::hypot(point.x, point.y), 1 + 1e-15);
}

TEST(GradientFloor, BlendsBetweenOnceAndTwiceTheFloor) {
    EXPECT_EQ(normalDefinedness(0.5, 1.0), 0);
    EXPECT_EQ(normalDefinedness(1.0, 1.0), 0);
    EXPECT_EQ(normalDefinedness(1.5, 1.0), 0.5);
    EXPECT_EQ(normalDefinedness(2.0, 1.0), 1);
    EXPECT_EQ(normalDefinedness(0.0, 0.0), 0);
    EXPECT_EQ(normalDefinedness(1e-300, 0.0), 1);
}

TEST(Phong, IsTheHeadLightLaw) {
    const PhongTerms<double> terms{0.1, 0.7, 0.2, 10};
    const Colour<double> bone{0.9, 0.8, 0.7};
    for (const double cosine : {0.0, 0.3, 0.8, 1.0}) {
        const double expected = 0.8 * (0.1 + 0.7 * cosine) + 0.2 * std::pow(cosine, 10);
        EXPECT_NEAR(phong(bone, facing(cosine, true), terms).g, std::min(1.0, expected), 1e-15);
        EXPECT_EQ(phong(bone, facing(-cosine, true), terms).g, phong(bone, facing(cosine, true), terms).g);
        EXPECT_NEAR(phong(bone, facing(-cosine, false), terms).g, 0.08, 1e-15); // a back face: ambient alone
    }
    EXPECT_EQ(phong<double>({1, 1, 1}, 1, {0.1, 0.7, 0.5, 10}).r, 1);
}

/// Four lanes that know nothing of branches: shows that the formulas take a vector type.
struct Lanes {
    std::array<double, 4> v{};
    Lanes() = default;
    explicit Lanes(double x) { v.fill(x); }
};
struct LaneMask {
    std::array<bool, 4> m{};
};
template <typename F>
Lanes perLane(const Lanes& a, const Lanes& b, F f) {
    Lanes out;
    for (std::size_t i = 0; i < 4; ++i) {
        out.v[i] = f(a.v[i], b.v[i]);
    }
    return out;
}
template <typename F>
LaneMask compareLanes(const Lanes& a, const Lanes& b, F f) {
    LaneMask out;
    for (std::size_t i = 0; i < 4; ++i) {
        out.m[i] = f(a.v[i], b.v[i]);
    }
    return out;
}
Lanes operator+(const Lanes& a, const Lanes& b) { return perLane(a, b, std::plus<>()); }
Lanes operator-(const Lanes& a, const Lanes& b) { return perLane(a, b, std::minus<>()); }
Lanes operator*(const Lanes& a, const Lanes& b) { return perLane(a, b, std::multiplies<>()); }
Lanes operator/(const Lanes& a, const Lanes& b) { return perLane(a, b, std::divides<>()); }
Lanes operator-(const Lanes& a) {
    return perLane(a, a, [](double x, double) { return -x; });
}
LaneMask operator<(const Lanes& a, const Lanes& b) { return compareLanes(a, b, std::less<>()); }
LaneMask operator>(const Lanes& a, const Lanes& b) { return compareLanes(a, b, std::greater<>()); }
LaneMask operator>=(const Lanes& a, const Lanes& b) { return compareLanes(a, b, std::greater_equal<>()); }
Lanes select(const LaneMask& mask, const Lanes& yes, const Lanes& no) {
    Lanes out;
    for (std::size_t i = 0; i < 4; ++i) {
        out.v[i] = mask.m[i] ? yes.v[i] : no.v[i];
    }
    return out;
}
Lanes min(const Lanes& a, const Lanes& b) {
    return perLane(a, b, [](double x, double y) { return std::min(x, y); });
}
Lanes max(const Lanes& a, const Lanes& b) {
    return perLane(a, b, [](double x, double y) { return std::max(x, y); });
}
Lanes pow(const Lanes& a, const Lanes& b) {
    return perLane(a, b, [](double x, double y) { return std::pow(x, y); });
}
Lanes abs(const Lanes& a) {
    return perLane(a, a, [](double x, double) { return std::abs(x); });
}
Lanes sqrt(const Lanes& a) {
    return perLane(a, a, [](double x, double) { return std::sqrt(x); });
}
Lanes expm1(const Lanes& a) {
    return perLane(a, a, [](double x, double) { return std::expm1(x); });
}
Lanes log1p(const Lanes& a) {
    return perLane(a, a, [](double x, double) { return std::log1p(x); });
}

TEST(Optics, TakesAVectorType) {
    Lanes alpha;
    alpha.v = {0, 1, 0.25, 1e-9};
    const Lanes corrected = opacityOfLength(alpha, Lanes(0.5));
    Vector3<Lanes> gradient{Lanes(1), Lanes(2), Lanes(0)};
    gradient.x.v[0] = 0;
    gradient.y.v[0] = 0;
    const auto normal = normalFromGradient(gradient);
    const auto turned = facingViewer(normalInRayFrame(normal, {Lanes(0.6), Lanes(0), Lanes(-0.8)}));
    const auto point = litSpherePoint(turned);
    const auto lit =
        phong<Lanes>({Lanes(0.5), Lanes(0.5), Lanes(0.5)}, turned.z, {Lanes(0.1), Lanes(0.7), Lanes(0.2), Lanes(10)});
    for (std::size_t i = 0; i < 4; ++i) {
        const double one = opacityOfLength(alpha.v[i], 0.5);
        EXPECT_EQ(corrected.v[i], one);
        EXPECT_EQ(normalDefinedness(alpha, Lanes(0.2)).v[i], normalDefinedness(alpha.v[i], 0.2));
        const Vector n = normalFromGradient<double>({gradient.x.v[i], gradient.y.v[i], gradient.z.v[i]});
        const Vector t = facingViewer(normalInRayFrame<double>(n, {0.6, 0, -0.8}));
        EXPECT_EQ(point.x.v[i], litSpherePoint(t).x);
        EXPECT_EQ(lit.g.v[i], phong<double>({0.5, 0.5, 0.5}, t.z, {0.1, 0.7, 0.2, 10}).g);
    }
}

} // namespace
} // namespace limner::optics
