#include "core/volume/joint_histogram.h"

#include "core/volume/brick_rows.h"

#include <tbb/blocked_range.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace limner {
namespace {

using Counts = std::vector<std::uint64_t>;

struct Binning {
    double low = 0;
    double perUnit = 0; ///< 0: a range without width, all in the first bin
    double last = 0;

    explicit Binning(const JointAxis& axis) : low(axis.range.low), last(axis.bins - 1.0) {
        const double span = axis.range.high - axis.range.low;
        perUnit = span > 0 && std::isfinite(axis.bins / span) ? axis.bins / span : 0;
    }
    [[nodiscard]] std::size_t bin(double value) const {
        return static_cast<std::size_t>(std::clamp((value - low) * perUnit, 0.0, last));
    }
};

/// Where a voxel lies in the store and in the volume.
template <typename T>
struct Place {
    const T* stored;
    glm::ivec3 voxel;
};

/// `secondAt(Place)`: the second measure at a voxel; called from many threads.
template <typename T, typename Second>
JointHistogram counted(const Volume& volume, const JointAxis& x, const JointAxis& y, Second secondAt, Task& task) {
    const Binning columns(x);
    const Binning rows(y);
    const std::size_t cells = static_cast<std::size_t>(x.bins) * static_cast<std::size_t>(y.bins);
    tbb::combinable<Counts> tables([cells] { return Counts(cells); });
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, volume.layout().brickCount()), [&](const auto& range) {
        Counts& table = tables.local();
        for (std::size_t b = range.begin(); b != range.end(); ++b) {
            task.throwIfCancelled();
            const OwnedBrick<T> brick = ownedBrick<T>(volume, b);
            for (int z = 0; z < brick.size.z; ++z) {
                for (int yy = 0; yy < brick.size.y; ++yy) {
                    const T* row = brick.row(yy, z);
                    for (int xx = 0; xx < brick.size.x; ++xx) {
                        const Place<T> place{row + xx, brick.origin + glm::ivec3(xx, yy, z)};
                        const std::size_t column = columns.bin(volume.valueFromStored(row[xx]));
                        ++table[rows.bin(secondAt(place)) * static_cast<std::size_t>(x.bins) + column];
                    }
                }
            }
        }
    });
    JointHistogram result{x.range, y.range, x.bins, y.bins, Counts(cells)};
    tables.combine_each([&](const Counts& table) {
        std::transform(result.counts.begin(), result.counts.end(), table.begin(), result.counts.begin(), std::plus<>());
    });
    return result;
}

} // namespace

JointHistogram jointHistogram(const Volume& volume, const JointAxis& x, const Volume& second, const JointAxis& y,
                              Task& task) {
    return withVoxelType(volume.type(), [&](auto* none) {
        using T = std::remove_const_t<std::remove_pointer_t<decltype(none)>>;
        const auto secondAt = [&](const Place<T>& place) { return second.valueAt(place.voxel); };
        return counted<T>(volume, x, y, secondAt, task);
    });
}

JointHistogram jointHistogramOfGradient(const Volume& volume, const JointAxis& x, double gradientMax, int rows,
                                        Task& task) {
    const double perStored = gradientMax > 0 ? std::abs(volume.contents().slope) / gradientMax : 0;
    const glm::dvec3 scale = perStored / (2.0 * volume.grid().spacingMm);
    return withVoxelType(volume.type(), [&](auto* none) {
        using T = std::remove_const_t<std::remove_pointer_t<decltype(none)>>;
        const auto secondAt = [scale](const Place<T>& place) {
            const T* p = place.stored; // the store repeats the border's voxels
            const auto across = [p](int offset) {
                return static_cast<double>(p[offset]) - static_cast<double>(p[-offset]);
            };
            const glm::dvec3 slope(across(1), across(BrickLayout::kRow), across(BrickLayout::kSlice));
            return std::min(1.0, glm::length(slope * scale));
        };
        return counted<T>(volume, x, {{0, 1}, rows}, secondAt, task);
    });
}

JointHistogram jointHistogramOfDistance(const Volume& volume, const JointAxis& x, const glm::dvec3& fromMm,
                                        const JointAxis& y, Task& task) {
    return withVoxelType(volume.type(), [&](auto* none) {
        using T = std::remove_const_t<std::remove_pointer_t<decltype(none)>>;
        const auto secondAt = [&](const Place<T>& place) {
            return glm::distance(volume.grid().mmFromVoxel(glm::dvec3(place.voxel)), fromMm);
        };
        return counted<T>(volume, x, y, secondAt, task);
    });
}

} // namespace limner
