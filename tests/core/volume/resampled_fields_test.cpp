#include "core/base/error.h"
#include "core/volume/derived_fields.h"

#include "support/make_volume.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <random>

namespace limner {
namespace {

using testing::gridOf;
using testing::makeVolume;

/// A grid that shares no direction, spacing or centre with the unit grid.
Grid tilted(glm::ivec3 dims, const glm::dvec3& spacingMm, const glm::dvec3& originMm) {
    Grid grid;
    grid.dims = dims;
    grid.spacingMm = spacingMm;
    grid.originMm = originMm;
    const glm::dvec3 x = glm::normalize(glm::dvec3(2, 1, -0.5));
    const glm::dvec3 y = glm::normalize(glm::cross(glm::dvec3(0.3, -1, 2), x));
    grid.direction = glm::dmat3(x, y, -glm::cross(x, y)); // left-handed
    return grid;
}

template <typename Visit>
void forEachVoxel(const Grid& grid, Visit visit) {
    for (int z = 0; z < grid.dims.z; ++z) {
        for (int y = 0; y < grid.dims.y; ++y) {
            for (int x = 0; x < grid.dims.x; ++x) {
                visit(glm::ivec3(x, y, z));
            }
        }
    }
}

bool inBox(const Grid& grid, const glm::dvec3& voxel) {
    return voxel.x >= -0.5 && voxel.y >= -0.5 && voxel.z >= -0.5 && voxel.x < grid.dims.x - 0.5 &&
           voxel.y < grid.dims.y - 0.5 && voxel.z < grid.dims.z - 0.5;
}

TEST(ResampledValues, AreTrilinearOnATiltedGrid) {
    std::mt19937 random(2);
    const Grid from = tilted({20, 33, 17}, {0.7, 1.3, 2}, {-3, 5, 40});
    const auto source = makeVolume<std::int16_t>(
        from, VoxelType::int16, [&](glm::ivec3) { return static_cast<int>(random() % 4000) - 1000; }, -0.5, 9);
    Grid to = gridOf({40, 37, 50});
    to.originMm = from.centreMm() - glm::dvec3(20, 18, 25);
    Task task;
    const auto resampled = resampledValues(*source, to, task);
    EXPECT_EQ(resampled->type(), VoxelType::int16);
    EXPECT_EQ(resampled->grid(), to);
    EXPECT_EQ(resampled->range(), source->range());
    const double halfStep = 0.5 * (source->range().high - source->range().low) / 65535;
    int within = 0;
    int outside = 0;
    forEachVoxel(to, [&](glm::ivec3 voxel) {
        const glm::dvec3 position = from.voxelFromMm(to.mmFromVoxel(voxel));
        const bool in = inBox(from, position);
        const glm::dvec3 clamped = glm::clamp(position, glm::dvec3(0), glm::dvec3(from.dims - 1));
        const double expected = in ? trilinear(*source, clamped) : source->range().low;
        ASSERT_NEAR(resampled->valueAt(voxel), expected, 1.001 * halfStep);
        ++(in ? within : outside);
    });
    EXPECT_GT(within, 10000);
    EXPECT_GT(outside, 10000);
}

TEST(ResampledValues, OfBytesOnTheirOwnGridAreTheBytes) {
    std::mt19937 random(5);
    const Grid grid = tilted({35, 9, 12}, {0.3, 0.3, 0.9}, {100, -200, 300});
    const auto source = makeVolume<std::uint8_t>(grid, VoxelType::uint8, [&](glm::ivec3) { return random() & 255U; });
    Task task;
    const auto resampled = resampledValues(*source, grid, task);
    forEachVoxel(grid, [&](glm::ivec3 voxel) {
        ASSERT_NEAR(resampled->valueAt(voxel), source->valueAt(voxel), 1e-9); // 65535 / 255 is whole
    });
}

TEST(ResampledValues, OfFloatsAndConstants) {
    const auto ramp =
        makeVolume<float>(gridOf({10, 10, 10}), VoxelType::float32, [](glm::ivec3 v) { return v.x / 9.0; });
    Grid fine = gridOf({19, 19, 19});
    fine.spacingMm = glm::dvec3(0.5);
    Task task;
    EXPECT_NEAR(resampledValues(*ramp, fine, task)->valueAt({7, 4, 4}), 3.5 / 9, 1.0 / 65535);
    const auto constant = makeVolume<float>(
        gridOf({4, 4, 1}), VoxelType::float32, [](glm::ivec3) { return 0; }, 5, 2);
    const auto resampled = resampledValues(*constant, fine, task);
    EXPECT_NE(resampled->contents().slope, 0);
    EXPECT_EQ(resampled->valueAt({3, 3, 0}), 2);
    EXPECT_EQ(resampled->valueAt({18, 18, 18}), 2);
}

TEST(LabelSlots, TakeTheNearestVoxelOfAnyGrid) {
    std::mt19937 random(11);
    // Unsigned 16-bit labels as they are kept, shifted by 32768; 65000 is one of them.
    const int numbers[] = {0, 7, 300, 65000};
    const Grid from = tilted({14, 11, 9}, {2, 1.5, 3}, {10, 20, 30});
    const auto labels = makeVolume<std::int16_t>(
        from, VoxelType::int16, [&](glm::ivec3) { return numbers[random() % 4] - 32768; }, 1, 32768);
    Grid to = gridOf({30, 31, 32});
    to.originMm = from.centreMm() - glm::dvec3(15.2137, 15.1811, 15.2419); // no voxel falls between two of the other's
    const std::map<int, std::uint8_t> slotOf = {{7, 1}, {65000, 255}, {12, 9}};
    Task task;
    const auto slots = labelSlots(*labels, to, slotOf, task);
    EXPECT_EQ(slots->type(), VoxelType::uint8);
    EXPECT_EQ(slots->grid(), to);
    EXPECT_EQ(slots->range(), (ValueRange{0, 255}));
    std::map<int, int> seen;
    forEachVoxel(to, [&](glm::ivec3 voxel) {
        const glm::dvec3 position = from.voxelFromMm(to.mmFromVoxel(voxel));
        int expected = 0;
        if (inBox(from, position)) {
            const auto found = slotOf.find(static_cast<int>(labels->valueAt(glm::ivec3(glm::round(position)))));
            expected = found != slotOf.end() ? found->second : 0;
        }
        ASSERT_EQ(slots->storedAt(voxel), expected);
        ++seen[expected];
    });
    EXPECT_EQ(seen.size(), 3U);
}

TEST(LabelSlots, OnTheirOwnGridMoveNothing) {
    std::mt19937 random(3);
    const Grid grid = tilted({33, 40, 8}, {0.41, 0.41, 1.25}, {-120.3, 77.7, 512.9});
    const auto labels = makeVolume<std::uint8_t>(grid, VoxelType::uint8, [&](glm::ivec3) { return random() % 5; });
    Task task;
    const auto slots = labelSlots(*labels, grid, {{1, 1}, {2, 2}, {3, 3}, {4, 4}}, task);
    forEachVoxel(grid, [&](glm::ivec3 voxel) { ASSERT_EQ(slots->storedAt(voxel), labels->storedAt(voxel)); });
}

TEST(LabelSlots, OfFloatLabels) {
    // Labels 0 .. 3000 normalised to [0, 1], as the importer keeps floats.
    const auto labels = makeVolume<float>(
        gridOf({31, 1, 1}), VoxelType::float32, [](glm::ivec3 v) { return 100 * v.x / 3000.0; }, 3000, 0);
    Task task;
    const auto slots = labelSlots(*labels, labels->grid(), {{700, 5}, {2900, 6}}, task);
    EXPECT_EQ(slots->storedAt({7, 0, 0}), 5);
    EXPECT_EQ(slots->storedAt({29, 0, 0}), 6);
    EXPECT_EQ(slots->storedAt({8, 0, 0}), 0);
}

TEST(LabelSlots, StopWhenCancelled) {
    const auto labels = makeVolume<std::uint8_t>(gridOf({4, 4, 4}), VoxelType::uint8, [](glm::ivec3) { return 1; });
    Task task;
    task.cancel();
    EXPECT_THROW(labelSlots(*labels, labels->grid(), {}, task), Error);
    EXPECT_THROW(resampledValues(*labels, labels->grid(), task), Error);
}

TEST(ResampledValues, SayWhenMemoryDoesNotSuffice) {
    const auto source = makeVolume<std::uint8_t>(gridOf({4, 4, 4}), VoxelType::uint8, [](glm::ivec3) { return 1; });
    const Grid vast = gridOf(glm::ivec3(1 << 21)); // 2^63 voxels: refused before an allocator is asked
    Task task;
    try {
        resampledValues(*source, vast, task);
        FAIL() << "got memory that no machine has";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::noResources);
    }
}

using Counts = std::map<int, std::size_t>;

TEST(LabelCounts, CountsWhatOccurs) {
    const auto bytes = makeVolume<std::uint8_t>(gridOf({40, 50, 3}), VoxelType::uint8, [](glm::ivec3 v) {
        return v.x < 33 ? 0 : v.y == 7 ? 200 : 4;
    });
    EXPECT_EQ(labelCounts(*bytes), (Counts{{0, 33 * 50 * 3}, {4, 7 * 49 * 3}, {200, 7 * 3}}));
    const auto shifted = makeVolume<std::int16_t>(
        gridOf({40, 1, 1}), VoxelType::int16, [](glm::ivec3 v) { return v.x == 0 ? 32767 : -32768; }, 1, 32768);
    EXPECT_EQ(labelCounts(*shifted), (Counts{{0, 39}, {65535, 1}}));
    const auto negative = makeVolume<std::int16_t>(
        gridOf({3, 1, 1}), VoxelType::int16, [](glm::ivec3 v) { return v.x; }, -2, 0);
    EXPECT_EQ(labelCounts(*negative), (Counts{{-4, 1}, {-2, 1}, {0, 1}}));
}

TEST(LabelCounts, TakesFloatsForTheLabelsTheyWere) {
    const auto floats = makeVolume<float>(
        gridOf({64, 2, 1}), VoxelType::float32, [](glm::ivec3 v) { return v.x / 63.0; }, 63 * 7, -3);
    const auto counts = labelCounts(*floats);
    ASSERT_TRUE(counts);
    EXPECT_EQ(counts->size(), 64U);
    EXPECT_EQ(counts->at(-3 + 7 * 20), 2U);
}

TEST(LabelCounts, RefusesFractionsAndTooMany) {
    const auto halves = makeVolume<std::uint8_t>(
        gridOf({5, 1, 1}), VoxelType::uint8, [](glm::ivec3 v) { return v.x; }, 0.5, 0);
    EXPECT_FALSE(labelCounts(*halves));
    const auto even = makeVolume<std::uint8_t>(
        gridOf({5, 1, 1}), VoxelType::uint8, [](glm::ivec3 v) { return 2 * v.x; }, 0.5, 0);
    EXPECT_TRUE(labelCounts(*even)); // only what occurs counts
    const auto measured = makeVolume<float>(gridOf({50, 50, 1}), VoxelType::float32,
                                            [](glm::ivec3 v) { return std::sin(v.x * 0.3) * std::cos(v.y * 0.7); });
    EXPECT_FALSE(labelCounts(*measured));
    const auto many = makeVolume<float>(
        gridOf({300, 300, 1}), VoxelType::float32, [](glm::ivec3 v) { return 300 * v.y + v.x; }, 1, 0);
    EXPECT_FALSE(labelCounts(*many));
}

} // namespace
} // namespace limner
