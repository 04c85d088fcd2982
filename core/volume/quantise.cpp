#include "core/volume/quantise.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <type_traits>
#include <utility>

namespace limner {

namespace {

constexpr std::size_t kLevels = 256;
constexpr std::size_t kBins = 65536; // of float data; every number of 16-bit data
constexpr int kMostRounds = 2000;    // each is 256 searches; real scans rest after some hundred

/// What occurs in a volume, and how often.
struct Occurrences {
    std::vector<double> values; ///< rising
    std::vector<double> weights;
};

/// Reads a row's stored numbers of any type.
class Rows {
  public:
    explicit Rows(const Volume& volume)
        : volume_(&volume), bytes_(static_cast<std::size_t>(volume.grid().dims.x) * bytesPerVoxel(volume.type())) {}

    template <typename T>
    [[nodiscard]] const T* read(int y, int z) {
        volume_->copyRow(y, z, bytes_.data());
        return reinterpret_cast<const T*>(bytes_.data());
    }

  private:
    const Volume* volume_;
    std::vector<std::byte> bytes_;
};

/// Calls `use(stored number)` for every voxel of a slice, in order.
template <typename Use>
void forSlice(const Volume& volume, int z, const Use& use) {
    Rows rows(volume);
    const glm::ivec3 dims = volume.grid().dims;
    const auto walk = [&](auto* none) {
        using T = std::remove_cvref_t<decltype(*none)>;
        for (int y = 0; y < dims.y; ++y) {
            const T* row = rows.read<T>(y, z);
            for (int x = 0; x < dims.x; ++x) {
                use(row[x]);
            }
        }
    };
    switch (volume.type()) {
    case VoxelType::uint8: walk(static_cast<const std::uint8_t*>(nullptr)); break;
    case VoxelType::int16: walk(static_cast<const std::int16_t*>(nullptr)); break;
    case VoxelType::float32: walk(static_cast<const float*>(nullptr)); break;
    }
}

/// Bins of the stored numbers' range; whole numbers have one each.
struct Binning {
    double low = 0;
    double perStored = 1;
    std::size_t last = 0;

    explicit Binning(const Volume& volume) {
        const ValueRange range = volume.range();
        double ends[2] = {volume.storedFromValue(range.low), volume.storedFromValue(range.high)};
        if (ends[0] > ends[1]) {
            std::swap(ends[0], ends[1]);
        }
        low = volume.type() == VoxelType::float32 ? ends[0] : std::round(ends[0]);
        const double span = ends[1] - low;
        last = volume.type() == VoxelType::float32 ? kBins - 1 : static_cast<std::size_t>(std::lround(span));
        perStored = span > 0 ? static_cast<double>(last) / span : 0;
    }
    [[nodiscard]] std::size_t of(double stored) const {
        return static_cast<std::size_t>(std::clamp((stored - low) * perStored + 0.5, 0.0, static_cast<double>(last)));
    }
};

struct Bin {
    double count = 0;
    double sum = 0; ///< of the stored numbers
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
};

/// In one thread and slice by slice: sums are the same on every machine.
Occurrences occurrencesOf(const Volume& volume, Task& task) {
    const Binning binning(volume);
    std::vector<Bin> bins(binning.last + 1);
    for (int z = 0; z < volume.grid().dims.z; ++z) {
        task.throwIfCancelled();
        forSlice(volume, z, [&](auto number) {
            const auto stored = static_cast<double>(number);
            Bin& bin = bins[binning.of(stored)];
            bin.count += 1;
            bin.sum += stored;
            bin.low = std::min(bin.low, stored);
            bin.high = std::max(bin.high, stored);
        });
    }
    Occurrences found;
    for (const Bin& bin : bins) {
        if (bin.count > 0) {
            // The mean of equal numbers is that number, but a sum of many of them is rounded.
            const double mean = bin.low == bin.high ? bin.low : bin.sum / bin.count;
            found.values.push_back(volume.valueFromStored(mean));
            found.weights.push_back(bin.count);
        }
    }
    if (found.values.size() > 1 && found.values.front() > found.values.back()) { // a falling rescale slope
        std::reverse(found.values.begin(), found.values.end());
        std::reverse(found.weights.begin(), found.weights.end());
    }
    return found;
}

/// The values that occur, rising, where there are no more than the levels; else none.
std::vector<double> fewValues(const Volume& volume) {
    std::vector<double> values;
    for (int z = 0; z < volume.grid().dims.z && values.size() <= kLevels; ++z) {
        double last = std::numeric_limits<double>::quiet_NaN();
        forSlice(volume, z, [&](auto number) {
            const auto stored = static_cast<double>(number);
            if (stored == last || values.size() > kLevels) {
                return; // neighbours are often equal
            }
            last = stored;
            const double value = volume.valueFromStored(stored);
            const auto at = std::lower_bound(values.begin(), values.end(), value);
            if (at == values.end() || *at != value) {
                values.insert(at, value);
            }
        });
    }
    return values.size() <= kLevels ? values : std::vector<double>{};
}

std::vector<double> evenLevels(double low, double high, std::size_t count) {
    std::vector<double> levels(count);
    for (std::size_t k = 0; k < count; ++k) {
        levels[k] = low + (high - low) * (static_cast<double>(k) + 0.5) / static_cast<double>(count);
    }
    return levels;
}

/// Sums over the first so many values: what a cell weighs and where its mean lies is one difference.
class Cells {
  public:
    Cells(const std::vector<double>& values, const std::vector<double>& weights)
        : values_(&values), origin_(values[0]) {
        weight_.push_back(0);
        moment_.push_back(0);
        square_.push_back(0);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const double v = values[i] - origin_;
            weight_.push_back(weight_.back() + weights[i]);
            moment_.push_back(moment_.back() + weights[i] * v);
            square_.push_back(square_.back() + weights[i] * v * v);
        }
    }

    /// First value of each level's cell, and the end: what is nearer to the level than to any other.
    [[nodiscard]] std::vector<std::size_t> bounds(const std::vector<double>& levels) const {
        std::vector<std::size_t> out{0};
        for (std::size_t k = 1; k < levels.size(); ++k) {
            const double middle = levels[k - 1] + (levels[k] - levels[k - 1]) / 2;
            out.push_back(static_cast<std::size_t>(std::lower_bound(values_->begin(), values_->end(), middle) -
                                                   values_->begin()));
        }
        out.push_back(values_->size());
        return out;
    }
    [[nodiscard]] double weight(std::size_t from, std::size_t to) const { return weight_[to] - weight_[from]; }
    [[nodiscard]] double mean(std::size_t from, std::size_t to) const {
        if (to == from + 1) {
            return (*values_)[from];
        }
        return origin_ + (moment_[to] - moment_[from]) / weight(from, to);
    }
    /// Sum of squared distances of a cell's values from a level.
    [[nodiscard]] double error(std::size_t from, std::size_t to, double level) const {
        const double l = level - origin_;
        const double sum =
            square_[to] - square_[from] - 2 * l * (moment_[to] - moment_[from]) + l * l * weight(from, to);
        return std::max(0.0, sum);
    }
    [[nodiscard]] double error(const std::vector<double>& levels) const {
        const auto at = bounds(levels);
        double sum = 0;
        for (std::size_t k = 0; k < levels.size(); ++k) {
            sum += error(at[k], at[k + 1], levels[k]);
        }
        return sum;
    }
    /// Where a cell falls into two parts of least error, near its mean: the first value of the second part.
    [[nodiscard]] std::size_t split(std::size_t from, std::size_t to) const {
        const auto begin = values_->begin();
        const auto at = std::lower_bound(begin + static_cast<std::ptrdiff_t>(from),
                                         begin + static_cast<std::ptrdiff_t>(to), mean(from, to));
        return std::clamp(static_cast<std::size_t>(at - begin), from + 1, to - 1);
    }

  private:
    const std::vector<double>* values_;
    double origin_;
    std::vector<double> weight_;
    std::vector<double> moment_;
    std::vector<double> square_;
};

/// Levels without a value of their own go to where the error is largest.
void refill(const Cells& cells, std::vector<double>& levels, std::size_t count) {
    while (levels.size() < count) {
        const auto at = cells.bounds(levels);
        std::size_t worst = levels.size();
        double worstError = 0;
        for (std::size_t k = 0; k < levels.size(); ++k) {
            const double error = at[k + 1] > at[k] + 1 ? cells.error(at[k], at[k + 1], levels[k]) : 0;
            if (error > worstError) {
                worstError = error;
                worst = k;
            }
        }
        if (worst == levels.size()) {
            return; // every value has its level
        }
        const std::size_t middle = cells.split(at[worst], at[worst + 1]);
        levels[worst] = cells.mean(at[worst], middle);
        levels.insert(levels.begin() + static_cast<std::ptrdiff_t>(worst) + 1, cells.mean(middle, at[worst + 1]));
    }
}

/// Lloyd's iteration: each level to the mean of what is nearest to it, until nothing moves.
std::vector<double> iterate(const Cells& cells, std::vector<double> levels, std::size_t count) {
    std::vector<std::size_t> before;
    for (int round = 0; round < kMostRounds; ++round) {
        const auto at = cells.bounds(levels);
        if (at == before && levels.size() == count) {
            break;
        }
        std::vector<double> next;
        for (std::size_t k = 0; k < levels.size(); ++k) {
            if (at[k + 1] > at[k]) {
                next.push_back(cells.mean(at[k], at[k + 1]));
            }
        }
        refill(cells, next, count);
        before = at;
        levels = std::move(next);
    }
    return levels;
}

/// As dense as the cube root of the histogram: best for many levels (Panter and Dite 1951).
std::vector<double> companded(const std::vector<double>& values, const std::vector<double>& weights,
                              std::size_t count) {
    std::vector<double> sums{0};
    for (std::size_t i = 0; i < values.size(); ++i) {
        // A value stands for its surroundings: half way to either neighbour.
        const double from = i > 0 ? values[i - 1] : values[i];
        const double to = i + 1 < values.size() ? values[i + 1] : values[i];
        const double width = std::max((to - from) / 2, std::numeric_limits<double>::min());
        sums.push_back(sums.back() + width * std::cbrt(weights[i] / width));
    }
    std::vector<double> levels;
    for (std::size_t k = 0; k < count; ++k) {
        const double want = sums.back() * (static_cast<double>(k) + 0.5) / static_cast<double>(count);
        const auto at = static_cast<std::size_t>(std::upper_bound(sums.begin(), sums.end(), want) - sums.begin()) - 1;
        const double level = values[std::min(at, values.size() - 1)];
        if (levels.empty() || level > levels.back()) {
            levels.push_back(level);
        }
    }
    return levels;
}

/// The code of every value, by the middles between levels.
class Coder {
  public:
    explicit Coder(const std::vector<double>& levels) {
        for (std::size_t k = 1; k < levels.size(); ++k) {
            middles_.push_back(levels[k - 1] + (levels[k] - levels[k - 1]) / 2);
        }
    }
    [[nodiscard]] std::uint8_t code(double value) const {
        return static_cast<std::uint8_t>(std::upper_bound(middles_.begin(), middles_.end(), value) - middles_.begin());
    }

  private:
    std::vector<double> middles_;
};

/// What one slice loses.
struct Loss {
    double squares = 0;
    double largest = 0;
};

QuantisedVolume encode(const Volume& volume, std::vector<double> levels, Task& task) {
    const Coder coder(levels);
    const glm::ivec3 dims = volume.grid().dims;
    const std::size_t slice = static_cast<std::size_t>(dims.x) * static_cast<std::size_t>(dims.y);
    std::vector<std::byte> codes(slice * static_cast<std::size_t>(dims.z));
    std::vector<Loss> losses(static_cast<std::size_t>(dims.z));
    tbb::parallel_for(0, dims.z, [&](int z) {
        if (task.cancelled()) {
            return;
        }
        std::byte* out = codes.data() + static_cast<std::size_t>(z) * slice;
        Loss& loss = losses[static_cast<std::size_t>(z)];
        forSlice(volume, z, [&](auto stored) {
            const double value = volume.valueFromStored(static_cast<double>(stored));
            const std::uint8_t code = coder.code(value);
            const double error = std::abs(value - levels[code]);
            loss.squares += error * error;
            loss.largest = std::max(loss.largest, error);
            *out++ = static_cast<std::byte>(code);
        });
    });
    task.throwIfCancelled();
    QuantisedVolume result;
    for (const Loss& loss : losses) {
        result.meanSquareError += loss.squares;
        result.largestError = std::max(result.largestError, loss.largest);
    }
    result.meanSquareError /= static_cast<double>(volume.grid().voxelCount());
    Volume::Contents contents = volume.contents();
    contents.levels.clear();
    contents.type = VoxelType::uint8;
    contents.range = {levels.front(), levels.back()};
    contents.slope = levels.size() > 1 ? (levels.back() - levels.front()) / static_cast<double>(levels.size() - 1) : 1;
    contents.intercept = levels.front();
    constexpr double kEven = 1e-9; // of a step: levels that lie on a line need no list
    for (std::size_t k = 0; k < levels.size(); ++k) {
        if (std::abs(levels[k] - (contents.intercept + contents.slope * static_cast<double>(k))) >
            kEven * contents.slope) {
            contents.levels = levels;
        }
    }
    result.volume = std::make_shared<const Volume>(std::move(contents), codes);
    result.levels = std::move(levels);
    return result;
}

} // namespace

std::vector<double> lloydMaxLevels(const std::vector<double>& values, const std::vector<double>& weights,
                                   std::size_t count) {
    if (values.size() <= count) {
        return values;
    }
    const Cells cells(values, weights);
    std::vector<double> best = iterate(cells, companded(values, weights, count), count);
    std::vector<double> even = iterate(cells, evenLevels(values.front(), values.back(), count), count);
    return cells.error(even) < cells.error(best) ? even : best;
}

QuantisedVolume quantiseLloydMax(const Volume& volume, Task& task) {
    task.beginPhase("Choosing 256 levels");
    if (auto few = fewValues(volume); !few.empty()) {
        return encode(volume, std::move(few), task);
    }
    const Occurrences found = occurrencesOf(volume, task);
    return encode(volume, lloydMaxLevels(found.values, found.weights, kLevels), task);
}

QuantisedVolume quantiseUniformly(const Volume& volume, Task& task) {
    const ValueRange range = volume.range();
    return encode(volume, range.high > range.low ? evenLevels(range.low, range.high, kLevels) : std::vector{range.low},
                  task);
}

} // namespace limner
