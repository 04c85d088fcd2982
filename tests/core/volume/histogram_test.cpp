#include "core/volume/histogram.h"

#include "support/make_volume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace limner {
namespace {

using testing::gridOf;
using testing::makeVolume;

std::uint64_t sum(const Histogram& h) { return std::accumulate(h.counts.begin(), h.counts.end(), std::uint64_t{0}); }

TEST(Histogram, CountsEveryVoxelOfEveryType) {
    // 70 x 33 x 35 crosses brick borders on every axis; value = x, so each of the 70 bins holds one plane.
    const Grid grid = gridOf({70, 33, 35});
    const auto byX = [](glm::ivec3 v) { return v.x; };
    for (const auto& volume :
         {makeVolume<std::uint8_t>(grid, VoxelType::uint8, byX), makeVolume<std::int16_t>(grid, VoxelType::int16, byX),
          makeVolume<float>(grid, VoxelType::float32, byX)}) {
        const Histogram h = computeHistogram(*volume, 70);
        ASSERT_EQ(h.counts.size(), 70U);
        for (const std::uint64_t count : h.counts) {
            EXPECT_EQ(count, 33U * 35U);
        }
    }
}

TEST(Histogram, AppliesSlopeAndIntercept) {
    const auto volume = makeVolume<std::int16_t>(
        gridOf({4, 1, 1}), VoxelType::int16, [](glm::ivec3 v) { return v.x; }, -10, 100); // 100, 90, 80, 70
    const Histogram h = computeHistogram(*volume, 3);
    EXPECT_EQ(h.range, (ValueRange{70, 100}));
    EXPECT_EQ(h.counts, (std::vector<std::uint64_t>{1, 1, 2})); // both ends included: 100 falls into the last bin
    EXPECT_DOUBLE_EQ(h.binCentre(0), 75);
}

TEST(Histogram, ConstantVolumeFallsIntoTheFirstBin) {
    const auto volume = makeVolume<std::uint8_t>(gridOf({40, 3, 2}), VoxelType::uint8, [](glm::ivec3) { return 7; });
    const Histogram h = computeHistogram(*volume, 16);
    EXPECT_EQ(h.counts[0], 240U);
    EXPECT_EQ(sum(h), 240U);
    EXPECT_DOUBLE_EQ(h.percentile(0.5), 7);
}

TEST(Histogram, PercentilesOfARamp) {
    const auto volume =
        makeVolume<std::int16_t>(gridOf({100, 100, 1}), VoxelType::int16, [](glm::ivec3 v) { return v.y * 100 + v.x; });
    const Histogram h = computeHistogram(*volume, 1000);
    for (const double fraction : {0.0, 0.1, 0.5, 0.999, 1.0}) {
        EXPECT_NEAR(h.percentile(fraction), fraction * 9999, 10) << fraction; // one bin
    }
}

TEST(Histogram, FindsTissuePeaksInNoise) {
    std::mt19937 random(1);
    std::normal_distribution<double> noise(0, 12);
    const auto volume = makeVolume<std::int16_t>(gridOf({64, 64, 64}), VoxelType::int16, [&](glm::ivec3 v) {
        const double tissue = v.z < 32 ? -1000 : v.z < 52 ? 40 : 900;
        return std::lround(tissue + noise(random));
    });
    const std::vector<double> peaks = computeHistogram(*volume, 512).peaks(8);
    ASSERT_EQ(peaks.size(), 3U);
    EXPECT_NEAR(peaks[0], -1000, 12);
    EXPECT_NEAR(peaks[1], 40, 12);
    EXPECT_NEAR(peaks[2], 900, 12);
    EXPECT_EQ(computeHistogram(*volume, 512).peaks(2).size(), 2U);
}

TEST(Histogram, ThresholdsPartClassesOfLeastVariance) {
    // Ten values: tried one by one against the sums of squares within classes.
    const std::vector<int> values = {0, 1, 1, 2, 8, 9, 11, 12, 30, 31};
    const auto volume = makeVolume<std::uint8_t>(gridOf({10, 1, 1}), VoxelType::uint8,
                                                 [&](glm::ivec3 v) { return values[static_cast<std::size_t>(v.x)]; });
    const auto squaresWithin = [&](double low, double high) {
        double count = 0;
        double sum = 0;
        double squares = 0;
        for (const int value : values) {
            const double inside = value >= low && value < high ? 1 : 0;
            count += inside;
            sum += inside * value;
            squares += inside * value * value;
        }
        return count > 0 ? squares - sum * sum / count : 0;
    };
    double two = squaresWithin(0, 32);
    double three = two;
    for (int t = 1; t < 32; ++t) {
        two = std::min(two, squaresWithin(0, t) + squaresWithin(t, 32));
        for (int u = t + 1; u < 32; ++u) {
            three = std::min(three, squaresWithin(0, t) + squaresWithin(t, u) + squaresWithin(u, 32));
        }
    }
    const Histogram h = computeHistogram(*volume, 31);
    EXPECT_NEAR(squaresWithin(0, h.otsu()) + squaresWithin(h.otsu(), 32), two, 1e-9);
    const auto [lower, upper] = h.otsuOfThree();
    EXPECT_NEAR(squaresWithin(0, lower) + squaresWithin(lower, upper) + squaresWithin(upper, 32), three, 1e-9);
}

} // namespace
} // namespace limner
