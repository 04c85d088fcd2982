#include "core/volume/field_parts.h"

#include "core/volume/brick_rows.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace limner::fields {

namespace {

constexpr int kRowLanes = 16;     // rows filtered side by side: a recursion's steps wait on each other, lanes do not
constexpr int kTileLanes = 64;    // four cache lines a step; two tiles of 1000 steps fit a core's own cache
constexpr int kLastShort = 65535; // steps of 16 bits
constexpr int kShiftOfShorts = 32768; // int16 keeps step 0 as its least number

/// Room for a bundle of up to `lanes` lines.
class Scratch {
  public:
    Scratch(int count, int lanes) : numbers_(2 * static_cast<std::size_t>(count) * static_cast<std::size_t>(lanes)) {}

    [[nodiscard]] LineBundle bundle(int count, int width) {
        return {numbers_.data(), numbers_.data() + numbers_.size() / 2, count, width};
    }

  private:
    std::vector<float> numbers_;
};

/// Filters lines whose steps lie `stride` apart, in place. The copies keep the steps together: in place, those of a
/// volume of 256^3 would all fall into the same few lines of the cache.
void filterTile(float* first, std::size_t stride, const LineBundle& bundle, const LineFilter& filter) {
    for (int k = 0; k < bundle.count; ++k) {
        std::copy_n(first + static_cast<std::size_t>(k) * stride, bundle.width, bundle.inAt(k));
    }
    filter(bundle);
    for (int k = 0; k < bundle.count; ++k) {
        std::copy_n(bundle.outAt(k), bundle.width, first + static_cast<std::size_t>(k) * stride);
    }
}

/// Filters all lines that start in the row at `first`.
void filterAcross(float* first, int rowLength, std::size_t stride, int count, const LineFilter& filter) {
    Scratch scratch(count, std::min(kTileLanes, rowLength));
    for (int x = 0; x < rowLength; x += kTileLanes) {
        const int width = std::min(kTileLanes, rowLength - x);
        filterTile(first + x, stride, scratch.bundle(count, width), filter);
    }
}

/// Weights of a sampled Gaussian from its middle outwards, together (both sides) 1.
std::vector<float> gaussianWeights(double sigma) {
    constexpr double kReach = 4; // sigmas: what is cut off is 6e-5, of 16 bits
    std::vector<double> exact;
    double sum = 0;
    for (int k = 0; k <= static_cast<int>(std::ceil(kReach * sigma)); ++k) {
        exact.push_back(std::exp(-0.5 * (k / sigma) * (k / sigma)));
        sum += (k == 0 ? 1 : 2) * exact.back();
    }
    std::vector<float> weights;
    for (const double weight : exact) {
        weights.push_back(static_cast<float>(weight / sum));
    }
    return weights;
}

/// The border voxel is repeated outside the volume.
void convolve(const LineBundle& lines, const std::vector<float>& weights) {
    for (int k = 0; k < lines.count; ++k) {
        float* out = lines.outAt(k);
        const float* middle = lines.inAt(k);
        for (int i = 0; i < lines.width; ++i) {
            out[i] = weights[0] * middle[i];
        }
        for (int t = 1; t < static_cast<int>(weights.size()); ++t) {
            const float* a = lines.inAt(std::max(0, k - t));
            const float* b = lines.inAt(std::min(lines.count - 1, k + t));
            const float weight = weights[static_cast<std::size_t>(t)];
            for (int i = 0; i < lines.width; ++i) {
                out[i] += weight * (a[i] + b[i]);
            }
        }
    }
}

/// Reads the rows of a slice and filters them along x.
template <typename T>
void readSlice(const Volume& source, const Reading& reading, int z, const LineFilter& filter, Numbers<float>& out) {
    const glm::ivec3 dims = source.grid().dims;
    std::vector<T> row(static_cast<std::size_t>(dims.x));
    Scratch scratch(dims.x, kRowLanes);
    for (int y = 0; y < dims.y; y += kRowLanes) {
        const LineBundle bundle = scratch.bundle(dims.x, std::min(kRowLanes, dims.y - y));
        for (int lane = 0; lane < bundle.width; ++lane) {
            source.copyRow(y + lane, z, reinterpret_cast<std::byte*>(row.data()));
            for (int x = 0; x < dims.x; ++x) {
                const float number =
                    (static_cast<float>(row[static_cast<std::size_t>(x)]) - reading.base) * reading.scale;
                bundle.inAt(x)[lane] = reading.squared ? number * number : number;
            }
        }
        if (filter) {
            filter(bundle);
        }
        for (int lane = 0; lane < bundle.width; ++lane) {
            float* to = out.row(y + lane, z);
            for (int x = 0; x < dims.x; ++x) {
                to[x] = filter ? bundle.outAt(x)[lane] : bundle.inAt(x)[lane];
            }
        }
    }
}

/// Least and largest number.
ValueRange rangeOf(const Numbers<float>& field) {
    struct LowHigh {
        float low = std::numeric_limits<float>::infinity();
        float high = -std::numeric_limits<float>::infinity();
    };
    constexpr std::size_t kLanes = 16; // one chain of minima would wait on itself
    const std::span<const float> numbers = field.span();
    const LowHigh found = tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, (numbers.size() + kLanes - 1) / kLanes, 1 << 12), LowHigh{},
        [&](const tbb::blocked_range<std::size_t>& range, LowHigh lowHigh) {
            std::array<float, kLanes> low;
            std::array<float, kLanes> high;
            low.fill(lowHigh.low);
            high.fill(lowHigh.high);
            const std::size_t end = std::min(range.end() * kLanes, numbers.size());
            for (std::size_t first = range.begin() * kLanes; first < end; first += kLanes) {
                const std::size_t lanes = std::min(kLanes, end - first);
                for (std::size_t i = 0; i < lanes; ++i) {
                    const float number = numbers[first + i];
                    low[i] = number < low[i] ? number : low[i];
                    high[i] = number > high[i] ? number : high[i];
                }
            }
            return LowHigh{*std::min_element(low.begin(), low.end()), *std::max_element(high.begin(), high.end())};
        },
        [](const LowHigh& a, const LowHigh& b) {
            return LowHigh{std::min(a.low, b.low), std::max(a.high, b.high)};
        });
    return {found.low, found.high};
}

} // namespace

std::array<LineFilter, 3> gaussianFilters(glm::ivec3 dims, const glm::dvec3& sigmaVoxels) {
    std::array<LineFilter, 3> filters;
    for (int axis = 0; axis < 3; ++axis) {
        if (sigmaVoxels[axis] > 0 && dims[axis] > 1) {
            filters[static_cast<std::size_t>(axis)] =
                [weights = gaussianWeights(sigmaVoxels[axis])](const LineBundle& lines) { convolve(lines, weights); };
        }
    }
    return filters;
}

Numbers<float> filtered(const Volume& source, const Reading& reading, const std::array<LineFilter, 3>& filters,
                        Task& task) {
    const glm::ivec3 dims = source.grid().dims;
    const auto rowStride = static_cast<std::size_t>(dims.x);
    Numbers<float> field(dims);
    tbb::parallel_for(0, dims.z, [&](int z) {
        task.throwIfCancelled();
        withVoxelType(source.type(), [&](auto* none) {
            readSlice<std::remove_cvref_t<decltype(*none)>>(source, reading, z, filters[0], field);
        });
        if (filters[1]) {
            filterAcross(field.row(0, z), dims.x, rowStride, dims.y, filters[1]);
        }
    });
    task.progress(0.6);
    if (filters[2]) {
        tbb::parallel_for(0, dims.y, [&](int y) {
            task.throwIfCancelled();
            filterAcross(field.row(y, 0), dims.x, rowStride * static_cast<std::size_t>(dims.y), dims.z, filters[2]);
        });
    }
    task.progress(0.9);
    return field;
}

float storedBase(const Volume& source) { return static_cast<float>(source.storedFromValue(source.range().low)); }

std::shared_ptr<const Volume> keptAsInt16(Volume::Contents contents, const Numbers<float>& field, double scale,
                                          double offset) {
    const ValueRange range = rangeOf(field);
    const double step = range.high > range.low ? (range.high - range.low) / kLastShort : 1;
    const auto low = static_cast<float>(range.low);
    const auto perUnit = static_cast<float>(1 / step);
    Numbers<std::int16_t> kept(field.dims());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, field.span().size(), 1 << 16), [&](const auto& part) {
        const float* from = field.span().data();
        std::int16_t* to = kept.span().data();
        for (std::size_t i = part.begin(); i < part.end(); ++i) {
            const float steps = std::min((from[i] - low) * perUnit + 0.5F, static_cast<float>(kLastShort));
            to[i] = static_cast<std::int16_t>(static_cast<int>(steps) - kShiftOfShorts);
        }
    });
    const double ends[2] = {scale * range.low + offset, scale * range.high + offset};
    contents.type = VoxelType::int16;
    contents.slope = scale * step;
    contents.intercept = scale * (range.low + kShiftOfShorts * step) + offset;
    contents.range = {std::min(ends[0], ends[1]), std::max(ends[0], ends[1])};
    contents.nonFinite = 0;
    return std::make_shared<const Volume>(std::move(contents), std::as_bytes(kept.span()));
}

std::shared_ptr<const Volume> keptLike(const Volume& source, Numbers<float> field, float base) {
    Volume::Contents contents = source.contents();
    contents.levels.clear(); // what was computed of codes is no code
    contents.modality = contents.modality == Modality::labels ? Modality::unknown : contents.modality;
    if (source.type() != VoxelType::float32) {
        return keptAsInt16(std::move(contents), field, contents.slope, source.valueFromStored(base));
    }
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, field.span().size(), 1 << 16), [&](const auto& part) {
        for (float& number : field.span().subspan(part.begin(), part.size())) {
            number += base;
        }
    });
    const ValueRange stored = rangeOf(field);
    const double ends[2] = {source.valueFromStored(stored.low), source.valueFromStored(stored.high)};
    contents.range = {std::min(ends[0], ends[1]), std::max(ends[0], ends[1])};
    contents.nonFinite = 0;
    return std::make_shared<const Volume>(std::move(contents), std::as_bytes(field.span()));
}

} // namespace limner::fields
