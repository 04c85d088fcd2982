#include "core/volume/gradient_statistics.h"

#include "support/make_volume.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace limner {
namespace {

using testing::gridOf;
using testing::makeVolume;

TEST(GradientStatistics, RampPerMmWithSlopeAndSpacing) {
    Grid grid = gridOf({50, 40, 45});
    grid.spacingMm = {0.5, 2, 4};
    // 6 stored units per voxel of 2 mm along y, slope -3: 9 per mm.
    const auto volume = makeVolume<std::int16_t>(
        grid, VoxelType::int16, [](glm::ivec3 v) { return 6 * v.y; }, -3, 5);
    const GradientStatistics g = computeGradientStatistics(*volume);
    EXPECT_NEAR(g.p999, 9, 1e-5);
    EXPECT_NEAR(g.noise, 0, 1e-5); // a clean ramp has no noise
}

TEST(GradientStatistics, PercentileLeavesHotVoxelsOut) {
    const auto volume = makeVolume<float>(gridOf({100, 100, 50}), VoxelType::float32,
                                          [](glm::ivec3 v) { return v == glm::ivec3(50, 50, 25) ? 1e6 : 2.0 * v.x; });
    EXPECT_NEAR(computeGradientStatistics(*volume).p999, 2, 1e-4);
}

TEST(GradientStatistics, MeasuresNoiseOfFlatMatterOnly) {
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0, 20);
    const auto volume = makeVolume<std::int16_t>(gridOf({96, 96, 96}), VoxelType::int16, [&](glm::ivec3 v) {
        const double d = std::hypot(v.x - 48, v.y - 48, v.z - 48);
        return d < 40 ? std::lround(1000 + noise(random)) : -1000;
    });
    // A central difference of white noise has sigma 20 / sqrt(2); the median length of three such is 1.538 sigma.
    const double expected = 20 / std::sqrt(2.0) * 1.538;
    // 10 %: the estimate's three differences share the middle voxel, which shifts the median by 7 %.
    EXPECT_NEAR(computeGradientStatistics(*volume).noise, expected, 0.1 * expected);
}

TEST(GradientStatistics, ConstantAndFlatVolumesHaveNone) {
    const auto constant = makeVolume<std::uint8_t>(gridOf({9, 9, 1}), VoxelType::uint8, [](glm::ivec3) { return 3; });
    EXPECT_EQ(computeGradientStatistics(*constant).p999, 0);
    EXPECT_EQ(computeGradientStatistics(*constant).noise, 0);
    const auto slice =
        makeVolume<std::uint8_t>(gridOf({64, 64, 1}), VoxelType::uint8, [](glm::ivec3 v) { return v.x; });
    EXPECT_NEAR(computeGradientStatistics(*slice).p999, 1, 1e-6);
}

TEST(GradientStatistics, SparseVolumeStillHasAScale) {
    const auto volume = makeVolume<std::uint8_t>(gridOf({100, 100, 100}), VoxelType::uint8, [](glm::ivec3 v) {
        return v.x == 50 && v.y == 50 && v.z < 4 ? 200 : 0; // 4 voxels of a million
    });
    EXPECT_GT(computeGradientStatistics(*volume).p999, 0);
}

} // namespace
} // namespace limner
