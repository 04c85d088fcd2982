#include "core/base/error.h"
#include "core/volume/derived_fields.h"

#include "support/make_volume.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace limner {
namespace {

using testing::gridOf;
using testing::makeVolume;

/// The cubic B-spline at a voxel, read as a backend reads: outside the volume the border repeats.
double splineAtVoxel(const Volume& coefficients, glm::ivec3 voxel) {
    constexpr std::array<double, 3> kWeights = {1.0 / 6, 4.0 / 6, 1.0 / 6};
    double sum = 0;
    for (int z = 0; z < 3; ++z) {
        for (int y = 0; y < 3; ++y) {
            for (int x = 0; x < 3; ++x) {
                sum += kWeights[x] * kWeights[y] * kWeights[z] *
                       coefficients.valueAt(voxel + glm::ivec3(x, y, z) - 1); // valueAt clamps
            }
        }
    }
    return sum;
}

double largestMiss(const Volume& source, const Volume& coefficients) {
    double worst = 0;
    const glm::ivec3 dims = source.grid().dims;
    for (int z = 0; z < dims.z; ++z) {
        for (int y = 0; y < dims.y; ++y) {
            for (int x = 0; x < dims.x; ++x) {
                const glm::ivec3 voxel(x, y, z);
                worst = std::max(worst, std::abs(splineAtVoxel(coefficients, voxel) - source.valueAt(voxel)));
            }
        }
    }
    return worst;
}

std::shared_ptr<const Volume> coefficientsOf(const Volume& source) {
    Task task;
    return splineCoefficients(source, task);
}

/// White noise: the hardest data, its coefficients reach farthest past its own range.
class SplineOfNoise : public ::testing::TestWithParam<std::array<int, 3>> {
  protected:
    glm::ivec3 dims{GetParam()[0], GetParam()[1], GetParam()[2]};
    std::mt19937 random{7};

    /// The weights of the spline are positive and add up to 1: half a step per coefficient is half a step of the sum.
    void expectInterpolates(const Volume& source) {
        const auto coefficients = coefficientsOf(source);
        ASSERT_EQ(coefficients->type(), VoxelType::int16);
        EXPECT_EQ(coefficients->grid(), source.grid());
        const double range = coefficients->range().high - coefficients->range().low;
        EXPECT_LT(std::abs(coefficients->contents().slope), 1.0001 * range / 65535);
        EXPECT_LT(largestMiss(source, *coefficients), 0.51 * std::abs(coefficients->contents().slope));
    }
};

TEST_P(SplineOfNoise, PassesThroughBytes) {
    std::uniform_int_distribution<int> number(0, 255);
    expectInterpolates(*makeVolume<std::uint8_t>(
        gridOf(dims), VoxelType::uint8, [&](glm::ivec3) { return number(random); }, -2.5, 7));
}

TEST_P(SplineOfNoise, PassesThroughShiftedShorts) {
    // Unsigned 16-bit data as they are kept: 60000 .. 60100, far from 0 in the stored count and in value.
    std::uniform_int_distribution<int> number(27232, 27332);
    expectInterpolates(*makeVolume<std::int16_t>(
        gridOf(dims), VoxelType::int16, [&](glm::ivec3) { return number(random); }, 1, 32768));
}

TEST_P(SplineOfNoise, PassesThroughFloats) {
    std::uniform_real_distribution<float> number(0, 1);
    const auto source = makeVolume<float>(
        gridOf(dims), VoxelType::float32, [&](glm::ivec3) { return number(random); }, 1e-4, -3);
    const auto coefficients = coefficientsOf(*source);
    ASSERT_EQ(coefficients->type(), VoxelType::float32);
    EXPECT_EQ(coefficients->contents().slope, 1e-4);
    EXPECT_EQ(coefficients->contents().intercept, -3);
    EXPECT_LT(largestMiss(*source, *coefficients), 1e-6 * 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Sizes, SplineOfNoise,
                         ::testing::Values(std::array{37, 70, 21}, std::array{130, 5, 66}, std::array{2, 3, 4},
                                           std::array{1, 19, 2}, std::array{6, 1, 1}, std::array{5, 40, 1}));

TEST(SplineCoefficients, OfACosineAreTheCosineAmplified) {
    // cos(w (k + 1/2)), w = pi m / n, has the border's symmetry; the filter (1, 4, 1) / 6 scales it by (2 + cos w) / 3.
    const glm::ivec3 dims(24, 40, 17);
    const glm::dvec3 w = std::numbers::pi * glm::dvec3(5, 3, 8) / glm::dvec3(dims);
    const auto field = [&](glm::ivec3 v) {
        return std::cos(w.x * (v.x + 0.5)) * std::cos(w.y * (v.y + 0.5)) * std::cos(w.z * (v.z + 0.5));
    };
    const double gain = 27 / ((2 + std::cos(w.x)) * (2 + std::cos(w.y)) * (2 + std::cos(w.z)));
    const auto source = makeVolume<float>(gridOf(dims), VoxelType::float32, field);
    const auto coefficients = coefficientsOf(*source);
    for (const glm::ivec3 voxel : {glm::ivec3(0), glm::ivec3(5, 20, 16), dims - 1, glm::ivec3(23, 0, 8)}) {
        EXPECT_NEAR(coefficients->valueAt(voxel), gain * field(voxel), 3e-6);
    }
}

TEST(SplineCoefficients, OfAConstantAreTheConstant) {
    const auto source = makeVolume<std::int16_t>(
        gridOf({9, 8, 7}), VoxelType::int16, [](glm::ivec3) { return 1234; }, 0.5, 10);
    const auto coefficients = coefficientsOf(*source);
    EXPECT_NE(coefficients->contents().slope, 0);
    EXPECT_EQ(coefficients->range(), (ValueRange{627, 627}));
    EXPECT_EQ(coefficients->valueAt({4, 4, 4}), 627);
    EXPECT_EQ(coefficients->valueAt({0, 7, 0}), 627);
}

TEST(SplineCoefficients, AxisOfOneVoxelStaysUnchanged) {
    const auto source = makeVolume<std::uint8_t>(gridOf({1, 1, 1}), VoxelType::uint8, [](glm::ivec3) { return 77; });
    EXPECT_EQ(coefficientsOf(*source)->valueAt({0, 0, 0}), 77);
}

TEST(SplineCoefficients, StopsWhenCancelled) {
    const auto source = makeVolume<std::uint8_t>(gridOf({9, 9, 9}), VoxelType::uint8, [](glm::ivec3 v) { return v.x; });
    Task task;
    task.cancel();
    try {
        splineCoefficients(*source, task);
        FAIL() << "went on after it was cancelled";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::cancelled);
    }
}

TEST(SplineCoefficients, AreTheSameEveryTime) {
    std::mt19937 random(1);
    const auto source =
        makeVolume<std::uint8_t>(gridOf({70, 65, 40}), VoxelType::uint8, [&](glm::ivec3) { return random() & 255U; });
    const auto first = coefficientsOf(*source);
    const auto second = coefficientsOf(*source);
    EXPECT_TRUE(std::equal(first->bricks(), first->bricks() + first->bytes() - 2 * BrickLayout::kStorePaddingBytes,
                           second->bricks()));
}

} // namespace
} // namespace limner
