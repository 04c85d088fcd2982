#include "core/volume/joint_histogram.h"

#include "core/base/error.h"
#include "support/make_volume.h"

#include <gtest/gtest.h>

#include <numeric>

namespace limner {
namespace {

using testing::gridOf;
using testing::makeVolume;

std::uint64_t total(const JointHistogram& joint) {
    return std::accumulate(joint.counts.begin(), joint.counts.end(), std::uint64_t{0});
}

/// Four voxels, each pair of values known.
TEST(JointHistogram, CountsPairsOfTwoVolumes) {
    const auto a =
        makeVolume<std::uint8_t>(gridOf({2, 2, 1}), VoxelType::uint8, [](glm::ivec3 v) { return v.x == 0 ? 0 : 10; });
    const auto b = makeVolume<std::uint8_t>(gridOf({2, 2, 1}), VoxelType::uint8,
                                            [](glm::ivec3 v) { return v.x + v.y == 2 ? 7 : 1; });
    Task task;
    const JointHistogram joint = jointHistogram(*a, {{0, 10}, 2}, *b, {{0, 8}, 4}, task);
    ASSERT_EQ(joint.columns, 2);
    ASSERT_EQ(joint.rows, 4);
    EXPECT_EQ(joint.at(0, 0), 2U); // x = 0: value 0 with 1
    EXPECT_EQ(joint.at(1, 0), 1U); // (1, 0): value 10, the upper end, with 1
    EXPECT_EQ(joint.at(1, 3), 1U); // (1, 1): 10 with 7
    EXPECT_EQ(total(joint), 4U);
    EXPECT_EQ(joint.greatest(), 2U);
}

/// A ramp of 3 per voxel along x, 2 mm apart: 1.5 per mm inside, half of it at the border, where the voxel repeats.
TEST(JointHistogram, GradientsAreThoseOfCentralDifferences) {
    Grid grid = gridOf({40, 5, 34});
    grid.spacingMm = {2, 1, 1};
    const auto ramp = makeVolume<std::int16_t>(
        grid, VoxelType::int16, [](glm::ivec3 v) { return 3 * v.x; }, -2, 5);
    Task task;
    const JointHistogram joint = jointHistogramOfGradient(*ramp, {ramp->range(), 16}, 4, 100, task);
    std::vector<std::uint64_t> rows(100);
    for (int row = 0; row < 100; ++row)
        for (int column = 0; column < 16; ++column)
            rows[static_cast<std::size_t>(row)] += joint.at(column, row);
    // |slope| 2: 3 per mm inside, 1.5 at the border; over 4 these are 0.75 and 0.375.
    EXPECT_EQ(rows[75], 38U * 5 * 34);
    EXPECT_EQ(rows[37], 2U * 5 * 34);
    EXPECT_EQ(total(joint), ramp->grid().voxelCount());
}

/// Bricks' borders count once: a volume of many bricks against a plain loop.
TEST(JointHistogram, AgreesWithAPlainLoopOverManyBricks) {
    const glm::ivec3 dims(70, 33, 65);
    const auto value = [](glm::ivec3 v) { return (v.x * 7 + v.y * 13 + v.z * 29) % 251; };
    const auto other = [](glm::ivec3 v) { return (v.x * v.y + v.z) % 97; };
    const auto a = makeVolume<std::uint8_t>(gridOf(dims), VoxelType::uint8, value);
    const auto b = makeVolume<float>(gridOf(dims), VoxelType::float32, other);
    std::vector<std::uint64_t> expected(25 * 10);
    for (int z = 0; z < dims.z; ++z)
        for (int y = 0; y < dims.y; ++y)
            for (int x = 0; x < dims.x; ++x) {
                const int column = std::min(24, value({x, y, z}) / 10);
                const int row = std::min(9, other({x, y, z}) / 10);
                ++expected[static_cast<std::size_t>(row * 25 + column)];
            }
    Task task;
    EXPECT_EQ(jointHistogram(*a, {{0, 250}, 25}, *b, {{0, 100}, 10}, task).counts, expected);
}

TEST(JointHistogram, DistancesAreMillimetres) {
    Grid grid = gridOf({1, 1, 4});
    grid.spacingMm = {1, 1, 2.5};
    const auto volume = makeVolume<std::uint8_t>(grid, VoxelType::uint8, [](glm::ivec3 v) { return v.z; });
    Task task;
    const JointHistogram joint =
        jointHistogramOfDistance(*volume, {{0, 3}, 1}, grid.mmFromVoxel({0, 0, 0}), {{0, 10}, 4}, task);
    EXPECT_EQ(joint.counts, (std::vector<std::uint64_t>{1, 1, 1, 1})); // 0, 2.5, 5, 7.5 mm
}

TEST(JointHistogram, ConstantVolumesAndCancelledTasks) {
    const auto flat = makeVolume<std::uint8_t>(gridOf({3, 3, 3}), VoxelType::uint8, [](glm::ivec3) { return 9; });
    Task task;
    const JointHistogram joint = jointHistogramOfGradient(*flat, {flat->range(), 8}, 0, 8, task);
    EXPECT_EQ(joint.at(0, 0), 27U);
    task.cancel();
    EXPECT_THROW(jointHistogramOfGradient(*flat, {flat->range(), 8}, 0, 8, task), Error);
}

} // namespace
} // namespace limner
