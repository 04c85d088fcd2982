#include "core/volume/brick_rows.h"
#include "core/volume/derived_fields.h"
#include "core/volume/field_parts.h"
#include "core/volume/histogram.h"

#include <glm/common.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

namespace limner {

namespace {

using fields::Numbers;

/// Share of the voxels on the twelve edges of the volume's box that lie above a value.
double shareOnEdges(const Volume& volume, double value) {
    const glm::ivec3 last = volume.grid().dims - 1;
    double above = 0;
    double count = 0;
    for (int axis = 0; axis < 3; ++axis) {
        for (int edge = 0; edge < 4; ++edge) {
            glm::ivec3 voxel(0);
            voxel[(axis + 1) % 3] = (edge & 1) * last[(axis + 1) % 3];
            voxel[(axis + 2) % 3] = (edge >> 1) * last[(axis + 2) % 3];
            for (voxel[axis] = 0; voxel[axis] <= last[axis]; ++voxel[axis]) {
                above += volume.valueAt(voxel) > value ? 1 : 0;
                count += 1;
            }
        }
    }
    return above / count;
}

/// Value above which voxels are matter; below all where the volume has no background.
double matterThreshold(const Volume& volume) {
    constexpr int kBins = 1024;                 // as the examination of scans for presets has
    constexpr double kMostMatterOnEdges = 0.25; // a thing that is cut has about half of its voxels above, noise too
    const double otsu = computeHistogram(volume, kBins).otsu();
    return shareOnEdges(volume, otsu) <= kMostMatterOnEdges ? otsu : -std::numeric_limits<double>::infinity();
}

/// Count of the voxels above a value and the sum of what `of` makes of their stored numbers; the order of adding does
/// not depend on threads.
struct Sum {
    double count = 0;
    double sum = 0;
};

template <typename Of>
Sum sumAbove(const Volume& volume, double threshold, Task& task, const Of& of) {
    std::vector<Sum> parts(volume.layout().brickCount());
    withVoxelType(volume.type(), [&](auto* none) {
        using T = std::remove_cvref_t<decltype(*none)>;
        tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t b) {
            task.throwIfCancelled();
            const OwnedBrick<T> brick = ownedBrick<T>(volume, b);
            for (int z = 0; z < brick.size.z; ++z) {
                for (int y = 0; y < brick.size.y; ++y) {
                    const T* row = brick.row(y, z);
                    for (int x = 0; x < brick.size.x; ++x) {
                        const auto stored = static_cast<double>(row[x]);
                        if (volume.valueFromStored(stored) > threshold) {
                            parts[b].count += 1;
                            parts[b].sum += of(stored);
                        }
                    }
                }
            }
        });
    });
    Sum whole;
    for (const Sum& part : parts) {
        whole.count += part.count;
        whole.sum += part.sum;
    }
    return whole;
}

/// Of stored numbers.
struct Statistics {
    double mean = 0;
    double deviation = 0; ///< standard deviation; 0 where the numbers differ by no more than they are rounded
};

Statistics statisticsAbove(const Volume& volume, double threshold, Task& task) {
    const double base = volume.storedFromValue(volume.range().low);
    const double span = std::abs(volume.storedFromValue(volume.range().high) - base);
    const Sum first = sumAbove(volume, threshold, task, [&](double stored) { return stored - base; });
    if (!(first.count > 0)) {
        return {};
    }
    const double mean = base + first.sum / first.count;
    const Sum squares =
        sumAbove(volume, threshold, task, [&](double stored) { return (stored - mean) * (stored - mean); });
    const double deviation = std::sqrt(squares.sum / squares.count);
    constexpr double kRounding = 1.0 / (1 << 24); // of float32 over the range
    return {mean, deviation > kRounding * span ? deviation : 0};
}

Statistics statisticsOfMatter(const Volume& volume, Task& task) {
    const double threshold = matterThreshold(volume);
    const Statistics matter = statisticsAbove(volume, threshold, task);
    return matter.deviation > 0 ? matter : statisticsAbove(volume, -std::numeric_limits<double>::infinity(), task);
}

constexpr double kWhole = 32767; // int16 that stands for 1

/// The contrast of all voxels as it is kept, with d and var in units of S: 1 - 1 / ((1 + d^2) (1 + var)).
Numbers<std::int16_t> contrasts(const Volume& volume, const Statistics& whole, double sigmaVoxels, Task& task) {
    const Grid& grid = volume.grid();
    const auto filters = fields::gaussianFilters(grid.dims, sigmaVoxels * grid.smallestSpacingMm() / grid.spacingMm);
    // Counted from the mean, so that a variance is no small difference of large squares, and in units of S, so that
    // what is left of one in 32 bits is far below what d makes of it.
    fields::Reading reading{static_cast<float>(whole.mean), static_cast<float>(1 / whole.deviation), false};
    const double rounding = (reading.base - whole.mean) / whole.deviation;
    Task forMeans(task, 0.1, 0.5);
    const Numbers<float> means = fields::filtered(volume, reading, filters, forMeans);
    reading.squared = true;
    Task forSquares(task, 0.5, 0.9);
    const Numbers<float> squares = fields::filtered(volume, reading, filters, forSquares);
    Numbers<std::int16_t> out(grid.dims);
    tbb::parallel_for(0, grid.dims.z, [&](int z) {
        task.throwIfCancelled();
        for (int y = 0; y < grid.dims.y; ++y) {
            for (int x = 0; x < grid.dims.x; ++x) {
                const double mean = means.row(y, z)[x];
                const double variance = std::max(0.0, squares.row(y, z)[x] - mean * mean);
                const double difference = mean + rounding;
                const double squared = difference * difference;
                const double excess = squared + variance + squared * variance; // (1 + d^2) (1 + var) - 1
                out.row(y, z)[x] = static_cast<std::int16_t>(std::lround(kWhole * (excess / (1 + excess))));
            }
        }
    });
    return out;
}

} // namespace

std::shared_ptr<const Volume> localContrast(const Volume& volume, double sigmaVoxels, Task& task) {
    return fields::withinMemory([&] {
        const Statistics whole = statisticsOfMatter(volume, task);
        task.progress(0.1);
        Numbers<std::int16_t> stored(volume.grid().dims);
        if (whole.deviation > 0) {
            stored = contrasts(volume, whole, sigmaVoxels, task);
        } else {
            std::fill(stored.span().begin(), stored.span().end(), std::int16_t{0});
        }
        const auto [low, high] = std::minmax_element(stored.span().begin(), stored.span().end());
        Volume::Contents contents;
        contents.grid = volume.grid();
        contents.type = VoxelType::int16;
        contents.slope = 1 / kWhole;
        contents.range = {*low / kWhole, *high / kWhole};
        auto field = std::make_shared<const Volume>(std::move(contents), std::as_bytes(stored.span()));
        task.progress(1);
        return field;
    });
}

} // namespace limner
