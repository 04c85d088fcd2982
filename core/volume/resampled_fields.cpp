#include "core/volume/brick_rows.h"
#include "core/volume/derived_fields.h"
#include "core/volume/field_parts.h"

#include <glm/common.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace limner {

namespace {

using fields::Numbers;

/// Where the voxels of one grid lie in another, in voxels of the other.
class GridMap {
  public:
    GridMap(const Grid& from, const Grid& to)
        : origin_(to.voxelFromMm(from.originMm)), matrix_(to.mmToVoxelMatrix() * from.voxelToMmMatrix()) {}

    [[nodiscard]] glm::dvec3 operator()(glm::ivec3 voxel) const { return origin_ + matrix_ * glm::dvec3(voxel); }

  private:
    glm::dvec3 origin_;
    glm::dmat3 matrix_;
};

/// Whether a position lies in a voxel's box, which reaches half a voxel past its centre.
bool inside(const glm::dvec3& position, glm::ivec3 dims) {
    const glm::dvec3 high = glm::dvec3(dims) - 0.5;
    return position.x >= -0.5 && position.y >= -0.5 && position.z >= -0.5 && position.x < high.x &&
           position.y < high.y && position.z < high.z;
}

template <typename T>
Numbers<T> copyOf(const Volume& volume) {
    const glm::ivec3 dims = volume.grid().dims;
    Numbers<T> copy(dims);
    tbb::parallel_for(0, dims.z, [&](int z) {
        for (int y = 0; y < dims.y; ++y) {
            volume.copyRow(y, z, reinterpret_cast<std::byte*>(copy.row(y, z)));
        }
    });
    return copy;
}

/// Trilinear between voxel centres, the border's value in the half voxel around them.
template <typename T>
double trilinearOf(const Numbers<T>& numbers, const glm::dvec3& position) {
    const glm::ivec3 last = numbers.dims() - 1;
    const glm::dvec3 p = glm::clamp(position, glm::dvec3(0), glm::dvec3(last));
    const glm::ivec3 low(p);
    const glm::ivec3 high = glm::min(low + 1, last);
    const glm::dvec3 f = p - glm::dvec3(low);
    const auto row = [&](int y, int z) {
        const T* at = numbers.row(y, z);
        return glm::mix(static_cast<double>(at[low.x]), static_cast<double>(at[high.x]), f.x);
    };
    const double below = glm::mix(row(low.y, low.z), row(high.y, low.z), f.y);
    return glm::mix(below, glm::mix(row(low.y, high.z), row(high.y, high.z), f.y), f.z);
}

/// Fills `out`, numbers of a volume on `grid`, with what `at` gives for each voxel's position in the other grid.
template <typename Out, typename At>
void fill(Numbers<Out>& out, const GridMap& map, Task& task, const At& at) {
    const glm::ivec3 dims = out.dims();
    tbb::parallel_for(0, dims.z, [&](int z) {
        task.throwIfCancelled();
        for (int y = 0; y < dims.y; ++y) {
            Out* row = out.row(y, z);
            for (int x = 0; x < dims.x; ++x) {
                row[x] = at(map({x, y, z}));
            }
        }
    });
}

} // namespace

std::shared_ptr<const Volume> resampledValues(const Volume& source, const Grid& grid, Task& task) {
    return fields::withinMemory([&] {
        constexpr double kSteps = 65535;
        constexpr double kShift = 32768; // int16 keeps step 0 as its least number
        const ValueRange range = source.range();
        Volume::Contents contents = source.contents();
        contents.grid = grid;
        contents.levels.clear();
        contents.type = VoxelType::int16;
        contents.slope = range.high > range.low ? (range.high - range.low) / kSteps : 1;
        contents.intercept = range.low + kShift * contents.slope;
        contents.nonFinite = 0;
        Numbers<std::int16_t> out(grid.dims);
        withVoxelType(source.type(), [&](auto* none) {
            using T = std::remove_cvref_t<decltype(*none)>;
            const Numbers<T> numbers = copyOf<T>(source);
            fill(out, GridMap(grid, source.grid()), task, [&](const glm::dvec3& position) {
                const double value = inside(position, numbers.dims())
                                         ? source.valueFromStored(trilinearOf(numbers, position))
                                         : range.low;
                const double steps = std::clamp((value - range.low) / contents.slope, 0.0, kSteps);
                return static_cast<std::int16_t>(std::floor(steps + 0.5) - kShift);
            });
        });
        return std::make_shared<const Volume>(contents, std::as_bytes(out.span()));
    });
}

std::shared_ptr<const Volume> labelSlots(const Volume& labels, const Grid& grid,
                                         const std::map<int, std::uint8_t>& slotOf, Task& task) {
    return fields::withinMemory([&] {
        const auto slotOfLabel = [&](std::optional<int> label) -> std::uint8_t {
            const auto found = label ? slotOf.find(*label) : slotOf.end();
            return found != slotOf.end() ? found->second : 0;
        };
        const Numbers<std::uint8_t> slots = fields::labelBytes(labels, slotOfLabel, task);
        Numbers<std::uint8_t> out(grid.dims);
        fill(out, GridMap(grid, labels.grid()), task, [&](const glm::dvec3& position) -> std::uint8_t {
            if (!inside(position, slots.dims())) {
                return 0;
            }
            const glm::ivec3 nearest = glm::min(glm::ivec3(glm::floor(position + 0.5)), slots.dims() - 1);
            return slots.row(nearest.y, nearest.z)[nearest.x];
        });
        const auto [low, high] = std::minmax_element(out.span().begin(), out.span().end());
        Volume::Contents contents;
        contents.grid = grid;
        contents.range = {static_cast<double>(*low), static_cast<double>(*high)};
        contents.modality = Modality::labels;
        return std::make_shared<const Volume>(contents, std::as_bytes(out.span()));
    });
}

} // namespace limner
