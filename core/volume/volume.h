#pragma once

#include "core/volume/grid.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace limner {

/// How a volume keeps its voxels.
enum class VoxelType {
    uint8,   ///< 8-bit data as they are
    int16,   ///< 16-bit data; unsigned data are shifted by -32768 so that all 65,536 values are exact
    float32, ///< everything else, normalised to [0, 1] over the finite range
};

std::size_t bytesPerVoxel(VoxelType type);

/// What produced the data, as far as the file says or the values show.
enum class Modality { unknown, ct, mr, labels };

struct ValueRange {
    double low = 0;
    double high = 0;
    friend bool operator==(const ValueRange&, const ValueRange&) = default;
};

/// Layout of the voxel store: cubes of `kBrickCells`^3 *cells* with an apron, so that a trilinear sample and its
/// central differences read one brick only. Cell c of an axis spans the voxels c-1 and c, c in [0, dims): positions
/// from one voxel before the first centre up to the last centre; voxel indices outside the volume repeat the border
/// voxel. (A position past the last centre is moved onto it, see `trilinear`: the same value without a brick that holds
/// nothing else.) Brick b of an axis holds the cells [b*32, b*32+32), thus with the apron the voxels b*32-2 .. b*32+32;
/// in the brick's own count voxel b*32-2 is 0. Bricks lie one after the other, x fastest; the store has
/// `kStorePaddingBytes` readable bytes before and after.
struct BrickLayout {
    static constexpr int kBrickCells = 32;
    static constexpr int kLog2BrickCells = 5;
    static constexpr int kRow = 36;                       ///< voxels per row: 35 used, even for aligned pairs
    static constexpr int kSlice = kRow * 35;              ///< voxels per slice
    static constexpr int kBrickVoxels = kSlice * 35;      ///< voxels per brick
    static constexpr std::size_t kStorePaddingBytes = 64; ///< widest over-read of a vector load

    glm::ivec3 bricks{0}; ///< count per axis: ceil(dims / 32)

    [[nodiscard]] std::size_t brickCount() const {
        return static_cast<std::size_t>(bricks.x) * static_cast<std::size_t>(bricks.y) *
               static_cast<std::size_t>(bricks.z);
    }
};

/// An immutable grid of numbers. `value = slope * stored + intercept`, in the data's own unit (HU for CT).
/// Non-finite voxels of the file are stored as the lowest finite value and counted.
/// Thread-safe after construction. Memory: about 1.35 to 1.5 times the voxels.
class Volume {
  public:
    struct Contents {
        Grid grid;
        VoxelType type = VoxelType::uint8;
        double slope = 1;
        double intercept = 0;
        ValueRange range;          ///< of the finite values, in the data's unit
        std::size_t nonFinite = 0; ///< voxels that were NaN or infinite
        Modality modality = Modality::unknown;
        std::string unit; ///< "HU", or empty
        /// Rising values of the stored numbers 0, 1, 2 ... where they are uneven (core/volume/quantise.h); empty: the
        /// line of slope and intercept. That line then runs from the first level to the last: between voxels the
        /// stored numbers are interpolated, gradients are counted on the line, and only values are read off the levels.
        std::vector<double> levels;
    };

    /// `stored`: dims.x*dims.y*dims.z numbers of `contents.type`, x fastest. Builds the bricks in parallel.
    /// Throws Error(noResources) where the store cannot be had.
    Volume(Contents contents, std::span<const std::byte> stored);

    [[nodiscard]] const Grid& grid() const { return contents_.grid; }
    [[nodiscard]] const Contents& contents() const { return contents_; }
    [[nodiscard]] VoxelType type() const { return contents_.type; }
    [[nodiscard]] ValueRange range() const { return contents_.range; }
    [[nodiscard]] const BrickLayout& layout() const { return layout_; }
    /// First voxel of brick 0.
    [[nodiscard]] const std::byte* bricks() const { return bricks_; }
    [[nodiscard]] std::size_t bytes() const { return storeBytes_; }

    [[nodiscard]] double valueFromStored(double stored) const {
        return contents_.levels.empty() ? contents_.slope * stored + contents_.intercept : levelAt(stored);
    }
    [[nodiscard]] double storedFromValue(double value) const {
        return contents_.levels.empty() ? (value - contents_.intercept) / contents_.slope : codeOf(value);
    }

    /// Stored number of a voxel; indices are clamped to the volume.
    [[nodiscard]] double storedAt(glm::ivec3 voxel) const;
    [[nodiscard]] double valueAt(glm::ivec3 voxel) const { return valueFromStored(storedAt(voxel)); }
    /// Copies the dims.x stored numbers of a row as they are kept (dims.x * bytesPerVoxel bytes).
    void copyRow(int y, int z, std::byte* destination) const;

  private:
    /// Linear between the levels, the first before them and the last behind.
    [[nodiscard]] double levelAt(double stored) const;
    [[nodiscard]] double codeOf(double value) const;

    Contents contents_;
    BrickLayout layout_;
    struct Release {
        void operator()(std::byte* store) const;
    };
    std::unique_ptr<std::byte, Release> store_;
    std::size_t storeBytes_ = 0;
    const std::byte* bricks_ = nullptr;
};

/// Trilinear value in the data's unit at a position in voxel coordinates (voxel centres at integers), clamped to the
/// border. The exact interpolant in double: what the reference backend and picking use.
double trilinear(const Volume& volume, const glm::dvec3& positionVoxel);

} // namespace limner
