#include "core/base/error.h"
#include "core/volume/derived_fields.h"

#include "support/make_volume.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <random>

namespace limner {
namespace {

using testing::gridOf;
using testing::makeVolume;

std::vector<glm::ivec3> allVoxels(glm::ivec3 dims) {
    std::vector<glm::ivec3> voxels;
    for (int z = 0; z < dims.z; ++z) {
        for (int y = 0; y < dims.y; ++y) {
            for (int x = 0; x < dims.x; ++x) {
                voxels.emplace_back(x, y, z);
            }
        }
    }
    return voxels;
}

/// Every voxel against every voxel of the label; half a step of 16 bits is allowed, and what float32 rounds.
void expectBruteForce(const Volume& labels, int label, const Volume& distance) {
    const std::vector<glm::ivec3> voxels = allVoxels(labels.grid().dims);
    std::vector<glm::dvec3> marked;
    for (const glm::ivec3 voxel : voxels) {
        if (labels.valueAt(voxel) == label) {
            marked.push_back(labels.grid().mmFromVoxel(voxel));
        }
    }
    double largest = 0;
    for (const glm::ivec3 voxel : voxels) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const glm::dvec3& place : marked) {
            nearest = std::min(nearest, glm::distance(place, labels.grid().mmFromVoxel(voxel)));
        }
        largest = std::max(largest, nearest);
        ASSERT_NEAR(distance.valueAt(voxel), nearest, 0.51 * distance.contents().slope);
        if (nearest == 0) {
            ASSERT_EQ(distance.valueAt(voxel), 0);
        }
    }
    EXPECT_NEAR(distance.range().high, largest, 1e-6 * largest);
    EXPECT_EQ(distance.range().low, 0);
    EXPECT_LE(distance.contents().slope, 1.0001 * largest / 65535);
}

TEST(DistanceToLabel, AgreesWithBruteForce) {
    std::mt19937 random(17);
    for (const int oneIn : {2, 20, 300, 1500}) {
        Grid grid = gridOf({19, 13, 11});
        grid.spacingMm = {0.4, 1.1, 2.7};
        grid.originMm = {5, -80, 33};
        const auto labels = makeVolume<std::uint8_t>(grid, VoxelType::uint8, [&](glm::ivec3 v) {
            const bool marked = random() % oneIn == 0 || v == glm::ivec3(18, 2, 7); // at least one
            return marked ? 3 : random() % 3;
        });
        Task task;
        const auto distance = distanceToLabel(*labels, 3, task);
        ASSERT_TRUE(distance);
        EXPECT_EQ(distance->grid(), grid);
        EXPECT_EQ(distance->type(), VoxelType::int16);
        expectBruteForce(*labels, 3, *distance);
    }
}

TEST(DistanceToLabel, AgreesWithBruteForceOnFlatAndSteepGrids) {
    std::mt19937 random(4);
    for (const glm::dvec3& spacing : {glm::dvec3(1), glm::dvec3(1000, 1, 1), glm::dvec3(1e-20, 3e-20, 2e-20)}) {
        for (const glm::ivec3 dims : {glm::ivec3(40, 21, 1), glm::ivec3(1, 1, 30), glm::ivec3(3, 50, 4)}) {
            Grid grid = gridOf(dims);
            grid.spacingMm = spacing;
            // 16-bit unsigned labels, shifted; the label wanted is past 32767.
            const auto labels = makeVolume<std::int16_t>(
                grid, VoxelType::int16,
                [&](glm::ivec3 v) { return v == dims / 2 || random() % 60 == 0 ? 40000 - 32768 : 1 - 32768; }, 1,
                32768);
            Task task;
            const auto distance = distanceToLabel(*labels, 40000, task);
            ASSERT_TRUE(distance);
            expectBruteForce(*labels, 40000, *distance);
        }
    }
}

TEST(DistanceToLabel, IsNothingWithoutTheLabel) {
    const auto labels = makeVolume<std::uint8_t>(gridOf({5, 6, 7}), VoxelType::uint8, [](glm::ivec3 v) { return v.x; });
    Task task;
    EXPECT_FALSE(distanceToLabel(*labels, 9, task));
    EXPECT_FALSE(distanceToLabel(*labels, -1, task));
    EXPECT_FALSE(distanceToLabel(*labels, 260, task)); // 260 is 4 in eight bits
}

TEST(DistanceToLabel, IsNoneWhereAllIsTheLabel) {
    const auto labels = makeVolume<std::uint8_t>(gridOf({5, 6, 7}), VoxelType::uint8, [](glm::ivec3) { return 1; });
    Task task;
    const auto distance = distanceToLabel(*labels, 1, task);
    ASSERT_TRUE(distance);
    EXPECT_NE(distance->contents().slope, 0);
    EXPECT_EQ(distance->range(), (ValueRange{0, 0}));
    EXPECT_EQ(distance->valueAt({2, 2, 2}), 0);
}

TEST(DistanceToLabel, StopsWhenCancelled) {
    const auto labels = makeVolume<std::uint8_t>(gridOf({5, 6, 7}), VoxelType::uint8, [](glm::ivec3) { return 1; });
    Task task;
    task.cancel();
    EXPECT_THROW(distanceToLabel(*labels, 1, task), Error);
}

} // namespace
} // namespace limner
