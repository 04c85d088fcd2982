#include "core/figure/cleanup_start.h"

#include "core/volume/cleanup.h"
#include "support/make_volume.h"

#include <gtest/gtest.h>

#include <cmath>

namespace limner {
namespace {

using testing::gridOf;
using testing::makeVolume;

/// A block of 20 x 20 x 10 voxels and a crumb of two, in air.
std::shared_ptr<const Volume> blockAndCrumb(double inside, double outside, const char* unit, double spacingMm) {
    Grid grid = gridOf({30, 24, 12});
    grid.spacingMm = glm::dvec3(spacingMm);
    const auto plain = makeVolume<float>(grid, VoxelType::float32, [&](glm::ivec3 v) {
        const bool block = v.x >= 2 && v.x < 22 && v.y >= 2 && v.y < 22 && v.z >= 1 && v.z < 11;
        const bool crumb = v.x >= 26 && v.x < 28 && v.y == 5 && v.z == 5;
        return block || crumb ? inside : outside;
    });
    Volume::Contents contents = plain->contents();
    contents.unit = unit;
    std::vector<std::byte> stored(grid.voxelCount() * sizeof(float));
    const std::size_t row = static_cast<std::size_t>(grid.dims.x) * sizeof(float);
    for (int z = 0, at = 0; z < grid.dims.z; ++z) {
        for (int y = 0; y < grid.dims.y; ++y, ++at) {
            plain->copyRow(y, z, stored.data() + static_cast<std::size_t>(at) * row);
        }
    }
    return std::make_shared<const Volume>(contents, stored);
}

TEST(CleanupStart, EveryKindDoesSomethingSensibleAtOnce) {
    for (const auto& [inside, outside, unit, spacing] :
         {std::tuple{100.0, -1000.0, "HU", 1.0}, std::tuple{0.9, 0.05, "", 0.02}, std::tuple{7000.0, 20.0, "", 3.0}}) {
        const auto volume = blockAndCrumb(inside, outside, unit, spacing);
        const Histogram histogram = computeHistogram(*volume, 256);
        for (const CleanupKind kind : {CleanupKind::keepLargest, CleanupKind::removeIslands}) {
            const CleanupStep step = startingStep(kind, *volume, histogram);
            EXPECT_GT(step.above, outside) << unit;
            EXPECT_LT(step.above, inside) << unit;
            Task task;
            const auto cleaned = applyCleanup(volume, nullptr, {step}, 1, task);
            EXPECT_NEAR(cleaned->valueAt({26, 5, 5}), outside, 1e-5) << "the crumb goes";
            EXPECT_NEAR(cleaned->valueAt({10, 10, 5}), inside, 1e-3) << "the block stays";
        }
    }
}

TEST(CleanupStart, HounsfieldUnitsPartAtTheSkin) {
    const auto volume = blockAndCrumb(100, -1000, "HU", 1);
    const Histogram histogram = computeHistogram(*volume, 256);
    EXPECT_EQ(startingStep(CleanupKind::keepLargest, *volume, histogram).above, -300);
    EXPECT_GT(startingStep(CleanupKind::keepLargest, *volume, histogram).openingMm, 0);
    EXPECT_EQ(startingStep(CleanupKind::removeIslands, *volume, histogram).openingMm, 0);
    EXPECT_EQ(startingStep(CleanupKind::removeIslands, *volume, histogram).belowMm3, 4) << "of 4002 mm3";
}

/// A figure whose layers begin to show at these values.
Figure showingFrom(const std::vector<double>& values) {
    Figure figure;
    for (const double value : values) {
        Layer layer;
        layer.transfer.opacity = {{value, 0}, {value + 1, 1}};
        figure.layers.push_back(layer);
    }
    return figure;
}

TEST(CleanupStart, AnIslandIsKeptByWhatShows) {
    const auto volume = blockAndCrumb(1000, -1000, "HU", 1);
    const auto above = [&](const Figure& figure, double value) {
        return islandStep(figure, *volume, {1, 2, 3}, value).above;
    };
    EXPECT_EQ(above(showingFrom({800}), 297.31), 290) << "what was clicked on is matter";
    EXPECT_EQ(above(showingFrom({800, -155}), 297.31), -160) << "so is what holds it together";
    EXPECT_EQ(above(showingFrom({-2000}), 297.31), 290) << "where air shows all would be one island";
    EXPECT_EQ(above({}, 1000), 990) << "below the value that all matter has";
    EXPECT_EQ(islandStep({}, *volume, {1, 2, 3}, 0).atMm, glm::dvec3(1, 2, 3));
    Task task;
    const auto crumb = applyCleanup(volume, nullptr, {islandStep({}, *volume, {26, 5, 5}, 1000)}, 1, task);
    EXPECT_EQ(crumb->valueAt({27, 5, 5}), 1000);
    EXPECT_EQ(crumb->valueAt({10, 10, 5}), -1000);
}

TEST(CleanupStart, AConstantScanGetsPlainNumbers) {
    const auto flat = blockAndCrumb(5, 5, "", 1);
    const CleanupStep step = startingStep(CleanupKind::removeIslands, *flat, computeHistogram(*flat, 16));
    EXPECT_TRUE(std::isfinite(step.above));
    EXPECT_GT(step.belowMm3, 0);
    EXPECT_EQ(islandStep({}, *flat, {0, 0, 0}, 5).above, 5);
}

} // namespace
} // namespace limner
