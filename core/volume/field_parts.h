#pragma once

#include "core/base/error.h"
#include "core/base/task.h"
#include "core/volume/volume.h"

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <new>
#include <optional>
#include <span>

/// What the derived fields share. Internal to core/volume.
namespace limner::fields {

/// One number per voxel while a field is worked on, x fastest; starts uninitialised. Throws std::bad_alloc.
template <typename T>
class Numbers {
  public:
    explicit Numbers(glm::ivec3 dims)
        : dims_(dims), count_(Grid{dims}.voxelCount()), numbers_(std::make_unique_for_overwrite<T[]>(count_)) {}

    [[nodiscard]] glm::ivec3 dims() const { return dims_; }
    [[nodiscard]] T* row(int y, int z) { return numbers_.get() + rowStart(y, z); }
    [[nodiscard]] const T* row(int y, int z) const { return numbers_.get() + rowStart(y, z); }
    [[nodiscard]] std::span<T> span() { return {numbers_.get(), count_}; }
    [[nodiscard]] std::span<const T> span() const { return {numbers_.get(), count_}; }

  private:
    [[nodiscard]] std::size_t rowStart(int y, int z) const {
        return (static_cast<std::size_t>(z) * static_cast<std::size_t>(dims_.y) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(dims_.x);
    }
    glm::ivec3 dims_;
    std::size_t count_;
    std::unique_ptr<T[]> numbers_;
};

/// Runs `work`; memory that cannot be had becomes Error(noResources).
template <typename Work>
auto withinMemory(Work&& work) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        throw Error(ErrorKind::noResources, {"not enough memory for a field of the volume", "", "",
                                             "close other programs or load a part of the volume"});
    }
}

/// Neighbouring lines of voxels along one axis: step k holds `width` numbers side by side, one of each line, at
/// `in + k * width`; `out` likewise, another place than `in`.
struct LineBundle {
    float* in = nullptr; ///< scratch: a filter may leave anything in it
    float* out = nullptr;
    int count = 0; ///< steps
    int width = 0; ///< lines

    [[nodiscard]] float* inAt(int step) const {
        return in + static_cast<std::ptrdiff_t>(step) * static_cast<std::ptrdiff_t>(width);
    }
    [[nodiscard]] float* outAt(int step) const {
        return out + static_cast<std::ptrdiff_t>(step) * static_cast<std::ptrdiff_t>(width);
    }
};

/// Writes `out` of a bundle; called from many threads. Empty: the axis stays as it is.
using LineFilter = std::function<void(const LineBundle&)>;

/// A Gaussian blur, see `gaussianBlurred`.
std::array<LineFilter, 3> gaussianFilters(glm::ivec3 dims, const glm::dvec3& sigmaVoxels);

/// What a stored number counts as: (stored - base) * scale, or the square of that.
struct Reading {
    float base = 0;
    float scale = 1;
    bool squared = false;
};

/// The stored numbers as `reading` has them, filtered along x, y and z.
Numbers<float> filtered(const Volume& source, const Reading& reading, const std::array<LineFilter, 3>& filters,
                        Task& task);

/// A number inside the source's stored range to count from: what 32 bits resolve is then a part of the range, wherever
/// the range lies.
float storedBase(const Volume& source);

/// A field of the source's stored numbers less `base` as a volume: int16 over the field's own range, float32 in the
/// source's units where the source is float32.
std::shared_ptr<const Volume> keptLike(const Volume& source, Numbers<float> field, float base);

/// A field as int16 over its own range, value = scale * number + offset; `contents` brings grid, modality and unit.
std::shared_ptr<const Volume> keptAsInt16(Volume::Contents contents, const Numbers<float>& field, double scale,
                                          double offset);

/// Label that a stored number stands for; nothing for fractions and what no int holds. Floats keep labels only to their
/// own precision over the volume's range.
std::optional<int> labelOfStored(const Volume& labels, double stored);

/// One byte per voxel: what `byteOf` says of its label (nothing: no label).
Numbers<std::uint8_t> labelBytes(const Volume& labels, const std::function<std::uint8_t(std::optional<int>)>& byteOf,
                                 Task& task);

} // namespace limner::fields
