#include "core/volume/bit_grid.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <functional>
#include <random>

namespace limner {
namespace {

BitGrid setWhere(glm::ivec3 dims, const std::function<bool(glm::ivec3)>& in) {
    BitGrid set(dims);
    for (int z = 0; z < dims.z; ++z) {
        for (int y = 0; y < dims.y; ++y) {
            for (int x = 0; x < dims.x; ++x) {
                if (in({x, y, z})) {
                    set.set({x, y, z});
                }
            }
        }
    }
    return set;
}

TEST(BitGrid, RunsCrossWords) {
    BitGrid set({200, 2, 2});
    set.setRun(1, 1, {60, 195});
    EXPECT_EQ(set.count(), 135U);
    EXPECT_FALSE(set.at({59, 1, 1}));
    EXPECT_TRUE(set.at({60, 1, 1}));
    EXPECT_TRUE(set.at({194, 1, 1}));
    EXPECT_FALSE(set.at({195, 1, 1}));
    set.setRun(0, 0, {0, 200});
    EXPECT_EQ(set.count(), 335U);
}

TEST(BitGrid, DilatingByOneAddsFaceNeighbours) {
    for (const int x : {0, 63, 64, 99}) {
        BitGrid set({100, 5, 5});
        set.set({x, 2, 2});
        const std::size_t expected = x == 0 || x == 99 ? 6 : 7;
        EXPECT_EQ(dilatedByOne(set, Connectivity::faces).count(), expected) << x;
        EXPECT_EQ(dilatedByOne(set, Connectivity::corners).count(), x == 0 || x == 99 ? 18U : 27U) << x;
    }
}

TEST(BitGrid, BallsAreRoundInMillimetres) {
    BitGrid set({101, 61, 41});
    set.set({50, 30, 20});
    const glm::dvec3 spacing(1, 2, 3);
    const double radius = 12;
    const BitGrid ball = dilated(set, spacing, radius);
    const double volume = static_cast<double>(ball.count()) * spacing.x * spacing.y * spacing.z;
    const double exact = 4.0 / 3 * 3.14159265 * radius * radius * radius;
    EXPECT_NEAR(volume, exact, 0.05 * exact); // coarse voxels; a box would be 1.9, an octahedron 0.32 of the ball
    EXPECT_TRUE(ball.at({62, 30, 20}));
    EXPECT_FALSE(ball.at({63, 30, 20}));
    EXPECT_TRUE(ball.at({50, 36, 20}));
    EXPECT_TRUE(ball.at({50, 30, 24}));
    EXPECT_FALSE(ball.at({50, 30, 25}));
}

TEST(BitGrid, ErosionSparesTheBorderOfTheScan) {
    const BitGrid full = setWhere({70, 8, 8}, [](glm::ivec3) { return true; });
    EXPECT_EQ(eroded(full, glm::dvec3(1), 3), full);
    const BitGrid half = setWhere({70, 8, 8}, [](glm::ivec3 v) { return v.x < 40; });
    EXPECT_EQ(eroded(half, glm::dvec3(1), 3), setWhere({70, 8, 8}, [](glm::ivec3 v) { return v.x < 37; }));
}

TEST(Components, FacesAndCornersDiffer) {
    BitGrid set({66, 4, 4});
    set.setRun(1, 1, {60, 64});
    set.setRun(2, 2, {64, 66}); // touches the first across a corner only
    set.set({0, 0, 0});
    const Components byFaces(set, Connectivity::faces);
    ASSERT_EQ(byFaces.list().size(), 3U);
    EXPECT_EQ(byFaces.list()[0].voxels, 4U);
    EXPECT_EQ(byFaces.list()[1].voxels, 2U);
    EXPECT_EQ(byFaces.list()[2].voxels, 1U);
    const Components byCorners(set, Connectivity::corners);
    ASSERT_EQ(byCorners.list().size(), 2U);
    EXPECT_EQ(byCorners.list()[0].voxels, 6U);
    EXPECT_EQ(byCorners.list()[0].low, glm::ivec3(60, 1, 1));
    EXPECT_EQ(byCorners.list()[0].high, glm::ivec3(65, 2, 2));
    EXPECT_EQ(byCorners.at({64, 2, 2}), 0);
    EXPECT_EQ(byCorners.at({0, 0, 0}), 1);
    EXPECT_EQ(byCorners.at({5, 0, 0}), -1);
    EXPECT_EQ(byCorners.select({false, true}).count(), 1U);
}

/// Flood fill, voxel by voxel.
std::size_t floodCount(const BitGrid& set) {
    const glm::ivec3 dims = set.dims();
    BitGrid seen(dims);
    std::size_t components = 0;
    std::vector<glm::ivec3> stack;
    for (int z = 0; z < dims.z; ++z) {
        for (int y = 0; y < dims.y; ++y) {
            for (int x = 0; x < dims.x; ++x) {
                if (!set.at({x, y, z}) || seen.at({x, y, z})) {
                    continue;
                }
                ++components;
                seen.set({x, y, z});
                stack.push_back({x, y, z});
                while (!stack.empty()) {
                    const glm::ivec3 v = stack.back();
                    stack.pop_back();
                    for (const glm::ivec3 d : {glm::ivec3(1, 0, 0), glm::ivec3(-1, 0, 0), glm::ivec3(0, 1, 0),
                                               glm::ivec3(0, -1, 0), glm::ivec3(0, 0, 1), glm::ivec3(0, 0, -1)}) {
                        const glm::ivec3 n = v + d;
                        if (n == glm::clamp(n, glm::ivec3(0), dims - 1) && set.at(n) && !seen.at(n)) {
                            seen.set(n);
                            stack.push_back(n);
                        }
                    }
                }
            }
        }
    }
    return components;
}

TEST(Components, AgreeWithFloodFillOnRandomSets) {
    std::mt19937 random(7);
    for (const double density : {0.1, 0.31, 0.5, 0.9}) { // 0.31 is near the percolation threshold: long, thin islands
        std::bernoulli_distribution in(density);
        const BitGrid set = setWhere({67, 21, 13}, [&](glm::ivec3) { return in(random); });
        const Components components(set, Connectivity::faces);
        EXPECT_EQ(components.list().size(), floodCount(set)) << density;
        std::size_t voxels = 0;
        for (const Component& c : components.list()) {
            voxels += c.voxels;
        }
        EXPECT_EQ(voxels, set.count());
    }
}

TEST(Components, SheetsThroughTheSlicesStackOnThemselves) {
    const BitGrid upright = setWhere({40, 40, 40}, [](glm::ivec3 v) { return v.x == 20; });
    EXPECT_EQ(Components(upright, Connectivity::faces).list()[0].stacked, 39U * 40U);
    const BitGrid lying = setWhere({40, 40, 40}, [](glm::ivec3 v) { return v.z == 20; });
    EXPECT_EQ(Components(lying, Connectivity::faces).list()[0].stacked, 0U);
}

} // namespace
} // namespace limner
