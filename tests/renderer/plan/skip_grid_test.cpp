#include "renderer/plan/skip_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace limner {
namespace {

std::shared_ptr<const Volume> randomVolume(glm::ivec3 dims, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<std::uint8_t> voxels(static_cast<std::size_t>(dims.x) * dims.y * dims.z);
    for (auto& voxel : voxels) {
        voxel = static_cast<std::uint8_t>(random() % 256);
    }
    Volume::Contents contents;
    contents.grid.dims = dims;
    contents.range = {0, 255};
    return std::make_shared<const Volume>(contents, std::as_bytes(std::span(voxels)));
}

/// Lowest and highest voxel that any sample inside a block can read, straight from the definition; `more`: voxels
/// beyond the cells' corners.
std::pair<double, double> blockRange(const Volume& volume, glm::ivec3 block, int more) {
    double low = 1e9;
    double high = -1e9;
    const glm::ivec3 first = block * MinMaxGrid::kBlockCells - 1; // cell c spans the voxels c-1 and c
    for (int z = -more; z <= MinMaxGrid::kBlockCells + more; ++z) {
        for (int y = -more; y <= MinMaxGrid::kBlockCells + more; ++y) {
            for (int x = -more; x <= MinMaxGrid::kBlockCells + more; ++x) {
                const double v = volume.storedAt(first + glm::ivec3(x, y, z));
                low = std::min(low, v);
                high = std::max(high, v);
            }
        }
    }
    return {low, high};
}

TEST(MinMaxGrid, CoversWhatSamplesRead) {
    for (const SampleReach reach : {SampleReach::cell, SampleReach::neighbours}) {
        for (const glm::ivec3 dims :
             {glm::ivec3(1, 1, 1), glm::ivec3(5, 4, 3), glm::ivec3(33, 32, 31), glm::ivec3(70, 9, 40)}) {
            const auto volume = randomVolume(dims, 7);
            const auto grid = computeMinMaxGrid(*volume, reach);
            ASSERT_EQ(grid->blocks, (dims + 3) / 4);
            for (int i = 0; i < grid->blocks.x * grid->blocks.y * grid->blocks.z; ++i) {
                const glm::ivec3 block(i % grid->blocks.x, i / grid->blocks.x % grid->blocks.y,
                                       i / (grid->blocks.x * grid->blocks.y));
                const auto [low, high] = blockRange(*volume, block, reach == SampleReach::cell ? 0 : 1);
                ASSERT_EQ(grid->low[static_cast<std::size_t>(i)], low) << i;
                ASSERT_EQ(grid->high[static_cast<std::size_t>(i)], high) << i;
            }
        }
    }
}

int chebyshev(const glm::ivec3& a, const glm::ivec3& b) {
    return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

TEST(SkipGrid, DistanceIsChebyshevUpToItsReach) {
    std::mt19937 random(3);
    for (const glm::ivec3 blocks : {glm::ivec3(1, 1, 1), glm::ivec3(40, 3, 2), glm::ivec3(9, 21, 17)}) {
        MinMaxGrid grid;
        grid.blocks = blocks;
        std::vector<glm::ivec3> occupied;
        for (int z = 0; z < blocks.z; ++z) {
            for (int y = 0; y < blocks.y; ++y) {
                for (int x = 0; x < blocks.x; ++x) {
                    const bool shows = random() % 400 == 0;
                    grid.low.push_back(shows ? 200.0F : 0.0F);
                    grid.high.push_back(shows ? 210.0F : 10.0F);
                    if (shows) {
                        occupied.emplace_back(x, y, z);
                    }
                }
            }
        }
        VisibleRange range{0, 255, std::vector<std::uint8_t>(256, 0)};
        std::fill(range.visible.begin() + 205, range.visible.end(), std::uint8_t{1});
        const auto skip = computeSkipGrid(grid, range);
        for (int i = 0; i < blocks.x * blocks.y * blocks.z; ++i) {
            const glm::ivec3 at(i % blocks.x, i / blocks.x % blocks.y, i / (blocks.x * blocks.y));
            int nearest = SkipGrid::kReach;
            for (const glm::ivec3& other : occupied) {
                nearest = std::min(nearest, chebyshev(at, other));
            }
            ASSERT_EQ(int{skip->distance[static_cast<std::size_t>(i)]}, nearest);
        }
    }
}

TEST(SkipGrid, ABlockThatOnlyGrazesTheVisibleRangeCounts) {
    MinMaxGrid grid{{1, 1, 1}, {0.0F}, {99.5F}};
    VisibleRange range{0, 255, std::vector<std::uint8_t>(256, 0)};
    range.visible[100] = 1; // read by interpolation from value 99 on
    EXPECT_EQ(int{computeSkipGrid(grid, range)->distance[0]}, 0);
    grid.high[0] = 90;
    EXPECT_GT(int{computeSkipGrid(grid, range)->distance[0]}, 0);
    range.visible.assign(256, 0);
    EXPECT_EQ(computeSkipGrid(grid, range)->occupied, 0);
}

} // namespace
} // namespace limner
