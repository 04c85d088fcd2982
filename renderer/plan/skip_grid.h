#pragma once

#include "core/volume/volume.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace limner {

/// Voxels that a sample inside a cell reads: its corners, or one more to every side (a cubic B-spline's value lies
/// between those of its coefficients).
enum class SampleReach { cell, neighbours };

/// Lowest and highest stored number in every block of 4^3 cells (see BrickLayout for cells), all voxels that a sample
/// inside the block can read included. Once per volume.
struct MinMaxGrid {
    static constexpr int kBlockCells = 4;
    static constexpr int kLog2BlockCells = 2;
    glm::ivec3 blocks{0};
    std::vector<float> low;
    std::vector<float> high;
};

std::shared_ptr<const MinMaxGrid> computeMinMaxGrid(const Volume& volume, SampleReach reach = SampleReach::cell);

/// Chebyshev distance, in blocks, from every block to the nearest one that can contribute; 0: it can itself.
/// Capped at kReach. Once per set of transfer tables.
struct SkipGrid {
    static constexpr int kReach = 15;
    glm::ivec3 blocks{0};
    std::vector<std::uint8_t> distance; ///< x fastest; padded so that a 4-byte read of any entry is inside
    double occupied = 0;                ///< share of the blocks that can contribute
};

/// Where, over the stored range of a volume, anything can be visible: entry k of `visible` stands for the interval
/// around low + k * (high - low) / (size - 1) that linear interpolation of a table reads there.
struct VisibleRange {
    double low = 0;
    double high = 1;
    std::vector<std::uint8_t> visible;
};

std::shared_ptr<const SkipGrid> computeSkipGrid(const MinMaxGrid& grid, const VisibleRange& range);

} // namespace limner
