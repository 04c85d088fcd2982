#include "core/volume/brick_rows.h"
#include "core/volume/derived_fields.h"
#include "core/volume/field_parts.h"

#include <tbb/blocked_range.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <type_traits>
#include <unordered_map>

namespace limner {

namespace fields {

namespace {

/// What `byteOf` says of every number that a store of T may hold.
template <typename T>
class ByteTable {
  public:
    ByteTable(const Volume& labels, const std::function<std::uint8_t(std::optional<int>)>& byteOf) {
        for (int stored = kLowest; stored <= std::numeric_limits<T>::max(); ++stored) {
            bytes_.push_back(byteOf(labelOfStored(labels, stored)));
        }
    }
    [[nodiscard]] std::uint8_t operator()(T stored) const { return bytes_[static_cast<std::size_t>(stored - kLowest)]; }

  private:
    static constexpr int kLowest = std::numeric_limits<T>::lowest();
    std::vector<std::uint8_t> bytes_;
};

/// The same for floats, which no table holds.
template <>
class ByteTable<float> {
  public:
    ByteTable(const Volume& labels, const std::function<std::uint8_t(std::optional<int>)>& byteOf)
        : labels_(labels), byteOf_(byteOf) {}
    [[nodiscard]] std::uint8_t operator()(float stored) const { return byteOf_(labelOfStored(labels_, stored)); }

  private:
    const Volume& labels_;
    const std::function<std::uint8_t(std::optional<int>)>& byteOf_;
};

} // namespace

std::optional<int> labelOfStored(const Volume& labels, double stored) {
    const double value = labels.valueFromStored(stored);
    const double nearest = std::round(value);
    constexpr double kFloatStep = 1.0 / (1 << 22); // float32 over the range, and a rounding on the way there
    const double largest = std::max(std::abs(labels.range().low), std::abs(labels.range().high));
    const double tolerance = std::clamp(kFloatStep * largest, 1e-6, 0.25);
    if (!(std::abs(value - nearest) <= tolerance) || std::abs(nearest) > std::numeric_limits<int>::max()) {
        return std::nullopt;
    }
    return static_cast<int>(nearest);
}

Numbers<std::uint8_t> labelBytes(const Volume& labels, const std::function<std::uint8_t(std::optional<int>)>& byteOf,
                                 Task& task) {
    const glm::ivec3 dims = labels.grid().dims;
    Numbers<std::uint8_t> bytes(dims);
    withVoxelType(labels.type(), [&](auto* none) {
        using T = std::remove_cvref_t<decltype(*none)>;
        const ByteTable<T> table(labels, byteOf);
        tbb::parallel_for(0, dims.z, [&](int z) {
            task.throwIfCancelled();
            std::vector<T> row(static_cast<std::size_t>(dims.x));
            for (int y = 0; y < dims.y; ++y) {
                labels.copyRow(y, z, reinterpret_cast<std::byte*>(row.data()));
                std::transform(row.begin(), row.end(), bytes.row(y, z), [&](T stored) { return table(stored); });
            }
        });
    });
    return bytes;
}

} // namespace fields

namespace {

constexpr std::size_t kMostLabels = 65536;

template <typename T>
using StoredCounts = std::unordered_map<T, std::size_t>;

/// How often each stored number occurs; cut short where there are too many.
template <typename T>
StoredCounts<T> countStored(const Volume& volume) {
    tbb::combinable<StoredCounts<T>> parts;
    std::atomic<bool> tooMany{false};
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, volume.layout().brickCount()), [&](const auto& range) {
        StoredCounts<T>& counts = parts.local();
        for (std::size_t b = range.begin(); b != range.end() && !tooMany; ++b) {
            const OwnedBrick<T> brick = ownedBrick<T>(volume, b);
            for (int z = 0; z < brick.size.z; ++z) {
                for (int y = 0; y < brick.size.y; ++y) {
                    const T* row = brick.row(y, z);
                    for (int x = 0; x < brick.size.x;) { // labels come in runs
                        const int start = x;
                        while (x < brick.size.x && row[x] == row[start]) {
                            ++x;
                        }
                        counts[row[start]] += static_cast<std::size_t>(x - start);
                    }
                }
            }
            if (counts.size() > kMostLabels) {
                tooMany = true;
            }
        }
    });
    StoredCounts<T> sum;
    parts.combine_each([&](const StoredCounts<T>& counts) {
        for (const auto& [stored, count] : counts) {
            sum[stored] += count;
        }
    });
    return sum;
}

} // namespace

std::optional<std::map<int, std::size_t>> labelCounts(const Volume& labels) {
    return withVoxelType(labels.type(), [&](auto* none) -> std::optional<std::map<int, std::size_t>> {
        std::map<int, std::size_t> counts;
        for (const auto& [stored, count] : countStored<std::remove_cvref_t<decltype(*none)>>(labels)) {
            const std::optional<int> label = fields::labelOfStored(labels, static_cast<double>(stored));
            if (!label) {
                return std::nullopt;
            }
            counts[*label] += count;
        }
        return counts.size() > kMostLabels ? std::nullopt : std::optional(std::move(counts));
    });
}

} // namespace limner
