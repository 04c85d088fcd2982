#pragma once

#include "core/volume/volume.h"

#include <algorithm>
#include <cstdint>

namespace limner {

/// Calls `use` with a null pointer of the type that a store of `type` holds: `withVoxelType(t, [&](auto* none) {...})`.
template <typename Use>
decltype(auto) withVoxelType(VoxelType type, Use&& use) {
    switch (type) {
    case VoxelType::uint8: return use(static_cast<const std::uint8_t*>(nullptr));
    case VoxelType::int16: return use(static_cast<const std::int16_t*>(nullptr));
    case VoxelType::float32: break;
    }
    return use(static_cast<const float*>(nullptr));
}

/// The voxels that one brick of the store owns (each voxel has exactly one owner), with room to read around them.
template <typename T>
struct OwnedBrick {
    const T* first = nullptr;    ///< voxel `origin`; neighbours at +-1, +-kRow, +-kSlice
    glm::ivec3 origin{0};        ///< of the owned box, in voxels
    glm::ivec3 size{0};          ///< of the owned box; at most 32 on a side
    glm::ivec3 readableAfter{1}; ///< voxels that may be read past the owned box; before it always 2

    [[nodiscard]] const T* row(int y, int z) const { return first + y * BrickLayout::kRow + z * BrickLayout::kSlice; }
};

/// The owned box of brick `index`; `T` must be the volume's stored type.
template <typename T>
OwnedBrick<T> ownedBrick(const Volume& volume, std::size_t index) {
    const glm::ivec3 bricks = volume.layout().bricks;
    const auto i = static_cast<int>(index);
    const glm::ivec3 brick(i % bricks.x, (i / bricks.x) % bricks.y, i / (bricks.x * bricks.y));
    constexpr int apron = 2; // see BrickLayout: voxel b*32-2 is the brick's first
    OwnedBrick<T> owned;
    owned.first = reinterpret_cast<const T*>(volume.bricks()) + index * BrickLayout::kBrickVoxels +
                  apron * (BrickLayout::kSlice + BrickLayout::kRow + 1);
    owned.origin = brick * BrickLayout::kBrickCells;
    owned.size = glm::min(volume.grid().dims - owned.origin, glm::ivec3(BrickLayout::kBrickCells));
    owned.readableAfter = BrickLayout::kBrickCells + 1 - owned.size;
    return owned;
}

} // namespace limner
