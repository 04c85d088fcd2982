#include "core/volume/volume.h"

#include "core/base/error.h"

#include <glm/common.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <cstring>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace limner {

std::size_t bytesPerVoxel(VoxelType type) {
    switch (type) {
    case VoxelType::uint8: return 1;
    case VoxelType::int16: return 2;
    case VoxelType::float32: return 4;
    }
    return 1;
}

namespace {

constexpr int kBrickRows = 35; // 32 cells need 33 voxels; central differences one more on either side

/// Copies the voxels [first, first + kBrickRows) of a row, clamped to [0, count).
template <typename T>
void fillRow(T* out, const T* row, int first, int count) {
    for (int i = 0; i < BrickLayout::kRow; ++i) {
        out[i] = row[std::clamp(first + i, 0, count - 1)];
    }
}

template <typename T>
void fillBricks(const Grid& grid, const BrickLayout& layout, const T* voxels, T* bricks) {
    const glm::ivec3 dims = grid.dims;
    tbb::parallel_for(0, layout.bricks.z * layout.bricks.y, [&](int zy) {
        const int bz = zy / layout.bricks.y;
        const int by = zy % layout.bricks.y;
        for (int bx = 0; bx < layout.bricks.x; ++bx) {
            T* brick = bricks + (static_cast<std::size_t>(zy) * layout.bricks.x + bx) * BrickLayout::kBrickVoxels;
            for (int z = 0; z < kBrickRows; ++z) {
                const int sourceZ = std::clamp(bz * BrickLayout::kBrickCells - 2 + z, 0, dims.z - 1);
                for (int y = 0; y < kBrickRows; ++y) {
                    const int sourceY = std::clamp(by * BrickLayout::kBrickCells - 2 + y, 0, dims.y - 1);
                    const T* row = voxels + (static_cast<std::size_t>(sourceZ) * dims.y + sourceY) * dims.x;
                    fillRow(brick + z * BrickLayout::kSlice + y * BrickLayout::kRow, row,
                            bx * BrickLayout::kBrickCells - 2, dims.x);
                }
            }
        }
    });
}

/// Offset in voxels of a voxel inside the store: any brick that holds it will do, here the one of its own cell.
std::size_t storeIndex(const BrickLayout& layout, glm::ivec3 voxel) {
    const glm::ivec3 brick = voxel / BrickLayout::kBrickCells;
    const glm::ivec3 local = voxel - brick * BrickLayout::kBrickCells + 2;
    const std::size_t index =
        (static_cast<std::size_t>(brick.z) * layout.bricks.y + brick.y) * layout.bricks.x + brick.x;
    return index * BrickLayout::kBrickVoxels + static_cast<std::size_t>(local.z) * BrickLayout::kSlice +
           static_cast<std::size_t>(local.y) * BrickLayout::kRow + static_cast<std::size_t>(local.x);
}

/// A ray touches bricks all over the store: with small pages every other fetch would also miss the address cache, so
/// the store asks for huge ones.
std::byte* allocateStore(std::size_t bytes) {
    constexpr std::size_t hugePage = std::size_t{2} << 20;
    const std::size_t rounded = (bytes + hugePage - 1) / hugePage * hugePage;
    void* store = std::aligned_alloc(hugePage, rounded);
#ifdef MADV_HUGEPAGE
    if (store != nullptr) {
        madvise(store, rounded, MADV_HUGEPAGE); // a wish; without it the store is only slower
    }
#endif
    return static_cast<std::byte*>(store);
}

} // namespace

void Volume::Release::operator()(std::byte* store) const { std::free(store); }

Volume::Volume(Contents contents, std::span<const std::byte> stored) : contents_(std::move(contents)) {
    const Grid& grid = contents_.grid;
    const std::size_t bytes = bytesPerVoxel(contents_.type);
    assert(grid.dims.x > 0 && grid.dims.y > 0 && grid.dims.z > 0);
    assert(stored.size() == grid.voxelCount() * bytes);
    layout_.bricks = (grid.dims + BrickLayout::kBrickCells - 1) / BrickLayout::kBrickCells;
    storeBytes_ = layout_.brickCount() * BrickLayout::kBrickVoxels * bytes + 2 * BrickLayout::kStorePaddingBytes;
    store_.reset(allocateStore(storeBytes_));
    if (!store_) {
        throw Error(ErrorKind::noResources,
                    {"not enough memory for the volume", "", "", "close other programs or load a part of it"});
    }
    std::fill_n(store_.get(), BrickLayout::kStorePaddingBytes, std::byte{0});
    std::fill_n(store_.get() + storeBytes_ - BrickLayout::kStorePaddingBytes, BrickLayout::kStorePaddingBytes,
                std::byte{0});
    std::byte* first = store_.get() + BrickLayout::kStorePaddingBytes;
    bricks_ = first;
    switch (contents_.type) {
    case VoxelType::uint8:
        fillBricks(grid, layout_, reinterpret_cast<const std::uint8_t*>(stored.data()),
                   reinterpret_cast<std::uint8_t*>(first));
        break;
    case VoxelType::int16:
        fillBricks(grid, layout_, reinterpret_cast<const std::int16_t*>(stored.data()),
                   reinterpret_cast<std::int16_t*>(first));
        break;
    case VoxelType::float32:
        fillBricks(grid, layout_, reinterpret_cast<const float*>(stored.data()), reinterpret_cast<float*>(first));
        break;
    }
}

double Volume::levelAt(double stored) const {
    const std::vector<double>& levels = contents_.levels;
    const double place = std::clamp(stored, 0.0, static_cast<double>(levels.size() - 1));
    const auto low = static_cast<std::size_t>(place);
    const std::size_t high = std::min(low + 1, levels.size() - 1);
    return levels[low] + (place - static_cast<double>(low)) * (levels[high] - levels[low]);
}

double Volume::codeOf(double value) const {
    const std::vector<double>& levels = contents_.levels;
    const auto above = static_cast<std::size_t>(std::upper_bound(levels.begin(), levels.end(), value) - levels.begin());
    if (above == 0 || above == levels.size()) {
        return above == 0 ? 0 : static_cast<double>(levels.size() - 1);
    }
    const double below = levels[above - 1];
    return static_cast<double>(above - 1) + (value - below) / (levels[above] - below);
}

double Volume::storedAt(glm::ivec3 voxel) const {
    const std::size_t index = storeIndex(layout_, glm::clamp(voxel, glm::ivec3(0), contents_.grid.dims - 1));
    switch (contents_.type) {
    case VoxelType::uint8: return reinterpret_cast<const std::uint8_t*>(bricks_)[index];
    case VoxelType::int16: return reinterpret_cast<const std::int16_t*>(bricks_)[index];
    case VoxelType::float32: return reinterpret_cast<const float*>(bricks_)[index];
    }
    return 0;
}

void Volume::copyRow(int y, int z, std::byte* destination) const {
    const std::size_t bytes = bytesPerVoxel(contents_.type);
    for (int x = 0; x < contents_.grid.dims.x; x += BrickLayout::kBrickCells) {
        const int count = std::min(BrickLayout::kBrickCells, contents_.grid.dims.x - x);
        std::memcpy(destination + static_cast<std::size_t>(x) * bytes, bricks_ + storeIndex(layout_, {x, y, z}) * bytes,
                    static_cast<std::size_t>(count) * bytes);
    }
}

double trilinear(const Volume& volume, const glm::dvec3& positionVoxel) {
    const glm::dvec3 low = glm::floor(positionVoxel);
    const glm::dvec3 f = positionVoxel - low;
    const glm::ivec3 i(low);
    const auto at = [&](int x, int y, int z) { return volume.storedAt(i + glm::ivec3(x, y, z)); };
    const auto row = [&](int y, int z) { return glm::mix(at(0, y, z), at(1, y, z), f.x); };
    const auto slice = [&](int z) { return glm::mix(row(0, z), row(1, z), f.y); };
    return volume.valueFromStored(glm::mix(slice(0), slice(1), f.z));
}

} // namespace limner
