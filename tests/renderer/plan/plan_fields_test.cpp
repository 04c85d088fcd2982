#include "core/base/error.h"
#include "renderer/plan/plan_layer.h"
#include "renderer/plan/planner.h"
#include "support/make_volume.h"
#include "support/rendering.h"
#include "support/transfer_scenes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <random>

// The fields beside the scan that plans carry, and that no block that shows is passed over.

namespace limner {
namespace {

class PlanFieldsTest : public ::testing::Test {
  protected:
    std::shared_ptr<const RenderPlan> plan(const Figure& figure) {
        PlanRequest request;
        request.size = {16, 16};
        return planner_.plan(figure, request, task_);
    }
    /// Where the figure is refused and why, as one line.
    std::string refusal(const Figure& figure) {
        try {
            plan(figure);
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::badInput);
            const std::string line = error.text().where + ": " + error.text().why;
            EXPECT_EQ(line.find('\n'), std::string::npos);
            EXPECT_FALSE(error.text().remedy.empty());
            return line;
        }
        return "drawn";
    }
    static Figure figureWith(const std::string& first, const std::string& second = "") {
        Figure figure = testing::smoothFigure({});
        Layer& layer = figure.layers[0];
        layer.transfer.distance.emplace();
        layer.transfer.distance->label = 3;
        second.empty() ? testing::makeLine(layer, first) : testing::makePlane(layer, first, second);
        return figure;
    }
    Planner planner_;
    Task task_;
};

TEST_F(PlanFieldsTest, EveryNamedLabelHasASlotAndItsRow) {
    Figure figure = figureWith("value", "label");
    figure.layers[0].transfer.grid->y = {7, -1, 3};
    figure.layers[0].labels = {3, 9};
    const auto planned = plan(figure);
    const PlanLayer& layer = planned->layers[0];
    ASSERT_EQ(layer.table.labels, (std::vector<int>{-1, 3, 7}));
    ASSERT_EQ(layer.shownSlots.size(), 256U);
    ASSERT_EQ(layer.rowOfSlot.size(), 256U);
    const Volume& labels = *figure.labels->data;
    const glm::ivec3 dims = labels.grid().dims;
    for (int i = 0; i < dims.x * dims.y * dims.z; i += 7) {
        const glm::ivec3 at(i % dims.x, i / dims.x % dims.y, i / (dims.x * dims.y));
        const auto label = static_cast<int>(labels.valueAt(at));
        const auto slot = static_cast<std::size_t>(planned->labels->storedAt(at));
        EXPECT_EQ(layer.rowOfSlot[slot], label == 3 ? 1 : label == 7 ? 2 : 0) << label;
        EXPECT_EQ(layer.shownSlots[slot], label == 3 ? 1 : 0) << label;
    }
    EXPECT_EQ(layer.rowOfSlot[255], 0); // a slot that no label has counts as all others
}

TEST_F(PlanFieldsTest, LabelsThatNoVoxelHasAreHarmless) {
    Figure figure = figureWith("value");
    for (const std::vector<int>& labels : {std::vector<int>{-7, 3}, {1000000}, {}}) {
        figure.layers[0].labels = labels;
        const auto planned = plan(figure);
        EXPECT_EQ(std::count(planned->layers[0].shownSlots.begin(), planned->layers[0].shownSlots.end(), 1),
                  static_cast<std::ptrdiff_t>(labels.size()) - (labels.size() == 2 ? 1 : 0));
    }
}

TEST_F(PlanFieldsTest, MoreThan255LabelsAreRefused) {
    Figure figure = figureWith("value", "label");
    std::vector<double>& rows = figure.layers[0].transfer.grid->y;
    rows.clear();
    for (int label = 0; label < 255; ++label) {
        rows.push_back(label);
    }
    figure.layers[0].transfer.grid->styles.assign(255, {"#102030", "#405060", "#708090"});
    EXPECT_EQ(refusal(figure), "drawn");
    figure.layers[0].labels = {3, 254}; // named twice counts once
    EXPECT_EQ(refusal(figure), "drawn");
    figure.layers[0].labels = {3, 255};
    EXPECT_EQ(refusal(figure).rfind("/layers: ", 0), 0U);
}

TEST_F(PlanFieldsTest, WhatIsMissingIsRefusedByName) {
    Figure figure = figureWith("value", "label");
    figure.labels.reset();
    EXPECT_EQ(refusal(figure).rfind("/labels: ", 0), 0U);
    figure = figureWith("value");
    figure.labels.reset();
    EXPECT_EQ(refusal(figure), "drawn");
    figure.layers[0].labels = {3};
    EXPECT_EQ(refusal(figure).rfind("/labels: ", 0), 0U);
    figure = figureWith("distance");
    figure.layers[0].transfer.distance->label = 5; // no voxel has it
    EXPECT_EQ(refusal(figure).rfind("/labels: ", 0), 0U);
    figure.labels->data.reset(); // known, but not found
    EXPECT_EQ(refusal(figure).rfind("/labels: ", 0), 0U);
    figure.layers[0].transfer.distance->fromMm = glm::dvec3(0);
    EXPECT_EQ(refusal(figure), "drawn");
    figure = figureWith("value", "second");
    figure.secondVolume.reset();
    EXPECT_EQ(refusal(figure).rfind("/second_volume: ", 0), 0U);
    figure.layers[0].visible = false; // hidden layers ask for nothing
    EXPECT_EQ(refusal(figure), "drawn");
}

TEST_F(PlanFieldsTest, FieldsAreComputedOnce) {
    Figure figure = figureWith("value", "distance");
    figure.quality.gradient = GradientEstimator::bspline;
    figure.quality.interpolation = Interpolation::tricubic;
    figure.layers.push_back(figureWith("value", "label").layers[0]);
    figure.layers.push_back(figureWith("value", "second").layers[0]);
    const auto first = plan(figure);
    ASSERT_NE(first->labels, nullptr);
    ASSERT_NE(first->secondVolume, nullptr);
    ASSERT_NE(first->layers[0].distance, nullptr);
    figure.camera.direction = {1, 0, 0};
    figure.layers[0].transfer.opacity2d[0].opacity = 0.1;
    const auto second = plan(figure);
    EXPECT_EQ(first->labels, second->labels);
    EXPECT_EQ(first->secondVolume, second->secondVolume);
    EXPECT_EQ(first->layers[0].distance, second->layers[0].distance);
    EXPECT_EQ(first->field, second->field);
    EXPECT_EQ(first->gradientField, second->gradientField);
    figure.layers[0].transfer.distance->label = 7;
    const auto third = plan(figure);
    EXPECT_NE(first->layers[0].distance, third->layers[0].distance);
    EXPECT_EQ(first->labels, third->labels);
    figure.layers[0].transfer.distance->label = 3;
    EXPECT_EQ(first->layers[0].distance, plan(figure)->layers[0].distance); // kept beside the other
}

TEST_F(PlanFieldsTest, NothingIsCarriedThatNoLayerReads) {
    const auto planned = plan(figureWith("value"));
    EXPECT_EQ(planned->labels, nullptr);
    EXPECT_EQ(planned->secondVolume, nullptr);
    EXPECT_EQ(planned->field, planned->volume);
    EXPECT_EQ(planned->gradientField, planned->volume);
    EXPECT_FALSE(readsNormal(planned->layers[0]));
}

TEST_F(PlanFieldsTest, DistanceTablesReachAsFarAsThereIsMatter) {
    Figure figure = figureWith("value", "distance");
    const auto planned = plan(figure);
    EXPECT_EQ(planned->layers[0].table.highY, planned->layers[0].distance->range().high);
    // From a point outside: up to the farthest corner, whose distance from the grid's middle is half a diagonal.
    figure.layers[0].transfer.distance->fromMm = glm::dvec3(0, 0, 500);
    const double high = plan(figure)->layers[0].table.highY;
    const double half = glm::length(figure.volume->data->grid().sizeMm()) / 2;
    EXPECT_GT(high, 500);
    EXPECT_LE(high, 500 + half);
}

/// The interval of stored numbers that a block's samples may have holds something visible: then it must not be skipped.
TEST_F(PlanFieldsTest, NoBlockThatShowsIsSkipped) {
    for (unsigned seed = 0; seed < 40; ++seed) {
        testing::SmoothScene scene;
        scene.type = seed % 3 == 0 ? VoxelType::uint8 : seed % 3 == 1 ? VoxelType::int16 : VoxelType::float32;
        scene.falling = seed % 2 == 0;
        Figure figure = testing::smoothFigure(scene);
        figure.quality.interpolation = seed % 4 == 3 ? Interpolation::tricubic : Interpolation::linear;
        const char* axes[] = {"gradient", "label", "second", "curvature"};
        const std::string second = axes[seed / 4 % 4];
        Layer& layer = figure.layers[0];
        testing::makePlane(layer, seed % 5 == 0 ? second : "value", seed % 5 == 0 ? "value" : second);
        layer.transfer.opacity2d = {testing::randomShape(seed, layer.transfer.axes[0], layer.transfer.axes[1])};
        layer.transfer.opacity2d[0].soft = 0; // edges as hard as they come
        if (seed % 7 == 0) {
            figure.layers.push_back(testing::smoothFigure(scene).layers[0]);
            figure.layers[1].transfer.opacity = {{0.9, 0}, {0.95, 0.5}};
        }
        PlanRequest request;
        request.size = {40, 40};
        const auto lean = planner_.plan(figure, request, task_);
        request.kept = {LeaveOut::emptySpace};
        const auto full = planner_.plan(figure, request, task_);
        EXPECT_EQ(full->skip->occupied, 1);
        const auto backend = makeCpuBackend();
        EXPECT_TRUE(testing::sameBits(testing::renderWhole(*backend, *lean), testing::renderWhole(*backend, *full)))
            << seed;
    }
}

TEST_F(PlanFieldsTest, VisibleRangesHoldEveryVisibleEntry) {
    std::mt19937 random(11);
    const auto volume = testing::makeVolume<std::int16_t>(
        testing::gridOf({40, 2, 2}), VoxelType::int16, [](const glm::ivec3& v) { return 100 * v.x - 2000; }, -0.5, 30);
    for (int round = 0; round < 50; ++round) {
        std::vector<PlanLayer> layers(1 + round % 3);
        for (PlanLayer& layer : layers) {
            layer.table.opacity.assign(std::size_t{2} << (random() % 10), 0);
            layer.table.low = volume->range().low;
            layer.table.high = volume->range().high;
            layer.table.opacity[random() % layer.table.opacity.size()] = 0.5F;
        }
        const VisibleRange range = visibleRange(layers, *volume);
        for (int k = 0; k <= 2000; ++k) {
            const double stored = range.low + (range.high - range.low) * k / 2000;
            const double value = volume->valueFromStored(stored);
            const bool shows = std::any_of(layers.begin(), layers.end(), [&](const PlanLayer& layer) {
                const TransferTable& table = layer.table;
                const double last = static_cast<double>(table.opacity.size() - 1);
                const double entry = std::clamp((value - table.low) / (table.high - table.low) * last, 0.0, last);
                const auto whole = static_cast<std::size_t>(entry);
                const double fraction = entry - static_cast<double>(whole);
                const float next = table.opacity[std::min(whole + 1, table.opacity.size() - 1)];
                return (fraction < 1 && table.opacity[whole] > 0) || (fraction > 1e-9 && next > 0);
            });
            // What interpolation of `visible` at that place reads.
            const double at = static_cast<double>(range.visible.size() - 1) * k / 2000;
            const auto low = static_cast<std::size_t>(at);
            const std::size_t high = std::min(low + 1, range.visible.size() - 1);
            EXPECT_TRUE(!shows || range.visible[low] != 0 || range.visible[high] != 0) << round << ' ' << k;
        }
    }
}

} // namespace
} // namespace limner
