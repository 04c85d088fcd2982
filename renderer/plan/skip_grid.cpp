#include "renderer/plan/skip_grid.h"

#include "core/volume/brick_rows.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace limner {

namespace {

constexpr int kBlocksPerBrick = BrickLayout::kBrickCells / MinMaxGrid::kBlockCells;
constexpr int kBlockVoxels = MinMaxGrid::kBlockCells + 1; // four cells have five voxel planes
constexpr int kFirstVoxel = 1; // in the brick's own count: block 0 starts at cell 0, whose lower voxel is 1

/// Over a cube of `Voxels` on a side.
template <int Voxels, typename T>
void blockRange(const T* first, float& low, float& high) {
    T lowest = *first;
    T highest = *first;
    for (int z = 0; z < Voxels; ++z) {
        for (int y = 0; y < Voxels; ++y) {
            const T* row = first + z * BrickLayout::kSlice + y * BrickLayout::kRow;
            for (int x = 0; x < Voxels; ++x) {
                lowest = std::min(lowest, row[x]);
                highest = std::max(highest, row[x]);
            }
        }
    }
    low = static_cast<float>(lowest);
    high = static_cast<float>(highest);
}

template <int Reach, typename T>
void brickRanges(const Volume& volume, glm::ivec3 brick, MinMaxGrid& grid) {
    const glm::ivec3 bricks = volume.layout().bricks;
    const std::size_t index = (static_cast<std::size_t>(brick.z) * bricks.y + brick.y) * bricks.x + brick.x;
    const T* voxels = reinterpret_cast<const T*>(volume.bricks()) + index * BrickLayout::kBrickVoxels;
    const glm::ivec3 firstBlock = brick * kBlocksPerBrick;
    const glm::ivec3 count = glm::min(grid.blocks - firstBlock, glm::ivec3(kBlocksPerBrick));
    for (int z = 0; z < count.z; ++z) {
        for (int y = 0; y < count.y; ++y) {
            for (int x = 0; x < count.x; ++x) {
                const glm::ivec3 local = glm::ivec3(x, y, z) * MinMaxGrid::kBlockCells + kFirstVoxel - Reach;
                const glm::ivec3 block = firstBlock + glm::ivec3(x, y, z);
                const std::size_t at =
                    (static_cast<std::size_t>(block.z) * grid.blocks.y + block.y) * grid.blocks.x + block.x;
                blockRange<kBlockVoxels + 2 * Reach>(voxels + local.z * BrickLayout::kSlice +
                                                         local.y * BrickLayout::kRow + local.x,
                                                     grid.low[at], grid.high[at]);
            }
        }
    }
}

/// For every table entry, how many visible entries lie before it: a range holds something where the counts differ.
std::vector<std::uint32_t> prefixCounts(const std::vector<std::uint8_t>& visible) {
    std::vector<std::uint32_t> counts(visible.size() + 1, 0);
    for (std::size_t i = 0; i < visible.size(); ++i) {
        counts[i + 1] = counts[i] + (visible[i] != 0 ? 1 : 0);
    }
    return counts;
}

/// One axis of the Chebyshev distance: out = min over d of max(d, min(in[-d], in[+d])), exact up to kReach. Written
/// over rows of bytes, so that the compiler turns it into byte-wide vector instructions.
void distanceAlongX(std::uint8_t* row, int count, std::vector<std::uint8_t>& padded) {
    constexpr int reach = SkipGrid::kReach;
    std::fill(padded.begin(), padded.end(), std::uint8_t{reach});
    std::copy(row, row + count, padded.begin() + reach);
    const std::uint8_t* in = padded.data() + reach;
    for (int d = 1; d < reach; ++d) {
        const auto distance = static_cast<std::uint8_t>(d);
        for (int x = 0; x < count; ++x) {
            const std::uint8_t near = std::min(in[x - d], in[x + d]);
            row[x] = std::min(row[x], std::max(distance, near));
        }
    }
}

/// The same along an axis whose neighbours lie `stride` bytes apart; `rows` rows of `count` bytes, `lines` of them
/// apart.
void distanceAcross(const std::uint8_t* in, std::uint8_t* out, std::size_t stride, int position, int length,
                    int count) {
    for (int x = 0; x < count; ++x) {
        out[x] = in[x];
    }
    for (int d = 1; d < SkipGrid::kReach; ++d) {
        const auto distance = static_cast<std::uint8_t>(d);
        if (position >= d) {
            const std::uint8_t* other = in - stride * static_cast<std::size_t>(d);
            for (int x = 0; x < count; ++x) {
                out[x] = std::min(out[x], std::max(distance, other[x]));
            }
        }
        if (position + d < length) {
            const std::uint8_t* other = in + stride * static_cast<std::size_t>(d);
            for (int x = 0; x < count; ++x) {
                out[x] = std::min(out[x], std::max(distance, other[x]));
            }
        }
    }
}

void spreadDistances(SkipGrid& skip) {
    const glm::ivec3 n = skip.blocks;
    const auto row = static_cast<std::size_t>(n.x);
    const std::size_t slice = row * static_cast<std::size_t>(n.y);
    tbb::parallel_for(0, n.z, [&](int z) {
        std::vector<std::uint8_t> padded(row + 2 * SkipGrid::kReach);
        for (int y = 0; y < n.y; ++y) {
            distanceAlongX(skip.distance.data() + static_cast<std::size_t>(z) * slice +
                               static_cast<std::size_t>(y) * row,
                           n.x, padded);
        }
    });
    std::vector<std::uint8_t> other(skip.distance.size());
    tbb::parallel_for(0, n.z * n.y, [&](int zy) {
        const std::size_t at = static_cast<std::size_t>(zy) * row;
        distanceAcross(skip.distance.data() + at, other.data() + at, row, zy % n.y, n.y, n.x);
    });
    tbb::parallel_for(0, n.z * n.y, [&](int zy) {
        const std::size_t at = static_cast<std::size_t>(zy) * row;
        distanceAcross(other.data() + at, skip.distance.data() + at, slice, zy / n.y, n.z, n.x);
    });
}

} // namespace

std::shared_ptr<const MinMaxGrid> computeMinMaxGrid(const Volume& volume, SampleReach reach) {
    auto grid = std::make_shared<MinMaxGrid>();
    grid->blocks = (volume.grid().dims + MinMaxGrid::kBlockCells - 1) / MinMaxGrid::kBlockCells;
    const std::size_t count = static_cast<std::size_t>(grid->blocks.x) * grid->blocks.y * grid->blocks.z;
    grid->low.resize(count);
    grid->high.resize(count);
    const glm::ivec3 bricks = volume.layout().bricks;
    tbb::parallel_for(0, bricks.x * bricks.y * bricks.z, [&](int i) {
        const glm::ivec3 brick(i % bricks.x, i / bricks.x % bricks.y, i / (bricks.x * bricks.y));
        withVoxelType(volume.type(), [&](auto* none) {
            using Voxel = std::remove_cv_t<std::remove_pointer_t<decltype(none)>>;
            reach == SampleReach::cell ? brickRanges<0, Voxel>(volume, brick, *grid)
                                       : brickRanges<1, Voxel>(volume, brick, *grid);
        });
    });
    return grid;
}

std::shared_ptr<const SkipGrid> computeSkipGrid(const MinMaxGrid& grid, const VisibleRange& range) {
    assert(range.visible.size() >= 2);
    auto skip = std::make_shared<SkipGrid>();
    skip->blocks = grid.blocks;
    const std::size_t count = grid.low.size();
    skip->distance.assign(count + 4, SkipGrid::kReach);
    const std::vector<std::uint32_t> before = prefixCounts(range.visible);
    const int last = static_cast<int>(range.visible.size()) - 1;
    const double scale = range.high > range.low ? last / (range.high - range.low) : 0;
    // One entry more on either side than interpolation reads: backends find the entry in float32.
    const auto first = [&](float v) {
        return std::clamp(static_cast<int>(std::floor((v - range.low) * scale)) - 1, 0, last);
    };
    const auto end = [&](float v) {
        return std::clamp(static_cast<int>(std::floor((v - range.low) * scale)) + 2, 0, last) + 1;
    };
    const auto slice = static_cast<std::size_t>(grid.blocks.x) * static_cast<std::size_t>(grid.blocks.y);
    tbb::parallel_for(0, grid.blocks.z, [&](int z) {
        for (std::size_t i = static_cast<std::size_t>(z) * slice; i < static_cast<std::size_t>(z + 1) * slice; ++i) {
            if (before[static_cast<std::size_t>(end(grid.high[i]))] >
                before[static_cast<std::size_t>(first(grid.low[i]))]) {
                skip->distance[i] = 0;
            }
        }
    });
    skip->occupied = static_cast<double>(std::count(skip->distance.begin(),
                                                    skip->distance.begin() + static_cast<std::ptrdiff_t>(count), 0)) /
                     static_cast<double>(count);
    spreadDistances(*skip);
    return skip;
}

} // namespace limner
