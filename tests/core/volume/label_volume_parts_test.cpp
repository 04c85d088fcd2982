#include "core/volume/derived_fields.h"
#include "core/volume/grid_cover.h"
#include "support/make_volume.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <cmath>
#include <cstdint>
#include <numbers>

namespace limner {
namespace {

using testing::gridOf;
using testing::makeVolume;

TEST(LabelCounts, CountEveryVoxelOnce) {
    const auto volume = makeVolume<std::uint8_t>(gridOf({37, 5, 41}), VoxelType::uint8, [](glm::ivec3 v) {
        return v.x < 7 ? 0 : v.z < 40 ? 3 : 200;
    });
    const auto counts = labelCounts(*volume);
    ASSERT_TRUE(counts);
    EXPECT_EQ(*counts, (std::map<int, std::size_t>{{0, 7 * 5 * 41}, {3, 30 * 5 * 40}, {200, 30 * 5}}));
}

TEST(LabelCounts, OfShiftedAndSignedStorage) {
    // 16-bit unsigned data are kept shifted: 65535 is stored as 32767.
    const auto shifted = makeVolume<std::int16_t>(
        gridOf({2, 1, 1}), VoxelType::int16, [](glm::ivec3 v) { return v.x == 0 ? -32768 : 32767; }, 1, 32768);
    EXPECT_EQ(labelCounts(*shifted), (std::map<int, std::size_t>{{0, 1}, {65535, 1}}));
    const auto negative =
        makeVolume<std::int16_t>(gridOf({3, 1, 1}), VoxelType::int16, [](glm::ivec3 v) { return v.x - 1; });
    EXPECT_EQ(labelCounts(*negative), (std::map<int, std::size_t>{{-1, 1}, {0, 1}, {1, 1}}));
}

TEST(LabelCounts, FractionsAreNoLabels) {
    const auto at = [](glm::ivec3 v) { return v.x; };
    EXPECT_FALSE(labelCounts(*makeVolume<std::uint8_t>(gridOf({4, 1, 1}), VoxelType::uint8, at, 0.5)));
    EXPECT_FALSE(labelCounts(*makeVolume<std::uint8_t>(gridOf({4, 1, 1}), VoxelType::uint8, at, 1, 0.25)));
    EXPECT_FALSE(labelCounts(*makeVolume<std::uint8_t>(gridOf({4, 1, 1}), VoxelType::uint8, at, 1e12)));
    EXPECT_FALSE(labelCounts(*makeVolume<float>(gridOf({2, 1, 1}), VoxelType::float32, at, 0.3)));
}

Grid turned(Grid grid, double degrees) { // about z
    const double a = degrees * std::numbers::pi / 180;
    grid.direction = glm::dmat3(std::cos(a), std::sin(a), 0, -std::sin(a), std::cos(a), 0, 0, 0, 1);
    return grid;
}

Grid centredAt(Grid grid, const glm::dvec3& mm) {
    grid.originMm += mm - grid.centreMm();
    return grid;
}

TEST(GridCover, SharesOfBoxesAlongTheAxes) {
    const Grid scan = gridOf({20, 10, 10});
    EXPECT_EQ(coveredShare(scan, scan), 1);
    Grid half = scan;
    half.originMm.x = 10;
    EXPECT_EQ(coveredShare(scan, half), 0.5);
    Grid flipped = scan; // the same box, its rows stored from the other end
    flipped.direction[1] = {0, -1, 0};
    flipped.originMm.y = 9;
    EXPECT_EQ(coveredShare(scan, flipped), 1);
    Grid fine = gridOf({80, 80, 80});
    fine.spacingMm = glm::dvec3(0.25);
    EXPECT_NEAR(coveredShare(scan, centredAt(fine, scan.centreMm())), 1, 1e-12);
    Grid small = gridOf({10, 5, 5});
    EXPECT_NEAR(coveredShare(scan, centredAt(small, scan.centreMm())), 0.125, 0.03);
}

TEST(GridCover, BoxesThatOnlyTouchDoNotOverlap) {
    const Grid scan = gridOf({10, 10, 10});
    for (int axis = 0; axis < 3; ++axis) {
        Grid beside = scan;
        beside.originMm[axis] = 10;
        EXPECT_FALSE(boxesOverlap(scan, beside)) << axis;
        beside.originMm[axis] = -9.99;
        EXPECT_TRUE(boxesOverlap(scan, beside)) << axis;
    }
}

TEST(GridCover, TurnedBoxesArePartedByTheirOwnFacesAndEdges) {
    const Grid scan = centredAt(gridOf({10, 10, 10}), {0, 0, 0});
    // A square of side 10 turned by 45 degrees reaches 7.07 from its centre, towards the scan's corner only 5.
    const Grid square = turned(scan, 45);
    EXPECT_TRUE(boxesOverlap(scan, centredAt(square, {12.0, 0, 0})));
    EXPECT_FALSE(boxesOverlap(scan, centredAt(square, {12.1, 0, 0})));
    const double diagonal = (5 * std::sqrt(2.0) + 5) / std::sqrt(2.0); // along x and y each
    EXPECT_TRUE(boxesOverlap(scan, centredAt(square, glm::dvec3(diagonal - 0.01, diagonal - 0.01, 0))));
    EXPECT_FALSE(boxesOverlap(scan, centredAt(square, glm::dvec3(diagonal + 0.01, diagonal + 0.01, 0))));
    // Two long rods across each other: only the direction across both edges parts them once each is turned about
    // itself by 45 degrees, so that edge lies over edge; their half diagonals add up to 1.414.
    Grid along = gridOf({100, 1, 1});
    along.direction = glm::dmat3(1, 0, 0, 0, std::sqrt(0.5), std::sqrt(0.5), 0, -std::sqrt(0.5), std::sqrt(0.5));
    Grid across = gridOf({1, 100, 1});
    across.direction = glm::dmat3(std::sqrt(0.5), 0, std::sqrt(0.5), 0, 1, 0, -std::sqrt(0.5), 0, std::sqrt(0.5));
    EXPECT_TRUE(boxesOverlap(centredAt(along, {0, 0, 0}), centredAt(across, {0, 0, 1.41})));
    EXPECT_FALSE(boxesOverlap(centredAt(along, {0, 0, 0}), centredAt(across, {0, 0, 1.42})));
    EXPECT_EQ(coveredShare(scan, centredAt(square, {12.1, 0, 0})), 0);
}

} // namespace
} // namespace limner
