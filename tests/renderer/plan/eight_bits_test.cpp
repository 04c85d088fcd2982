#include "core/style/transfer_function.h"
#include "core/volume/import.h"
#include "core/volume/quantise.h"
#include "renderer/plan/planner.h"
#include "support/make_volume.h"
#include "support/rendering.h"
#include "support/test_data.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace limner {
namespace {

/// A soft ball whose numbers crowd at the low end, as a scan's do: some thousand values.
std::shared_ptr<const Volume> crowded() {
    return testing::makeVolume<std::int16_t>(testing::gridOf({40, 40, 40}), VoxelType::int16, [](glm::ivec3 v) {
        const double near = std::max(0.0, 1 - glm::distance(glm::dvec3(v), glm::dvec3(19.3, 18.9, 20.1)) / 18);
        return -1000 + 3000 * near * near * near;
    });
}

Figure figureOf(std::shared_ptr<const Volume> volume) {
    Figure figure;
    figure.volume = VolumeReference{};
    figure.volume->data = std::move(volume);
    figure.camera.targetMm = figure.volume->data->grid().centreMm();
    figure.camera.heightMm = 42;
    figure.camera.direction = {0.3, 1, -0.2};
    Layer layer;
    layer.shading = Shading::phong;
    layer.transfer.nodes = {{-900, "", glm::dvec3(0.8, 0.3, 0.2)}, {500, "", glm::dvec3(0.2, 0.5, 0.9)}};
    layer.transfer.opacity = {{-950, 0}, {-700, 0.1}, {-200, 0.1}, {-100, 0.7}};
    figure.layers = {layer};
    figure.output = {100, 100, 300, false};
    return figure;
}

std::shared_ptr<const RenderPlan> planOf(const Figure& figure) {
    PlanRequest request;
    request.size = {48, 48};
    return testing::planOf(figure, request);
}

const PlanFeature* featureOf(const std::vector<PlanFeature>& features) {
    const auto found =
        std::find_if(features.begin(), features.end(), [](const auto& f) { return f.name == "eight-bit voxels"; });
    return found == features.end() ? nullptr : &*found;
}

TEST(EightBits, FullVoxelsAreTheScansOwn) {
    const Figure figure = figureOf(crowded());
    const auto plan = planOf(figure);
    EXPECT_EQ(plan->volume, figure.volume->data);
    EXPECT_FALSE(plan->eightBits);
    EXPECT_NE(featureOf(plan->featuresNotAsked), nullptr);
}

TEST(EightBits, HalfTheMemoryAtAnErrorThatIsShown) {
    Figure figure = figureOf(crowded());
    figure.quality.precision = VoxelPrecision::eightBits;
    const auto plan = planOf(figure);
    ASSERT_TRUE(plan->eightBits);
    EXPECT_EQ(plan->volume->type(), VoxelType::uint8);
    EXPECT_EQ(plan->field, plan->volume);
    EXPECT_EQ(plan->gradientField, plan->volume);
    EXPECT_NEAR(static_cast<double>(plan->volume->bytes()), 0.5 * static_cast<double>(figure.volume->data->bytes()),
                1024);
    Task task;
    const QuantisedVolume best = quantiseLloydMax(*figure.volume->data, task);
    EXPECT_EQ(plan->eightBits->rmsError, std::sqrt(best.meanSquareError));
    EXPECT_GT(plan->eightBits->rmsError, 0);
    EXPECT_GT(plan->eightBits->rmsErrorOfEven, 2 * plan->eightBits->rmsError) << "the numbers crowd";
    const PlanFeature* feature = featureOf(plan->featuresUsed);
    ASSERT_NE(feature, nullptr);
    EXPECT_EQ(feature->reason.find("RMS error "), 0U) << feature->reason;
    EXPECT_NE(feature->reason.find("half of what full ones take"), std::string::npos);
}

TEST(EightBits, AFigureThatNeedsFullVoxelsKeepsThemAndSaysWhy) {
    const auto whyFull = [](Figure figure) {
        figure.quality.precision = VoxelPrecision::eightBits;
        const auto plan = planOf(figure);
        EXPECT_EQ(plan->volume, figure.volume->data);
        const PlanFeature* feature = featureOf(plan->featuresNotAsked);
        return feature == nullptr ? "" : feature->reason;
    };
    Figure figure = figureOf(crowded());
    figure.quality.interpolation = Interpolation::tricubic;
    EXPECT_EQ(whyFull(figure), "splines and smoothed slices are computed from full voxels");
    figure = figureOf(crowded());
    figure.importance = Importance{};
    EXPECT_EQ(whyFull(figure), "importance weighs full voxels");
    figure = figureOf(testing::makeVolume<std::uint8_t>(testing::gridOf({9, 9, 9}), VoxelType::uint8,
                                                        [](glm::ivec3 v) { return 20 * v.x; }));
    EXPECT_EQ(whyFull(figure), "the scan has eight bits already");
}

TEST(EightBits, TablesReadTheLevels) {
    const Figure figure = figureOf(crowded());
    Task task;
    const QuantisedVolume quantised = quantiseLloydMax(*figure.volume->data, task);
    ASSERT_EQ(quantised.levels.size(), 256U);
    const TransferTable table = bakeTransfer(figure.layers[0], *quantised.volume);
    EXPECT_TRUE(table.nodeEntries.empty()) << "the index is not linear between nodes";
    const std::size_t perCode = (table.opacity.size() - 1) / 255;
    ASSERT_EQ(perCode * 255 + 1, table.opacity.size()) << "codes lie on entries";
    for (std::size_t code = 0; code < 256; ++code) {
        EXPECT_NEAR(table.opacity[code * perCode], opacityAt(figure.layers[0].transfer.opacity, quantised.levels[code]),
                    1e-6)
            << code;
    }
}

TEST(EightBits, BackendsDrawTheSamePictureOfCodes) {
    Figure figure = figureOf(crowded());
    const Picture full = testing::renderWhole(*makeCpuBackend(), *planOf(figure));
    figure.quality.precision = VoxelPrecision::eightBits;
    const auto plan = planOf(figure);
    const Picture cpu = testing::renderWhole(*makeCpuBackend(), *plan);
    const Picture reference = testing::renderWhole(*makeReferenceBackend(), *plan);
    // Between two codes the table is linear where the exact curve may have a knot: levels are some 10 apart.
    EXPECT_LT(testing::rootMeanSquare(cpu, reference), 2e-3);
    // Lighting by differences of codes against differences of values: the same surfaces, half a voxel at most apart.
    EXPECT_LT(testing::rootMeanSquare(cpu, full), 0.03);
    EXPECT_GT(testing::rootMeanSquare(cpu, full), 1e-5) << "it is another volume";
}

/// Codes are interpolated between voxels, even levels keep the line there: the picture says what that leaves of the
/// smaller error.
TEST(EightBits, PicturesOfARealScan) {
    const auto path = testing::testData("volumes/cthead_unc.nrrd");
    if (!path) {
        GTEST_SKIP();
    }
    Task task;
    Figure figure = figureOf(importVolume(*path, {}, task).volume);
    figure.camera.heightMm = 260;
    figure.layers[0].transfer.nodes = {{1000, "", glm::dvec3(0.8, 0.6, 0.5)}, {1400, "", glm::dvec3(0.9, 0.9, 0.8)}};
    figure.layers[0].transfer.opacity = {{600, 0}, {750, 0.05}, {1100, 0.05}, {1250, 0.8}};
    const auto full = figure.volume->data;
    const auto picture = [&] { return testing::renderWhole(*makeCpuBackend(), *planOf(figure)); };
    const Picture wanted = picture();
    figure.volume->data = quantiseUniformly(*full, task).volume;
    const double even = testing::rootMeanSquare(picture(), wanted);
    figure.volume->data = full;
    figure.quality.precision = VoxelPrecision::eightBits;
    const double codes = testing::rootMeanSquare(picture(), wanted);
    std::cout << "RMS of the picture against full voxels: Lloyd-Max " << codes << ", even levels " << even << '\n';
    EXPECT_LT(codes, 0.05);
}

TEST(EightBits, TwoValuesAreDrawnAsTheyAre) {
    Figure figure =
        figureOf(testing::makeVolume<std::int16_t>(testing::gridOf({40, 40, 40}), VoxelType::int16, [](glm::ivec3 v) {
            return glm::distance(glm::dvec3(v), glm::dvec3(19.5)) < 12 ? 1000 : -1000;
        }));
    const Picture full = testing::renderWhole(*makeCpuBackend(), *planOf(figure));
    figure.quality.precision = VoxelPrecision::eightBits;
    const auto plan = planOf(figure);
    EXPECT_EQ(plan->eightBits->largestError, 0);
    EXPECT_LT(testing::largestDifference(testing::renderWhole(*makeCpuBackend(), *plan), full), 1e-3);
}

} // namespace
} // namespace limner
