#include "core/figure/plane_view.h"

#include "support/make_volume.h"

#include <gtest/gtest.h>

#include <numeric>

namespace limner {
namespace {

/// A ramp of 0..150 along x, 3 per voxel of 1 mm, with a plane as its layer's function.
Figure rampFigure() {
    Figure figure;
    figure.volume = VolumeReference{};
    figure.volume->data = testing::makeVolume<std::uint8_t>(testing::gridOf({51, 6, 6}), VoxelType::uint8,
                                                            [](glm::ivec3 v) { return 3 * v.x; });
    figure.camera.targetMm = figure.volume->data->grid().centreMm();
    Layer layer;
    layer.transfer.kind = TransferKind::twoDimensional;
    layer.transfer.axes = {"value", "gradient"};
    layer.transfer.grid = TransferGrid{{30, 120}, {0.2, 0.8}, {{"#000000", "#ff0000"}, {"#00ff00", "#0000ff"}}};
    layer.transfer.opacity2d = {freshShape("ellipse", {{15, 0.1}, {90, 0.9}})};
    figure.layers = {layer};
    return figure;
}

TEST(PlaneView, OpacityIsThatOfTheFunctionAtTheCellsMiddles) {
    Figure figure = rampFigure();
    Transfer& t = figure.layers[0].transfer;
    t.opacity = {{0, 0.2}, {100, 1}};
    t.opacity2d[0].soft = 0.4;
    const PlaneBox part{{10, 0}, {110, 1}};
    const std::vector<float> opacity = planeOpacity(t, part, {20, 10});
    for (int row = 0; row < 10; ++row)
        for (int column = 0; column < 20; ++column)
            EXPECT_FLOAT_EQ(opacity[static_cast<std::size_t>(row * 20 + column)],
                            static_cast<float>(opacity2dAt(t, 12.5 + 5 * column, 0.95 - 0.1 * row)));
}

TEST(PlaneView, CountsFollowTheAxesOrder) {
    const Figure figure = rampFigure();
    Transfer t = figure.layers[0].transfer;
    Task task;
    const auto joint = planeHistogram(figure, t, task);
    ASSERT_TRUE(joint);
    EXPECT_EQ(joint->x, (ValueRange{0, 150}));
    EXPECT_EQ(joint->y, (ValueRange{0, 1}));
    EXPECT_EQ(std::accumulate(joint->counts.begin(), joint->counts.end(), std::uint64_t{0}), 51U * 36);
    EXPECT_EQ(joint->at(0, joint->rows / 2), 36U) << "half the slope at the border, where the voxel repeats";
    t.axes = {"gradient", "value"};
    const auto turned = planeHistogram(figure, t, task);
    ASSERT_TRUE(turned);
    EXPECT_EQ(turned->y, (ValueRange{0, 150}));
    EXPECT_EQ(turned->at(turned->columns / 2, 0), 36U);
    for (const char* none : {"curvature", "importance", "label", "second"}) {
        t.axes = {"value", none};
        EXPECT_FALSE(planeHistogram(figure, t, task)) << none;
    }
    t.axes = {"value", "distance"};
    t.distance = DistanceOrigin{figure.camera.targetMm, 0};
    EXPECT_TRUE(planeHistogram(figure, t, task));
}

TEST(PlaneView, AnotherAxisStretchesWhatLiesOnTheOldOne) {
    const Figure figure = rampFigure();
    const Transfer& t = figure.layers[0].transfer;
    const Transfer distance = withAxis(figure, t, 1, "distance");
    const double far = shownRange(figure, distance, TransferAxis::distance).high;
    EXPECT_EQ(distance.axes[1], "distance");
    EXPECT_NEAR(boxOf(distance.opacity2d[0]).high.y, 0.9 * far, 1e-9);
    EXPECT_NEAR(distance.grid->y[0], 0.2 * far, 1e-9);
    EXPECT_EQ(distance.opacity2d[0].x, t.opacity2d[0].x);
    EXPECT_EQ(distance.distance->fromMm, figure.camera.targetMm);
    const Transfer labels = withAxis(figure, t, 1, "label");
    EXPECT_EQ(labels.grid->y, (std::vector<double>{-1}));
    EXPECT_EQ(labels.grid->styles.size(), 1U);
    const Transfer swapped = withAxis(figure, t, 1, "value");
    EXPECT_EQ(swapped.axes, (std::vector<std::string>{"gradient", "value"}));
    EXPECT_NEAR(boxOf(swapped.opacity2d[0]).low.x, 0.1, 1e-9) << "the same shares of both axes";
    Transfer line;
    line.opacity = {{15, 0}, {150, 1}};
    line.nodes = {{75, "", glm::dvec3(1)}};
    const Transfer gradient = withAxis(figure, line, 0, "gradient");
    EXPECT_NEAR(gradient.opacity[0].x, 0.1, 1e-12);
    EXPECT_NEAR(gradient.nodes[0].at, 0.5, 1e-12);
}

} // namespace
} // namespace limner
