#pragma once

#include "renderer/marks/mark_field.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace limner {

/// First voxel of a row whose x is at least `x`, or the row's end.
inline std::uint32_t firstInRow(const MarkField& field, std::size_t row, int x) {
    const auto begin = field.voxels.begin() + field.rowStart[row];
    const auto end = field.voxels.begin() + field.rowStart[row + 1];
    const auto at = std::lower_bound(begin, end, x, [](const MarkVoxel& v, int wanted) { return v.cell.x < wanted; });
    return static_cast<std::uint32_t>(at - field.voxels.begin());
}

/// Calls `use(index, step in voxels)` for the mark voxels of the cube of 3^3 around one, itself too, x fastest.
template <typename Use>
void forNeighbours(const MarkField& field, std::size_t index, const Use& use) {
    const glm::ivec3 cell(field.voxels[index].cell);
    for (int z = std::max(cell.z - 1, 0); z <= std::min(cell.z + 1, field.grid.dims.z - 1); ++z) {
        for (int y = std::max(cell.y - 1, 0); y <= std::min(cell.y + 1, field.grid.dims.y - 1); ++y) {
            const std::size_t row =
                static_cast<std::size_t>(y) + static_cast<std::size_t>(field.grid.dims.y) * static_cast<std::size_t>(z);
            const std::uint32_t end = field.rowStart[row + 1];
            for (std::uint32_t i = firstInRow(field, row, cell.x - 1); i < end; ++i) {
                const glm::ivec3 step = glm::ivec3(field.voxels[i].cell) - cell;
                if (step.x > 1) {
                    break;
                }
                use(i, step);
            }
        }
    }
}

} // namespace limner
