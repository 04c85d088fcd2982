#include "core/volume/derived_fields.h"

#include "support/make_volume.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace limner {
namespace {

using testing::gridOf;
using testing::makeVolume;

std::shared_ptr<const Volume> blurred(const Volume& source, const glm::dvec3& sigma) {
    Task task;
    return gaussianBlurred(source, sigma, task);
}

TEST(GaussianBlurred, WidensAGaussianByItsVariance) {
    // Gaussians convolve to one of the added variances: a closed form, met by sampled ones wider than a voxel.
    const glm::dvec3 sigma(1, 1.5, 2.5);
    const double ball = 3;
    const glm::ivec3 middle(20, 22, 25);
    const auto source = makeVolume<std::int16_t>(
        gridOf({41, 45, 51}), VoxelType::int16,
        [&](glm::ivec3 v) {
            const glm::dvec3 d = v - middle;
            return std::lround(30000 * std::exp(-0.5 * (d.x * d.x + d.y * d.y + d.z * d.z) / (ball * ball)));
        },
        0.5, -100);
    const auto result = blurred(*source, sigma);
    EXPECT_EQ(result->type(), VoxelType::int16);
    EXPECT_EQ(result->grid(), source->grid());
    const glm::dvec3 wide = glm::sqrt(sigma * sigma + ball * ball);
    for (const glm::ivec3 offset : {glm::ivec3(0), glm::ivec3(3, 0, 0), glm::ivec3(0, -4, 2), glm::ivec3(-5, 4, -6)}) {
        const glm::dvec3 d = glm::dvec3(offset) / wide;
        const double expected = -100 + 15000 * (ball / wide.x) * (ball / wide.y) * (ball / wide.z) *
                                           std::exp(-0.5 * (d.x * d.x + d.y * d.y + d.z * d.z));
        // Three kernels cut at 4 sigma lose up to 6e-5 each, the voxels were rounded to 0.5.
        EXPECT_NEAR(result->valueAt(middle + offset), expected, 3 * 6.4e-5 * 15000);
    }
}

TEST(GaussianBlurred, RepeatsTheBorder) {
    // Symmetric about the border's face the kernel sees a constant; a ramp shows that the border voxel repeats.
    const auto source = makeVolume<float>(gridOf({12, 1, 1}), VoxelType::float32, [](glm::ivec3 v) { return v.x; });
    const auto result = blurred(*source, glm::dvec3(1));
    ASSERT_EQ(result->type(), VoxelType::float32);
    double sum = 0;
    double weights = 0;
    for (int k = -4; k <= 4; ++k) {
        const double weight = std::exp(-0.5 * k * k);
        sum += weight * std::max(0, k);
        weights += weight;
    }
    EXPECT_NEAR(result->valueAt({0, 0, 0}), sum / weights, 1e-6);
    EXPECT_NEAR(result->valueAt({11, 0, 0}), 11 - sum / weights, 1e-5);
    EXPECT_NEAR(result->valueAt({6, 0, 0}), 6, 1e-5);
}

TEST(GaussianBlurred, SigmaZeroLeavesAnAxisAlone) {
    const auto source = makeVolume<std::uint8_t>(gridOf({20, 30, 10}), VoxelType::uint8,
                                                 [](glm::ivec3 v) { return v == glm::ivec3(9, 14, 5) ? 255 : 0; });
    const auto alongY = blurred(*source, {0, 2, 0});
    EXPECT_GT(alongY->valueAt({9, 16, 5}), 10);
    EXPECT_EQ(alongY->valueAt({8, 14, 5}), 0);
    EXPECT_EQ(alongY->valueAt({9, 14, 6}), 0);
    const auto same = blurred(*source, glm::dvec3(0));
    EXPECT_NEAR(same->valueAt({9, 14, 5}), 255, 1e-9);
    EXPECT_EQ(same->valueAt({9, 15, 5}), 0);
    const auto hardly = blurred(*source, glm::dvec3(1e-200));
    EXPECT_NEAR(hardly->valueAt({9, 14, 5}), 255, 1e-9);
}

} // namespace
} // namespace limner
