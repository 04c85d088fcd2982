#include "core/volume/histogram.h"

#include "core/volume/brick_rows.h"

#include <tbb/blocked_range.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <type_traits>

namespace limner {

namespace {

using Counts = std::vector<std::uint64_t>;

/// Maps a value of the volume to its bin.
struct Binning {
    double low = 0;
    double binsPerUnit = 0; ///< 0: constant volume
    int bins = 1;

    Binning(ValueRange range, int count) : low(range.low), bins(count) {
        const double span = range.high - range.low;
        binsPerUnit = span > 0 && std::isfinite(count / span) ? count / span : 0;
    }
    [[nodiscard]] std::size_t bin(double value) const {
        return static_cast<std::size_t>(std::clamp((value - low) * binsPerUnit, 0.0, bins - 1.0));
    }
};

/// Counts every stored number of an integer type on its own: exact whatever bins are asked for.
template <typename T>
Counts countStored(const Volume& volume) {
    constexpr int kNumbers = 1 << (8 * sizeof(T));
    constexpr int kLowest = std::is_signed_v<T> ? kNumbers / 2 : 0;
    constexpr int kLanes = 2; // neighbours are often equal: two tables keep the increments from waiting on each other
    tbb::combinable<std::vector<std::uint32_t>> tables([] { return std::vector<std::uint32_t>(kLanes * kNumbers); });
    // 32 bits suffice per thread: no store of 2^32 voxels of one value fits the memory of a machine that would care.
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, volume.layout().brickCount()), [&](const auto& range) {
        std::uint32_t* table = tables.local().data();
        for (std::size_t b = range.begin(); b != range.end(); ++b) {
            const OwnedBrick<T> brick = ownedBrick<T>(volume, b);
            for (int z = 0; z < brick.size.z; ++z) {
                for (int y = 0; y < brick.size.y; ++y) {
                    const T* row = brick.row(y, z);
                    for (int x = 0; x < brick.size.x; ++x) {
                        ++table[(x & 1) * kNumbers + row[x] + kLowest];
                    }
                }
            }
        }
    });
    Counts sum(kNumbers);
    tables.combine_each([&](const std::vector<std::uint32_t>& table) {
        for (int i = 0; i < kNumbers; ++i) {
            sum[i] += std::uint64_t{table[i]} + table[kNumbers + i];
        }
    });
    return sum;
}

Counts countFloats(const Volume& volume, const Binning& binning) {
    tbb::combinable<Counts> tables([&] { return Counts(binning.bins); });
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, volume.layout().brickCount()), [&](const auto& range) {
        Counts& table = tables.local();
        for (std::size_t b = range.begin(); b != range.end(); ++b) {
            const OwnedBrick<float> brick = ownedBrick<float>(volume, b);
            for (int z = 0; z < brick.size.z; ++z) {
                for (int y = 0; y < brick.size.y; ++y) {
                    const float* row = brick.row(y, z);
                    for (int x = 0; x < brick.size.x; ++x) {
                        ++table[binning.bin(volume.valueFromStored(row[x]))];
                    }
                }
            }
        }
    });
    Counts sum(binning.bins);
    tables.combine_each([&](const Counts& table) {
        std::transform(sum.begin(), sum.end(), table.begin(), sum.begin(), std::plus<>());
    });
    return sum;
}

template <typename T>
Counts countInteger(const Volume& volume, const Binning& binning) {
    const Counts stored = countStored<T>(volume);
    const int lowest = std::is_signed_v<T> ? static_cast<int>(stored.size()) / 2 : 0;
    Counts counts(binning.bins);
    for (std::size_t i = 0; i < stored.size(); ++i) {
        if (stored[i] != 0) {
            counts[binning.bin(volume.valueFromStored(static_cast<double>(i) - lowest))] += stored[i];
        }
    }
    return counts;
}

/// Gaussian smoothing; the ends repeat.
std::vector<double> smoothed(const Counts& counts, double sigma) {
    const int reach = std::max(1, static_cast<int>(std::ceil(3 * sigma))); // 3 sigma hold 99.7 % of a Gaussian
    std::vector<double> kernel;
    for (int i = -reach; i <= reach; ++i) {
        kernel.push_back(std::exp(-0.5 * i * i / (sigma * sigma)));
    }
    const double sum = std::accumulate(kernel.begin(), kernel.end(), 0.0);
    const int size = static_cast<int>(counts.size());
    std::vector<double> out(counts.size());
    for (int i = 0; i < size; ++i) {
        for (int k = -reach; k <= reach; ++k) {
            out[i] += kernel[k + reach] / sum * static_cast<double>(counts[std::clamp(i + k, 0, size - 1)]);
        }
    }
    return out;
}

struct Peak {
    int bin = 0;
    double height = 0;
    double saddle = 0; ///< level at which it joins a higher one
};

/// Maxima of a curve with the saddle that ties each to a higher one (0 for the highest): watershed from the top.
std::vector<Peak> maxima(const std::vector<double>& curve) {
    const int size = static_cast<int>(curve.size());
    std::vector<int> order(curve.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return curve[a] > curve[b]; });
    std::vector<Peak> peaks;
    std::vector<int> parent; // of a peak: the higher one it joined
    std::vector<int> owner(curve.size(), -1);
    const auto top = [&](int peak) {
        while (parent[peak] != peak) {
            peak = parent[peak];
        }
        return peak;
    };
    for (const int i : order) {
        const int left = i > 0 && owner[i - 1] >= 0 ? top(owner[i - 1]) : -1;
        const int right = i + 1 < size && owner[i + 1] >= 0 ? top(owner[i + 1]) : -1;
        if (left < 0 && right < 0) {
            owner[i] = static_cast<int>(peaks.size());
            parent.push_back(owner[i]);
            peaks.push_back({i, curve[i], 0});
        } else if (left >= 0 && right >= 0 && left != right) {
            const int higher = peaks[left].height >= peaks[right].height ? left : right;
            const int lower = higher == left ? right : left;
            peaks[lower].saddle = curve[i];
            parent[lower] = higher;
            owner[i] = higher;
        } else {
            owner[i] = left >= 0 ? left : right;
        }
    }
    return peaks;
}

/// Class sums of a histogram for Otsu's criterion.
class ClassSums {
  public:
    explicit ClassSums(const std::vector<std::uint64_t>& counts) {
        mass_.push_back(0);
        moment_.push_back(0);
        for (std::size_t i = 0; i < counts.size(); ++i) {
            const auto count = static_cast<double>(counts[i]);
            mass_.push_back(mass_.back() + count);
            moment_.push_back(moment_.back() + count * static_cast<double>(i));
        }
    }
    /// Mass times squared mean of the bins [from, to): what the sum over classes of makes the between-class variance.
    [[nodiscard]] double part(std::size_t from, std::size_t to) const {
        const double mass = mass_[to] - mass_[from];
        const double moment = moment_[to] - moment_[from];
        return mass > 0 ? moment * moment / mass : 0;
    }

  private:
    std::vector<double> mass_;
    std::vector<double> moment_;
};

} // namespace

double Histogram::binCentre(std::size_t bin) const {
    return range.low + (static_cast<double>(bin) + 0.5) * (range.high - range.low) / static_cast<double>(counts.size());
}

double Histogram::lowerEdge(std::size_t bin) const {
    return range.low + static_cast<double>(bin) * (range.high - range.low) / static_cast<double>(counts.size());
}

double Histogram::percentile(double fraction) const {
    const double total = static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}));
    const double wanted = std::clamp(fraction, 0.0, 1.0) * total;
    const double width = (range.high - range.low) / static_cast<double>(counts.size());
    double before = 0;
    for (std::size_t bin = 0; bin < counts.size(); ++bin) {
        const auto count = static_cast<double>(counts[bin]);
        if (count > 0 && before + count >= wanted) {
            return range.low + (static_cast<double>(bin) + (wanted - before) / count) * width;
        }
        before += count;
    }
    return range.high;
}

std::vector<double> Histogram::peaks(std::size_t atMost) const {
    constexpr double kSmoothing = 1.0 / 128; // sigma as a share of the range: tissues lie further apart, noise does not
    constexpr double kClear = 1.25;          // a peak stands at least a quarter above its saddle ...
    constexpr double kMass = 1e-5;           // ... and its bin holds more than stray voxels (170 of 256^3)
    const std::vector<double> curve = smoothed(counts, std::max(0.8, kSmoothing * static_cast<double>(counts.size())));
    const double total = std::accumulate(curve.begin(), curve.end(), 0.0);
    std::vector<Peak> clear;
    for (const Peak& peak : maxima(curve)) {
        if (peak.height > kClear * peak.saddle && peak.height > kMass * total) {
            clear.push_back(peak);
        }
    }
    std::stable_sort(clear.begin(), clear.end(),
                     [](const Peak& a, const Peak& b) { return a.height - a.saddle > b.height - b.saddle; });
    std::vector<double> values;
    for (std::size_t i = 0; i < std::min(atMost, clear.size()); ++i) {
        values.push_back(binCentre(static_cast<std::size_t>(clear[i].bin)));
    }
    return values;
}

double Histogram::otsu() const {
    const ClassSums sums(counts);
    double best = -1;
    double threshold = range.low;
    for (std::size_t t = 1; t < counts.size(); ++t) {
        if (const double score = sums.part(0, t) + sums.part(t, counts.size()); score > best) {
            best = score;
            threshold = lowerEdge(t);
        }
    }
    return threshold;
}

std::array<double, 2> Histogram::otsuOfThree() const {
    const ClassSums sums(counts);
    double best = -1;
    std::array<double, 2> thresholds = {range.low, range.low};
    for (std::size_t t = 1; t < counts.size(); ++t) {
        const double below = sums.part(0, t);
        for (std::size_t u = t + 1; u < counts.size(); ++u) {
            if (const double score = below + sums.part(t, u) + sums.part(u, counts.size()); score > best) {
                best = score;
                thresholds = {lowerEdge(t), lowerEdge(u)};
            }
        }
    }
    return thresholds;
}

Histogram computeHistogram(const Volume& volume, int bins) {
    assert(bins > 0);
    const Binning binning(volume.range(), bins);
    Histogram histogram{volume.range(), {}};
    switch (volume.type()) {
    case VoxelType::uint8: histogram.counts = countInteger<std::uint8_t>(volume, binning); break;
    case VoxelType::int16: histogram.counts = countInteger<std::int16_t>(volume, binning); break;
    case VoxelType::float32: histogram.counts = countFloats(volume, binning); break;
    }
    return histogram;
}

} // namespace limner
