#include "core/volume/label_counts.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace limner {

namespace {

constexpr int kLowest16 = -32768;
constexpr std::size_t kNumbers = 65536; // stored numbers of 16 bits

using Counts = std::vector<std::size_t>; // of the stored numbers from kLowest16 on

template <typename T>
Counts countStored(const Volume& volume) {
    const glm::ivec3 dims = volume.grid().dims;
    tbb::enumerable_thread_specific<Counts> parts([] { return Counts(kNumbers, 0); });
    tbb::parallel_for(tbb::blocked_range<int>(0, dims.z), [&](const tbb::blocked_range<int>& slices) {
        Counts& counts = parts.local();
        std::vector<T> row(static_cast<std::size_t>(dims.x));
        for (int z = slices.begin(); z < slices.end(); ++z) {
            for (int y = 0; y < dims.y; ++y) {
                volume.copyRow(y, z, reinterpret_cast<std::byte*>(row.data()));
                for (const T stored : row) {
                    ++counts[static_cast<std::size_t>(stored - kLowest16)];
                }
            }
        }
    });
    Counts sum(kNumbers, 0);
    for (const Counts& part : parts) {
        for (std::size_t i = 0; i < sum.size(); ++i) {
            sum[i] += part[i];
        }
    }
    return sum;
}

bool isWhole(double value) {
    constexpr double kFarthest = 1 << 30; // a label is an int
    return std::trunc(value) == value && std::abs(value) <= kFarthest;
}

} // namespace

std::optional<std::map<int, std::size_t>> countLabels(const Volume& labels) {
    const Volume::Contents& contents = labels.contents();
    const bool whole = isWhole(contents.slope) && isWhole(contents.intercept) && isWhole(contents.range.low) &&
                       isWhole(contents.range.high);
    if (contents.type == VoxelType::float32 || !whole) {
        return std::nullopt;
    }
    const Counts stored =
        contents.type == VoxelType::uint8 ? countStored<std::uint8_t>(labels) : countStored<std::int16_t>(labels);
    std::map<int, std::size_t> counts;
    for (std::size_t i = 0; i < stored.size(); ++i) {
        if (stored[i] > 0) {
            counts[static_cast<int>(labels.valueFromStored(static_cast<double>(i) + kLowest16))] = stored[i];
        }
    }
    return counts;
}

} // namespace limner
