#pragma once

#include "core/volume/volume.h"

#include <algorithm>
#include <memory>
#include <vector>

namespace limner::testing {

/// A volume of `grid` with the stored numbers that `at(voxel)` gives, its range taken from them.
template <typename T, typename At>
std::shared_ptr<const Volume> makeVolume(const Grid& grid, VoxelType type, At at, double slope = 1,
                                         double intercept = 0) {
    std::vector<T> voxels;
    voxels.reserve(grid.voxelCount());
    for (int z = 0; z < grid.dims.z; ++z) {
        for (int y = 0; y < grid.dims.y; ++y) {
            for (int x = 0; x < grid.dims.x; ++x) {
                voxels.push_back(static_cast<T>(at(glm::ivec3(x, y, z))));
            }
        }
    }
    Volume::Contents contents;
    contents.grid = grid;
    contents.type = type;
    contents.slope = slope;
    contents.intercept = intercept;
    const auto [low, high] = std::minmax_element(voxels.begin(), voxels.end());
    const double ends[] = {slope * static_cast<double>(*low) + intercept,
                           slope * static_cast<double>(*high) + intercept};
    contents.range = {std::min(ends[0], ends[1]), std::max(ends[0], ends[1])};
    return std::make_shared<const Volume>(contents, std::as_bytes(std::span(voxels)));
}

/// A grid of `dims` with unit spacing.
inline Grid gridOf(glm::ivec3 dims) {
    Grid grid;
    grid.dims = dims;
    return grid;
}

} // namespace limner::testing
