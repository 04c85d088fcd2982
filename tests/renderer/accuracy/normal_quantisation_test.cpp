#include "renderer/accuracy/normal_quantisation.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace limner::accuracy {
namespace {

TEST(NormalQuantisation, TheDirectionsAreThoseOfTheDividedSolids) {
    const auto& all = quantisedDirections();
    ASSERT_EQ(all.size(), 240U);
    glm::dvec3 sum(0);
    for (const glm::dvec3& one : all) {
        EXPECT_NEAR(glm::length(one), 1, 1e-12);
        sum += one;
        const auto near = [&](const glm::dvec3& to) {
            return std::count_if(all.begin(), all.end(),
                                 [&](const glm::dvec3& other) { return glm::distance(other, to) < 1e-9; });
        };
        EXPECT_EQ(near(one), 1) << "no two are the same";
        EXPECT_EQ(near(-one), 1) << "the solids look the same from behind";
        EXPECT_EQ(near({one.y, one.z, one.x}), 1) << "and turned by a third";
    }
    EXPECT_LT(glm::length(sum), 1e-9);
}

TEST(NormalQuantisation, ANormalGoesToTheNearest) {
    for (const glm::dvec3& one : quantisedDirections()) {
        EXPECT_EQ(quantisedNormal(one), one);
        EXPECT_EQ(quantisedNormal(glm::normalize(one + glm::dvec3(0.01, -0.005, 0.002))), one);
    }
}

TEST(NormalQuantisation, TheErrorOfTheAngle) {
    const NormalQuantisationError error = measureNormalQuantisation(20000);
    std::cout << "240 directions: mean error " << error.meanDeg << " deg, largest " << error.largestDeg << " deg\n";
    // No 240 directions do better than disks of a 240th of the sphere: radius 7.40 deg, mean 2/3 of that.
    EXPECT_GT(error.meanDeg, 4.93);
    EXPECT_GT(error.largestDeg, 7.40);
    EXPECT_LT(error.meanDeg, 6);
    EXPECT_LT(error.largestDeg, 12);
    const NormalQuantisationError finer = measureNormalQuantisation(80000);
    EXPECT_NEAR(finer.meanDeg, error.meanDeg, 0.01);
    EXPECT_NEAR(finer.largestDeg, error.largestDeg, 1e-9) << "it is exact, whatever the points";
}

TEST(NormalQuantisation, TheErrorOfTheColour) {
    constexpr int kSize = 256;
    const LitSphere plain(kSize, std::vector<Rgba>(kSize * kSize, Rgba{0.3F, 0.5F, 0.7F, 1}));
    EXPECT_NEAR(measureLitSphereError(plain, 100).largest, 0, 1e-6);
    // A ramp across: colour = 1/2 + n_x / 2. The error is half that of n_x, which no chord exceeds.
    std::vector<Rgba> ramp;
    for (int i = 0; i < kSize * kSize; ++i) {
        const auto grey = static_cast<float>((i % kSize + 0.5) / kSize);
        ramp.push_back({grey, grey, grey, 1});
    }
    const LitSphere shaded(kSize, ramp);
    const LitSphereError error = measureLitSphereError(shaded, 200);
    const double chord = 2 * std::sin(measureNormalQuantisation(20000).largestDeg / 2 * 3.14159265358979 / 180);
    std::cout << "240 directions on a ramp: RMS error " << error.rms << ", largest " << error.largest << '\n';
    EXPECT_LE(error.largest, chord / 2 + 0.005); // the rim's texels are continued outward
    EXPECT_GT(error.largest, chord / 2 * 0.8);
    EXPECT_GT(error.rms, 0.01);
    EXPECT_LT(error.rms, error.largest / 2);
}

} // namespace
} // namespace limner::accuracy
