#include "core/optics/blue_noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

namespace limner {
namespace {

constexpr int kSize = BlueNoiseTile::kSize;
constexpr int kCount = BlueNoiseTile::kCount;

/// Ranks row by row.
std::vector<int> ranksOf(const BlueNoiseTile& tile) {
    std::vector<int> ranks;
    for (int row = 0; row < kSize; ++row) {
        for (int column = 0; column < kSize; ++column) {
            ranks.push_back(tile.rank(column, row));
        }
    }
    return ranks;
}

std::vector<int> whiteRanks() {
    std::vector<int> ranks(kCount);
    std::iota(ranks.begin(), ranks.end(), 0);
    std::shuffle(ranks.begin(), ranks.end(), std::mt19937(5));
    return ranks;
}

/// Discrete Fourier transform of kSize numbers, each `stride` after the one before, in place.
void transform(std::complex<double>* line, int stride) {
    std::vector<std::complex<double>> out(kSize);
    for (int k = 0; k < kSize; ++k) {
        for (int x = 0; x < kSize; ++x) {
            out[k] += line[x * stride] * std::polar(1.0, -2 * std::numbers::pi * k * x / kSize);
        }
    }
    for (int k = 0; k < kSize; ++k) {
        line[k * stride] = out[k];
    }
}

/// Power of the first `points` pixels by whole frequencies (waves a tile), averaged over directions, over the power
/// that as many points at random have: 1 everywhere for white noise.
std::vector<double> spectrumOf(const std::vector<int>& ranks, int points) {
    std::vector<std::complex<double>> waves(kCount);
    std::transform(ranks.begin(), ranks.end(), waves.begin(), [&](int rank) { return rank < points ? 1 : 0; });
    for (int i = 0; i < kSize; ++i) {
        transform(waves.data() + i * kSize, 1);
    }
    for (int i = 0; i < kSize; ++i) {
        transform(waves.data() + i, kSize);
    }
    const double share = static_cast<double>(points) / kCount;
    std::vector<double> power(kSize);
    std::vector<double> count(kSize);
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            const auto ring = std::lround(std::hypot(std::min(x, kSize - x), std::min(y, kSize - y)));
            power[ring] += std::norm(waves[y * kSize + x]) / (kCount * share * (1 - share));
            count[ring] += 1;
        }
    }
    for (std::size_t ring = 0; ring < power.size(); ++ring) {
        power[ring] = count[ring] > 0 ? power[ring] / count[ring] : 0;
    }
    return power;
}

/// Mean of the rings 1 .. last.
double meanTo(const std::vector<double>& spectrum, int last) {
    return std::accumulate(spectrum.begin() + 1, spectrum.begin() + 1 + last, 0.0) / last;
}

/// Distance of the first `points` pixels each to its nearest other, across the seams, over the distance in the densest
/// arrangement of as many.
std::vector<double> nearestDistances(const std::vector<int>& ranks, int points) {
    std::vector<int> pixels;
    for (int i = 0; i < kCount; ++i) {
        if (ranks[i] < points) {
            pixels.push_back(i);
        }
    }
    const double densest = std::sqrt(2 / std::sqrt(3.0) * kCount / points);
    const auto across = [](int steps) { return std::min(std::abs(steps), kSize - std::abs(steps)); };
    std::vector<double> nearest;
    for (const int a : pixels) {
        double least = std::numeric_limits<double>::infinity();
        for (const int b : pixels) {
            if (a != b) {
                least = std::min(least, std::hypot(across(a % kSize - b % kSize), across(a / kSize - b / kSize)));
            }
        }
        nearest.push_back(least / densest);
    }
    return nearest;
}

double mean(const std::vector<double>& numbers) {
    return std::accumulate(numbers.begin(), numbers.end(), 0.0) / static_cast<double>(numbers.size());
}

TEST(BlueNoise, HoldsEveryRankOnce) {
    for (const std::uint32_t seed : {0U, 7U, 0xFFFFFFFFU}) {
        std::vector<int> ranks = ranksOf(BlueNoiseTile(seed));
        std::sort(ranks.begin(), ranks.end());
        for (int i = 0; i < kCount; ++i) {
            ASSERT_EQ(ranks[i], i);
        }
    }
}

TEST(BlueNoise, ThresholdsAreTheMiddlesOfEqualSteps) {
    double least = 1;
    double greatest = 0;
    double sum = 0;
    for (int i = 0; i < kCount; ++i) {
        const double threshold = blueNoise().threshold(i % kSize, i / kSize);
        least = std::min(least, threshold);
        greatest = std::max(greatest, threshold);
        sum += threshold;
    }
    EXPECT_EQ(least, 0.5 / kCount);
    EXPECT_EQ(greatest, 1 - 0.5 / kCount);
    EXPECT_EQ(sum, kCount / 2);
}

TEST(BlueNoise, RepeatsInAllDirections) {
    const BlueNoiseTile& tile = blueNoise();
    for (const int column : {0, 1, 17, 63}) {
        for (const int row : {0, 5, 62, 63}) {
            const int rank = tile.rank(column, row);
            EXPECT_EQ(tile.rank(column + kSize, row), rank);
            EXPECT_EQ(tile.rank(column, row - kSize), rank);
            EXPECT_EQ(tile.rank(column - 5 * kSize, row + 1000 * kSize), rank);
            EXPECT_EQ(tile.threshold(column - kSize, row - kSize), tile.threshold(column, row));
        }
    }
    EXPECT_EQ(tile.rank(-1, -1), tile.rank(63, 63));
    EXPECT_EQ(tile.rank(-64, -65), tile.rank(0, 63));
    EXPECT_EQ(tile.rank(std::numeric_limits<int>::min(), std::numeric_limits<int>::max()), tile.rank(0, 63));
}

TEST(BlueNoise, HasLittlePowerAtLowFrequencies) {
    const std::vector<int> ranks = ranksOf(blueNoise());
    const std::vector<int> white = whiteRanks();
    for (const double share : {0.1, 0.3, 0.5}) {
        const auto points = static_cast<int>(std::lround(share * kCount));
        const std::vector<double> spectrum = spectrumOf(ranks, points);
        // Evenly spread points repeat sqrt(share) times a pixel, on a grid of pixels at most every other.
        const double principal = kSize * std::min(std::sqrt(share), 0.5);
        const auto half = static_cast<int>(principal / 2);
        const auto quarter = static_cast<int>(principal / 4);
        EXPECT_LT(meanTo(spectrum, half), 0.1) << share;
        EXPECT_LT(meanTo(spectrum, quarter), 0.05) << share;
        EXPECT_LT(*std::max_element(spectrum.begin() + 1, spectrum.begin() + 1 + half), 0.25) << share;
        // The measure gives noise without a colour what it should.
        EXPECT_NEAR(meanTo(spectrumOf(white, points), half), 1, 0.15) << share;
    }
}

TEST(BlueNoise, KeepsItsFirstPointsApart) {
    const std::vector<int> ranks = ranksOf(blueNoise());
    const std::vector<int> white = whiteRanks();
    for (const int points : {16, 32, 64, 128, 256, 400}) {
        const std::vector<double> distances = nearestDistances(ranks, points);
        EXPECT_GT(*std::min_element(distances.begin(), distances.end()), 0.55) << points;
        EXPECT_GT(mean(distances), 0.7) << points;
        // At random points lie half the mean distance 1 / sqrt(density) away, 0.47 of the densest arrangement's.
        EXPECT_LT(mean(nearestDistances(white, points)), 0.6) << points;
    }
}

TEST(BlueNoise, SeedsGiveTilesOfTheirOwn) {
    EXPECT_EQ(ranksOf(BlueNoiseTile(3)), ranksOf(BlueNoiseTile(3)));
    EXPECT_NE(ranksOf(BlueNoiseTile(3)), ranksOf(BlueNoiseTile(4)));
}

TEST(BlueNoise, StaysTheSameForEver) {
    // A figure drawn again years later, on another machine, has to show the same points: the number is the tile's
    // checksum (FNV-1a over the ranks) and must not change with a compiler, a library or an improvement of the method.
    std::uint64_t hash = 14695981039346656037U;
    for (const int rank : ranksOf(blueNoise())) {
        hash = (hash ^ static_cast<std::uint64_t>(rank)) * 1099511628211U;
    }
    EXPECT_EQ(hash, 0x8c648ba6637b1e69U);
}

} // namespace
} // namespace limner
