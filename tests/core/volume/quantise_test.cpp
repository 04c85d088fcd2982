#include "core/volume/quantise.h"

#include "core/base/error.h"
#include "core/volume/import.h"
#include "support/make_volume.h"
#include "support/test_data.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <numeric>
#include <random>

namespace limner {
namespace {

using testing::gridOf;
using testing::makeVolume;
using VolumePointer = std::shared_ptr<const Volume>;

QuantisedVolume lloydMax(const Volume& volume) {
    Task task;
    return quantiseLloydMax(volume, task);
}

QuantisedVolume uniform(const Volume& volume) {
    Task task;
    return quantiseUniformly(volume, task);
}

/// Voxels of a distribution, 40^3 of them.
template <typename T, typename Draw>
VolumePointer drawn(VoxelType type, const Draw& draw, double slope = 1, double intercept = 0) {
    return makeVolume<T>(
        gridOf({40, 40, 40}), type, [&](glm::ivec3) { return draw(); }, slope, intercept);
}

/// The error as a voxel by voxel comparison finds it, and what the result says.
void expectErrorsAreTrue(const Volume& volume, const QuantisedVolume& quantised) {
    double squares = 0;
    double largest = 0;
    const glm::ivec3 dims = volume.grid().dims;
    for (int z = 0; z < dims.z; ++z) {
        for (int y = 0; y < dims.y; ++y) {
            for (int x = 0; x < dims.x; ++x) {
                const double error = quantised.volume->valueAt({x, y, z}) - volume.valueAt({x, y, z});
                squares += error * error;
                largest = std::max(largest, std::abs(error));
            }
        }
    }
    const double span = volume.range().high - volume.range().low;
    EXPECT_NEAR(quantised.meanSquareError, squares / static_cast<double>(volume.grid().voxelCount()),
                1e-12 * span * span);
    EXPECT_NEAR(quantised.largestError, largest, 1e-9 * span);
}

/// Weighted sum of squared distances to the nearest level.
double errorOf(const std::vector<double>& levels, const std::vector<double>& values,
               const std::vector<double>& weights) {
    double sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        double least = std::numeric_limits<double>::infinity();
        for (const double level : levels) {
            least = std::min(least, (values[i] - level) * (values[i] - level));
        }
        sum += weights[i] * least;
    }
    return sum;
}

TEST(Quantise, NeverWorseThanUniformLevels) {
    std::mt19937 random(7);
    std::normal_distribution<double> narrow(200, 30);
    std::normal_distribution<double> wide(2500, 600);
    std::exponential_distribution<double> tail(0.002);
    std::bernoulli_distribution coin(0.8);
    const VolumePointer scans[] = {
        drawn<std::int16_t>(VoxelType::int16, [&] { return coin(random) ? narrow(random) : wide(random); }),
        drawn<std::int16_t>(
            VoxelType::int16, [&] { return coin(random) ? -1000 : wide(random); }, -0.5, 30),
        drawn<float>(VoxelType::float32, [&] { return tail(random); }),
        drawn<float>(VoxelType::float32, [&] { return std::uniform_real_distribution<double>(0, 1)(random); }),
    };
    for (const VolumePointer& scan : scans) {
        const QuantisedVolume best = lloydMax(*scan);
        const QuantisedVolume even = uniform(*scan);
        EXPECT_LE(best.meanSquareError, even.meanSquareError);
        EXPECT_EQ(best.levels.size(), 256U);
        EXPECT_TRUE(std::is_sorted(best.levels.begin(), best.levels.end()));
        EXPECT_EQ(best.volume->type(), VoxelType::uint8);
        expectErrorsAreTrue(*scan, best);
        expectErrorsAreTrue(*scan, even);
    }
}

TEST(Quantise, ExactWhereTheValuesAreFew) {
    std::mt19937 random(3);
    for (const int count : {1, 2, 17, 256}) {
        std::uniform_int_distribution<int> which(0, count - 1);
        const auto shorts = drawn<std::int16_t>(
            VoxelType::int16, [&] { return which(random) * which(random) - 5000; }, 0.1, -3);
        const auto floats =
            drawn<float>(VoxelType::float32, [&] { return 1 + 1e-6F * std::sqrt(1.0F + which(random)); });
        for (const auto& volume : {floats, count < 20 ? shorts : floats}) {
            const QuantisedVolume result = lloydMax(*volume);
            EXPECT_EQ(result.meanSquareError, 0) << count;
            EXPECT_EQ(result.largestError, 0) << count;
            expectErrorsAreTrue(*volume, result);
        }
    }
}

TEST(Quantise, EvenLevelsAreBestForAnEvenDistribution) {
    // 65,536 different numbers, each once: the cells of the optimum are equally wide, the error is width^2 / 12.
    std::vector<double> values(65536);
    std::iota(values.begin(), values.end(), 0.0);
    const std::vector<double> levels = lloydMaxLevels(values, std::vector(values.size(), 1.0), 256);
    ASSERT_EQ(levels.size(), 256U);
    for (std::size_t k = 0; k < levels.size(); ++k) {
        EXPECT_NEAR(levels[k], 256.0 * static_cast<double>(k) + 127.5, 1) << k;
    }
}

TEST(Quantise, TheKnownOptimumOfANormalDistribution) {
    // J. Max (1960), Table I: 8 levels for unit variance at 0.2451, 0.7560, 1.344, 2.152, mean square error 0.03454.
    std::vector<double> values;
    std::vector<double> weights;
    constexpr double kStep = 1e-4; // Lloyd rests where no value changes its cell: some steps from the optimum
    for (double v = -8; v <= 8; v += kStep) {
        values.push_back(v);
        weights.push_back(std::exp(-v * v / 2));
    }
    const std::vector<double> levels = lloydMaxLevels(values, weights, 8);
    const double expected[] = {-2.152, -1.344, -0.7560, -0.2451, 0.2451, 0.7560, 1.344, 2.152};
    ASSERT_EQ(levels.size(), 8U);
    for (std::size_t k = 0; k < 8; ++k) {
        EXPECT_NEAR(levels[k], expected[k], 1e-3) << k;
    }
    EXPECT_NEAR(errorOf(levels, values, weights) / std::accumulate(weights.begin(), weights.end(), 0.0), 0.03454, 2e-5);
}

TEST(Quantise, TwoHeapsShareTheLevels) {
    // Two even heaps of 30,000 values, far apart: half the levels each, in cells of 30,000 / 128 values, whose error is
    // that of an even distribution.
    constexpr std::size_t kHeap = 30000;
    std::vector<double> values(2 * kHeap);
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = static_cast<double>(i < kHeap ? i : 1000000 + i);
    }
    const std::vector<double> levels = lloydMaxLevels(values, std::vector(values.size(), 1.0), 256);
    ASSERT_EQ(levels.size(), 256U);
    const double cell = kHeap / 128.0;
    const double least = static_cast<double>(values.size()) * cell * cell / 12;
    EXPECT_NEAR(errorOf(levels, values, std::vector(values.size(), 1.0)), least, 0.01 * least);
    EXPECT_NEAR(static_cast<double>(std::count_if(levels.begin(), levels.end(), [](double l) { return l < kHeap; })),
                128, 2);
    EXPECT_TRUE(std::none_of(levels.begin(), levels.end(), [](double l) { return l >= kHeap && l < 1000000; }));
    EXPECT_EQ(lloydMaxLevels({-4, 9}, {5, 1}, 256), (std::vector<double>{-4, 9}));
    EXPECT_EQ(lloydMaxLevels({-4, 8, 10}, {5, 1, 3}, 2), (std::vector<double>{-4, 9.5}));
}

TEST(Quantise, ValuesBetweenVoxelsFollowTheLevels) {
    const auto volume =
        makeVolume<std::int16_t>(gridOf({4, 1, 1}), VoxelType::int16, [](glm::ivec3 v) { return v.x * v.x * 100; });
    const QuantisedVolume result = lloydMax(*volume);
    const Volume& codes = *result.volume;
    EXPECT_EQ(codes.storedAt({2, 0, 0}), 2);
    EXPECT_EQ(codes.valueAt({2, 0, 0}), 400);
    EXPECT_EQ(codes.valueFromStored(2.5), 650);
    EXPECT_EQ(codes.storedFromValue(650), 2.5);
    EXPECT_EQ(codes.valueFromStored(-1), 0);
    EXPECT_EQ(codes.valueFromStored(7), 900);
    EXPECT_EQ(codes.storedFromValue(-5), 0);
    EXPECT_EQ(codes.storedFromValue(1e6), 3);
    EXPECT_EQ(codes.range(), (ValueRange{0, 900}));
    EXPECT_EQ(trilinear(codes, {2.5, 0, 0}), 650);
}

TEST(Quantise, OfRealScans) {
    for (const char* name :
         {"volumes/cthead_unc.nrrd", "volumes/walnut_noisy_u16.mhd", "volumes/brain_tumour_aniso.nrrd"}) {
        const auto path = testing::testData(name);
        if (!path) {
            continue; // counted and printed
        }
        Task task;
        const VolumePointer scan = importVolume(*path, {}, task).volume;
        const QuantisedVolume best = quantiseLloydMax(*scan, task);
        const QuantisedVolume even = quantiseUniformly(*scan, task);
        const double rms = std::sqrt(best.meanSquareError);
        const double evenRms = std::sqrt(even.meanSquareError);
        std::cout << name << ": RMS error " << rms << ", even levels " << evenRms << ", ratio " << rms / evenRms
                  << "; largest " << best.largestError << ", even levels " << even.largestError << "; range "
                  << scan->range().low << " to " << scan->range().high << '\n';
        EXPECT_LT(rms, evenRms);
    }
}

TEST(Quantise, Cancels) {
    Task task;
    task.cancel();
    std::mt19937 random(1);
    const auto volume = drawn<std::int16_t>(VoxelType::int16, [&] { return random() % 5000; });
    EXPECT_THROW(quantiseLloydMax(*volume, task), Error);
}

} // namespace
} // namespace limner
