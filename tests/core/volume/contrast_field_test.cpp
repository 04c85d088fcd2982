#include "core/base/error.h"
#include "core/volume/derived_fields.h"

#include "support/make_volume.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace limner {
namespace {

using testing::gridOf;
using testing::makeVolume;

std::shared_ptr<const Volume> contrast(const Volume& volume, double sigma) {
    Task task;
    return localContrast(volume, sigma, task);
}

/// Calls `use` for the voxels from `low` up to and with `high`.
void forVoxels(glm::ivec3 low, glm::ivec3 high, const std::function<void(glm::ivec3)>& use) {
    for (int z = low.z; z <= high.z; ++z) {
        for (int y = low.y; y <= high.y; ++y) {
            for (int x = low.x; x <= high.x; ++x) {
                use({x, y, z});
            }
        }
    }
}

struct Statistics {
    double mean = 0;
    double variance = 0;
};

/// Of the voxels above a value.
Statistics statisticsAbove(const Volume& volume, double threshold) {
    std::vector<double> values;
    forVoxels(glm::ivec3(0), volume.grid().dims - 1, [&](glm::ivec3 v) {
        if (volume.valueAt(v) > threshold) {
            values.push_back(volume.valueAt(v));
        }
    });
    Statistics statistics;
    for (const double value : values) {
        statistics.mean += value / static_cast<double>(values.size());
    }
    for (const double value : values) {
        const double d = value - statistics.mean;
        statistics.variance += d * d / static_cast<double>(values.size());
    }
    return statistics;
}

/// The formula as the header has it, term by term; the border voxel repeats (`valueAt` does that).
double direct(const Volume& volume, const Statistics& whole, const glm::dvec3& sigma, glm::ivec3 voxel) {
    const glm::ivec3 reach(glm::ceil(4.0 * sigma));
    double weights = 0;
    const auto sumOver = [&](const std::function<double(double)>& of) {
        double sum = 0;
        weights = 0;
        forVoxels(-reach, reach, [&](glm::ivec3 offset) {
            double exponent = 0;
            for (int axis = 0; axis < 3; ++axis) {
                exponent += sigma[axis] > 0 ? std::pow(offset[axis] / sigma[axis], 2) : 0;
            }
            const double weight = std::exp(-0.5 * exponent);
            weights += weight;
            sum += weight * of(volume.valueAt(voxel + offset));
        });
        return sum / weights;
    };
    const double mean = sumOver([](double value) { return value; });
    const double variance = sumOver([&](double value) { return (value - mean) * (value - mean); });
    const double d = mean - whole.mean;
    const double s = whole.variance;
    return 1 - s / (d * d + s) * (s / (variance + s));
}

/// Half a step of the stored numbers, and what 32 bits round.
constexpr double kStored = 0.5 / 32767 + 5e-6;

void expectDirect(const Volume& volume, double sigma, double threshold) {
    const auto field = contrast(volume, sigma);
    const Statistics whole = statisticsAbove(volume, threshold);
    const Grid& grid = volume.grid();
    const double smallest = std::min({grid.spacingMm.x, grid.spacingMm.y, grid.spacingMm.z});
    const glm::dvec3 sigmas = sigma * smallest / grid.spacingMm;
    double least = 1;
    double greatest = 0;
    forVoxels(glm::ivec3(0), grid.dims - 1, [&](glm::ivec3 v) {
        const double expected = direct(volume, whole, sigmas, v);
        ASSERT_NEAR(field->valueAt(v), expected, kStored) << v.x << ' ' << v.y << ' ' << v.z;
        least = std::min(least, expected);
        greatest = std::max(greatest, expected);
    });
    EXPECT_GT(greatest - least, 0.2); // or there was nothing to get wrong
    EXPECT_NEAR(field->range().low, least, kStored);
    EXPECT_NEAR(field->range().high, greatest, kStored);
}

constexpr double kAll = -1e300;

TEST(LocalContrast, IsNoneInAConstantVolume) {
    for (const double value : {0.0, 0.1, 77.0}) {
        const auto volume = makeVolume<float>(
            gridOf({9, 40, 7}), VoxelType::float32, [&](glm::ivec3) { return value; }, 3, -5);
        const auto field = contrast(*volume, 2);
        EXPECT_EQ(field->range(), (ValueRange{0, 0}));
        EXPECT_EQ(field->valueAt({4, 39, 3}), 0);
        EXPECT_EQ(field->contents().slope, 1.0 / 32767);
    }
}

TEST(LocalContrast, IsKeptAsTheOtherFieldsAre) {
    Grid grid = gridOf({40, 34, 5});
    grid.spacingMm = {0.5, 0.5, 2};
    grid.originMm = {3, -7, 11};
    const auto labels = makeVolume<std::uint8_t>(grid, VoxelType::uint8, [](glm::ivec3 v) { return v.x / 9; });
    const auto field = contrast(*labels, 1.5);
    EXPECT_EQ(field->grid(), grid);
    EXPECT_EQ(field->type(), VoxelType::int16);
    EXPECT_EQ(field->contents().slope, 1.0 / 32767);
    EXPECT_EQ(field->contents().intercept, 0);
    EXPECT_EQ(field->contents().modality, Modality::unknown);
    EXPECT_EQ(field->contents().unit, "");
}

TEST(LocalContrast, IsTheFormulaOnAStepWithNoise) {
    std::mt19937 random(3);
    const auto volume = makeVolume<std::int16_t>(
        gridOf({19, 14, 11}), VoxelType::int16,
        [&](glm::ivec3 v) { return (v.x < 5 ? -700 : 900) + static_cast<int>(random() % 301); }, 0.25, 100);
    for (const double sigma : {0.0, 0.6, 1.0, 1.7}) {
        expectDirect(*volume, sigma, kAll);
    }
}

TEST(LocalContrast, IsTheFormulaOnEveryKindOfVoxels) {
    std::mt19937 random(4);
    const auto noise = [&](glm::ivec3) { return random() % 250; };
    expectDirect(*makeVolume<std::uint8_t>(gridOf({12, 9, 13}), VoxelType::uint8, noise, -2, 7), 1.2, kAll);
    expectDirect(*makeVolume<float>(gridOf({12, 9, 13}), VoxelType::float32, noise, 1e-3, 0), 1.2, kAll);
    expectDirect(*makeVolume<float>(gridOf({37, 35, 1}), VoxelType::float32, noise), 1.2, kAll);
    expectDirect(*makeVolume<float>(gridOf({1, 1, 70}), VoxelType::float32, noise), 1.2, kAll);
}

TEST(LocalContrast, MeasuresInMillimetres) {
    std::mt19937 random(5);
    Grid grid = gridOf({17, 13, 15});
    grid.spacingMm = {0.5, 1.5, 0.8};
    const auto volume =
        makeVolume<std::uint8_t>(grid, VoxelType::uint8, [&](glm::ivec3 v) { return 7 * v.z + random() % 130; });
    expectDirect(*volume, 2, kAll);
}

TEST(LocalContrast, KeepsSmallVariancesOnLargeNumbers) {
    // The squares of these numbers have no digit left for their variance in 32 bits.
    std::mt19937 random(6);
    const auto volume = makeVolume<float>(gridOf({14, 12, 10}), VoxelType::float32,
                                          [&](glm::ivec3 v) { return 100000 + v.x + random() % 8; });
    expectDirect(*volume, 1.3, kAll);
}

/// A ball of noise about 600 in air of about 0.
std::shared_ptr<const Volume> ballInAir(double radius) {
    std::mt19937 random(7);
    return makeVolume<std::int16_t>(gridOf({18, 20, 16}), VoxelType::int16, [&](glm::ivec3 v) {
        const glm::dvec3 d = glm::dvec3(v) - glm::dvec3(9, 10, 8);
        const int inside = d.x * d.x + d.y * d.y + d.z * d.z < radius * radius ? 600 : 0;
        return inside + static_cast<int>(random() % 100);
    });
}

TEST(LocalContrast, LeavesOutTheAirAroundAThing) {
    // Any threshold between the two says the same.
    expectDirect(*ballInAir(6), 1, 300);
    const auto field = contrast(*ballInAir(6), 1);
    EXPECT_GT(field->valueAt({2, 2, 2}), 0.9); // far from what matter is like
    EXPECT_LT(field->valueAt({9, 10, 8}), 0.7);
}

TEST(LocalContrast, CountsAllOfAThingThatIsCut) {
    expectDirect(*ballInAir(14), 1, kAll); // reaches past the volume's edges, and darker corners are no air
}

TEST(LocalContrast, CountsAllWhereMatterHasOneValue) {
    const auto mask = makeVolume<std::uint8_t>(gridOf({12, 12, 12}), VoxelType::uint8, [](glm::ivec3 v) {
        return glm::all(glm::lessThan(glm::abs(v - 6), glm::ivec3(3))) ? 200 : 0;
    });
    expectDirect(*mask, 1, kAll);
}

TEST(LocalContrast, ShowsAPatchThatVariesMore) {
    // The same mean everywhere: no threshold and no gradient finds it.
    std::mt19937 random(8);
    std::normal_distribution<double> noise;
    const glm::ivec3 middle(24);
    const auto inPatch = [&](glm::ivec3 v, int radius) {
        return glm::all(glm::lessThanEqual(glm::abs(v - middle), glm::ivec3(radius)));
    };
    const auto volume = makeVolume<std::int16_t>(gridOf({48, 48, 48}), VoxelType::int16, [&](glm::ivec3 v) {
        return std::lround(1000 + (inPatch(v, 8) ? 60 : 20) * noise(random));
    });
    const auto field = contrast(*volume, 2);
    double patch = 0;
    double around = 0;
    double patchCount = 0;
    double aroundCount = 0;
    forVoxels(glm::ivec3(0), volume->grid().dims - 1, [&](glm::ivec3 v) {
        if (inPatch(v, 2)) {
            patch += field->valueAt(v);
            patchCount += 1;
        } else if (!inPatch(v, 16)) {
            around += field->valueAt(v);
            aroundCount += 1;
        }
    });
    // S^2 is 400 with a share of (17/48)^3 at 3600: 542. Smooth noise gives var / (var + S^2) for either.
    EXPECT_NEAR(patch / patchCount, 3600.0 / (3600 + 542), 0.05);
    EXPECT_NEAR(around / aroundCount, 400.0 / (400 + 542), 0.05);
}

TEST(LocalContrast, IsTheSameEveryTime) {
    std::mt19937 random(9);
    const auto volume =
        makeVolume<float>(gridOf({70, 40, 66}), VoxelType::float32, [&](glm::ivec3) { return random() * 1e-9; });
    const auto once = contrast(*volume, 1.5);
    const auto twice = contrast(*volume, 1.5);
    forVoxels(glm::ivec3(0), volume->grid().dims - 1,
              [&](glm::ivec3 v) { ASSERT_EQ(once->storedAt(v), twice->storedAt(v)); });
}

TEST(LocalContrast, StopsWhenCancelled) {
    const auto volume = makeVolume<std::uint8_t>(gridOf({5, 6, 7}), VoxelType::uint8, [](glm::ivec3 v) { return v.x; });
    Task task;
    task.cancel();
    EXPECT_THROW(localContrast(*volume, 1, task), Error);
}

/// Cancels its task once it hears of half the work.
class CancelHalfway : public TaskListener {
  public:
    void progressed(const std::string&, double fraction) override {
        heard = std::max(heard, fraction);
        if (fraction >= 0.5) {
            task->cancel();
        }
    }
    void warned(const std::string&) override {}
    Task* task = nullptr;
    double heard = 0;
};

TEST(LocalContrast, StopsOnTheWay) {
    const auto volume = makeVolume<std::uint8_t>(gridOf({5, 6, 7}), VoxelType::uint8, [](glm::ivec3 v) { return v.x; });
    CancelHalfway listener;
    Task task(listener);
    listener.task = &task;
    EXPECT_THROW(localContrast(*volume, 1, task), Error);
    EXPECT_LT(listener.heard, 0.9);
}

} // namespace
} // namespace limner
