#include "core/optics/blue_noise.h"

#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

namespace limner {

namespace {

constexpr int kSize = BlueNoiseTile::kSize;
constexpr int kCount = BlueNoiseTile::kCount;
constexpr unsigned kMask = kSize - 1;

/// Index of a pixel of the tile, which repeats in all directions.
std::size_t wrapped(int column, int row) {
    return (static_cast<unsigned>(row) & kMask) * kSize + (static_cast<unsigned>(column) & kMask);
}

/// What a point adds around it: a Gaussian of the distance across the tile's seams, as whole numbers. Whole numbers add
/// up alike in any order and leave nothing behind when they are taken away again; sums of fractions would keep rounding
/// errors larger than what a far point adds, and the few points of a sparse pattern would lie anywhere.
class Kernel {
  public:
    Kernel() {
        // exp(-1 / (2 sigma^2)) for Ulichney's sigma of 1.5 pixels, as a number: libraries round exp differently. Its
        // powers are products alone, which every processor rounds alike.
        constexpr double kPerUnit = 0.8007374029168081;
        constexpr double kOne = 1152921504606846976.0; // 2^60: a full tile sums to 14.2 times that, within 64 bits
        std::array<double, kSize / 2 + 1> along{};     // by the distance along an axis
        for (int k = 0; k <= kSize / 2; ++k) {
            double power = 1;
            for (int i = 0; i < k * k; ++i) {
                power *= kPerUnit;
            }
            along[static_cast<std::size_t>(k)] = power;
        }
        for (int row = 0; row < kSize; ++row) {
            for (int column = 0; column < 2 * kSize; ++column) {
                const double weight = along[distance(row)] * along[distance(column)];
                weights_[static_cast<std::size_t>(row * 2 * kSize + column)] =
                    static_cast<std::uint64_t>(weight * kOne);
            }
        }
    }
    /// kSize weights for the columns 0, 1, ... of a row, of a point `rowsOff` rows away and in column `column`.
    [[nodiscard]] const std::uint64_t* row(int rowsOff, int column) const {
        return weights_.data() + (static_cast<unsigned>(rowsOff) & kMask) * 2 * kSize + (kSize - column);
    }

  private:
    static std::size_t distance(int steps) {
        const int within = steps % kSize;
        return static_cast<std::size_t>(std::min(within, kSize - within));
    }
    std::array<std::uint64_t, 2 * kCount> weights_{}; ///< two periods a row, so that a row is read without a seam
};

/// Points on the tile and how crowded every pixel is by them.
class Pattern {
  public:
    /// Ties are broken by `random`, or patterns of few points would follow the order of the pixels.
    Pattern(const Kernel& kernel, std::mt19937& random) : kernel_(&kernel), crowding_(kCount), taken_(kCount) {
        constexpr std::uint32_t kSlight = 0xF; // at most 2^-56 of a point's own weight
        for (std::uint64_t& pixel : crowding_) {
            pixel = random() & kSlight;
        }
    }

    [[nodiscard]] bool taken(std::size_t pixel) const { return taken_[pixel] != 0; }
    [[nodiscard]] std::uint64_t crowding(std::size_t pixel) const { return crowding_[pixel]; }

    void put(std::size_t pixel) {
        taken_[pixel] = 1;
        change(pixel, [](std::uint64_t& crowding, std::uint64_t weight) { crowding += weight; });
    }
    void take(std::size_t pixel) {
        taken_[pixel] = 0;
        change(pixel, [](std::uint64_t& crowding, std::uint64_t weight) { crowding -= weight; });
    }
    /// The most crowded of the points.
    [[nodiscard]] std::size_t tightestCluster() const {
        std::size_t best = kCount;
        for (std::size_t i = 0; i < kCount; ++i) {
            if (taken(i) && (best == kCount || crowding_[i] > crowding_[best])) {
                best = i;
            }
        }
        return best;
    }
    /// The least crowded pixel without a point.
    [[nodiscard]] std::size_t largestVoid() const {
        std::size_t best = kCount;
        for (std::size_t i = 0; i < kCount; ++i) {
            if (!taken(i) && (best == kCount || crowding_[i] < crowding_[best])) {
                best = i;
            }
        }
        return best;
    }

  private:
    template <typename Apply>
    void change(std::size_t pixel, Apply&& apply) {
        const int column = static_cast<int>(pixel) % kSize;
        const int row = static_cast<int>(pixel) / kSize;
        for (int y = 0; y < kSize; ++y) {
            const std::uint64_t* weights = kernel_->row(y - row, column);
            std::uint64_t* crowding = crowding_.data() + y * kSize;
            for (int x = 0; x < kSize; ++x) {
                apply(crowding[x], weights[x]);
            }
        }
    }

    const Kernel* kernel_;
    std::vector<std::uint64_t> crowding_;
    std::vector<std::uint8_t> taken_;
};

/// Some points, spread evenly: at random first, then the tightest cluster moves to the largest void until it stays.
int putFirst(Pattern& pattern, std::mt19937& random) {
    constexpr int kFirst = kCount / 10; // Ulichney's share
    for (int points = 0; points < kFirst;) {
        const std::size_t pixel = random() % kCount; // kCount divides 2^32: all alike
        if (!pattern.taken(pixel)) {
            pattern.put(pixel);
            ++points;
        }
    }
    for (;;) {
        const std::size_t from = pattern.tightestCluster();
        pattern.take(from);
        const std::size_t to = pattern.largestVoid();
        if (pattern.crowding(to) == pattern.crowding(from)) { // a move would gain nothing, and might go round for ever
            pattern.put(from);
            return kFirst;
        }
        pattern.put(to);
    }
}

} // namespace

BlueNoiseTile::BlueNoiseTile(std::uint32_t seed) {
    std::mt19937 random(seed); // the standard fixes its numbers, not those of its distributions
    const Kernel kernel;
    Pattern pattern(kernel, random);
    const int first = putFirst(pattern, random);
    Pattern thinned = pattern;
    for (int rank = first - 1; rank >= 0; --rank) {
        const std::size_t pixel = thinned.tightestCluster();
        thinned.take(pixel);
        ranks_[pixel] = static_cast<std::uint16_t>(rank);
    }
    // Past one half Ulichney takes the tightest cluster of free pixels. That is their largest void: crowding by points
    // and crowding by free pixels add up to the same everywhere on a tile that repeats.
    for (int rank = first; rank < kCount; ++rank) {
        const std::size_t pixel = pattern.largestVoid();
        pattern.put(pixel);
        ranks_[pixel] = static_cast<std::uint16_t>(rank);
    }
}

int BlueNoiseTile::rank(int column, int row) const { return ranks_[wrapped(column, row)]; }

double BlueNoiseTile::threshold(int column, int row) const { return (rank(column, row) + 0.5) / kCount; }

const BlueNoiseTile& blueNoise() {
    static const BlueNoiseTile tile(1);
    return tile;
}

} // namespace limner
