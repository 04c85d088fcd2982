#include "core/volume/gradient_choice.h"
#include "core/volume/import.h"

#include "support/make_volume.h"
#include "support/test_data.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <optional>
#include <random>

namespace limner {
namespace {

using testing::gridOf;
using testing::makeVolume;

constexpr int kSize = 96;
constexpr double kContrast = 1000;

/// A ball with an edge as a scanner blurs it, `sigma` of white noise added.
std::shared_ptr<const Volume> ball(double sigma) {
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0, 1);
    return makeVolume<std::int16_t>(gridOf(glm::ivec3(kSize)), VoxelType::int16, [&](glm::ivec3 v) {
        const double d = std::hypot(v.x - 47.5, v.y - 47.5, v.z - 47.5);
        return std::lround(kContrast / (1 + std::exp(d - 33)) + sigma * noise(random));
    });
}

TEST(GradientChoice, TellsBallsApart) {
    EXPECT_EQ(characterOf(*ball(0)), DataCharacter::clean);
    EXPECT_EQ(characterOf(*ball(kContrast / 200)), DataCharacter::clean); // as good as scans get
    EXPECT_EQ(characterOf(*ball(kContrast / 20)), DataCharacter::noisy);
    EXPECT_EQ(characterOf(*ball(kContrast / 5)), DataCharacter::noisy);
}

TEST(GradientChoice, SmoothFieldsOfEightBitsAreClean) {
    const auto field = makeVolume<std::uint8_t>(gridOf(glm::ivec3(kSize)), VoxelType::uint8, [](glm::ivec3 v) {
        return std::lround(127.5 * (1 + std::cos(0.2 * v.x) * std::cos(0.25 * v.y) * std::cos(0.3 * v.z)));
    });
    EXPECT_EQ(characterOf(*field), DataCharacter::clean);
}

TEST(GradientChoice, NoiseAloneIsNoisy) {
    std::mt19937 random(1);
    const auto noise = makeVolume<std::uint8_t>(gridOf(glm::ivec3(kSize)), VoxelType::uint8,
                                                [&](glm::ivec3) { return random() & 255U; });
    EXPECT_EQ(characterOf(*noise), DataCharacter::noisy);
    // White noise by its closed form: six independent differences of one variance, the median of the ratio near 1.
    EXPECT_NEAR(computeGradientStatistics(*noise).noiseToSignal, 1, 0.15);
}

TEST(GradientChoice, SegmentationsAreMasks) {
    const auto binary = [](glm::ivec3 v) { return std::hypot(v.x - 47.5, v.y - 47.5, v.z - 47.5) < 33; };
    const auto mask = makeVolume<std::uint8_t>(gridOf(glm::ivec3(kSize)), VoxelType::uint8, binary);
    EXPECT_EQ(characterOf(*mask), DataCharacter::mask);
    const auto negative = makeVolume<std::int16_t>(gridOf(glm::ivec3(kSize)), VoxelType::int16, binary, -3000, 500);
    EXPECT_EQ(characterOf(*negative), DataCharacter::mask);
    // Many regions whose numbers say nothing of their order: every jump is one step whatever its height.
    const auto regions = makeVolume<std::uint8_t>(gridOf(glm::ivec3(kSize)), VoxelType::uint8, [](glm::ivec3 v) {
        return (v.x / 12 * 37 + v.y / 9 * 101 + v.z / 14 * 59) % 200;
    });
    EXPECT_EQ(characterOf(*regions), DataCharacter::mask);
}

TEST(GradientChoice, TheRepeatedBorderIsNoStep) {
    const auto slab = makeVolume<std::int16_t>(gridOf({80, 80, 2}), VoxelType::int16, [](glm::ivec3 v) {
        return std::lround(100 * std::sin(0.2 * v.x) + 80 * std::cos(0.3 * v.y)) + 900 * v.z; // all along z is border
    });
    EXPECT_LT(computeGradientStatistics(*slab).stepShare, 0.05);
}

TEST(GradientChoice, BelievesAFileThatSaysLabels) {
    Volume::Contents contents;
    contents.grid = gridOf({2, 2, 2});
    contents.modality = Modality::labels;
    const std::vector<std::byte> stored(8);
    EXPECT_EQ(characterOf(Volume(contents, stored)), DataCharacter::mask);
}

TEST(GradientChoice, ConstantsAreClean) {
    const auto constant = makeVolume<float>(gridOf({20, 20, 1}), VoxelType::float32, [](glm::ivec3) { return 0.5; });
    EXPECT_EQ(characterOf(*constant), DataCharacter::clean);
    EXPECT_EQ(computeGradientStatistics(*constant).noiseToSignal, 0);
    EXPECT_EQ(computeGradientStatistics(*constant).stepShare, 0);
}

TEST(GradientChoice, RealScans) {
    struct Expected {
        const char* file;
        DataCharacter character;
    };
    constexpr Expected kScans[] = {
        {"engine.vti", DataCharacter::clean},
        {"tooth.nrrd", DataCharacter::clean},
        {"brain_colin27_t1.nii.gz", DataCharacter::clean}, // the mean of 27 scans
        {"cranium_ct.nrrd", DataCharacter::clean},
        {"cthead_unc.nrrd", DataCharacter::clean},
        {"embryo_noisy.nrrd", DataCharacter::noisy},
        {"walnut_noisy_u16.mhd", DataCharacter::noisy},
        {"torso_spine_ct.nii.gz", DataCharacter::noisy}, // voxels of 3 mm
        {"cranium_ct_labels.nrrd", DataCharacter::mask},
        {"brain_colin27_aal_labels.nii.gz", DataCharacter::mask},
        {"torso_spine_labels.nii.gz", DataCharacter::mask},
    };
    constexpr const char* kNames[] = {"clean", "noisy", "mask"};
    for (const Expected& scan : kScans) {
        const auto path = testing::testData(std::string("volumes/") + scan.file);
        if (!path) {
            continue;
        }
        Task task;
        const auto volume = importVolume(*path, {}, task).volume; // as values: only the numbers tell labels
        const GradientStatistics statistics = computeGradientStatistics(*volume);
        const DataCharacter character = characterOf(*volume, statistics);
        std::printf("%-32s noise to signal %.3f  step share %.3f  %s%s\n", scan.file, statistics.noiseToSignal,
                    statistics.stepShare, kNames[static_cast<int>(character)],
                    hasThickSlices(volume->grid()) ? ", thick slices" : "");
        EXPECT_EQ(character, scan.character) << scan.file;
    }
}

TEST(GradientChoice, ThickSlicesAlongAnyAxis) {
    const auto withSpacing = [](const glm::dvec3& spacingMm) {
        Grid grid;
        grid.spacingMm = spacingMm;
        return hasThickSlices(grid);
    };
    EXPECT_TRUE(withSpacing({0.5, 0.5, 2}));
    EXPECT_TRUE(withSpacing({3, 0.7, 0.9}));
    EXPECT_TRUE(withSpacing({0.7, 1.05, 0.7})); // 1.5 but for rounding
    EXPECT_FALSE(withSpacing({1, 1, 1}));
    EXPECT_FALSE(withSpacing({1, 1, 1.4}));
    EXPECT_FALSE(withSpacing({0.5, 2, 2})); // pixels of unequal sides, slices as thick as their longer one
}

} // namespace
} // namespace limner
