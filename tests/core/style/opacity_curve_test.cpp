#include "core/style/transfer_function.h"

#include "core/figure/figure_json.h"
#include "support/make_volume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace limner {
namespace {

using Points = std::vector<glm::dvec2>;

TEST(OpacityCurve, StepHoldsThePointAtOrBefore) {
    const Points points{{100, 0.2}, {200, 0.6}, {200, 0.7}, {400, 0}};
    const auto at = [&](double s) { return opacityAt(points, s, OpacityCurve::step); };
    EXPECT_EQ(at(-5), 0.2);
    EXPECT_EQ(at(100), 0.2);
    EXPECT_EQ(at(std::nextafter(200, 0)), 0.2);
    EXPECT_EQ(at(200), 0.7);
    EXPECT_EQ(at(399), 0.7);
    EXPECT_EQ(at(400), 0);
    EXPECT_EQ(at(1e9), 0);
    EXPECT_EQ(opacityAt({}, 3, OpacityCurve::step), 0);
}

/// Between two points alone the smooth curve is the cubic that is level at both: 3 t^2 - 2 t^3.
TEST(OpacityCurve, SmoothBetweenTwoPointsIsTheLevelCubic) {
    const Points points{{-10, 0.1}, {30, 0.9}};
    for (const double t : {0.0, 0.125, 0.25, 0.5, 0.75, 1.0})
        EXPECT_NEAR(opacityAt(points, -10 + 40 * t, OpacityCurve::smooth), 0.1 + 0.8 * (3 - 2 * t) * t * t, 1e-15) << t;
    EXPECT_EQ(opacityAt(points, -11, OpacityCurve::smooth), 0.1);
    EXPECT_EQ(opacityAt(points, 31, OpacityCurve::smooth), 0.9);
}

/// Equal distances, slopes 1 and 3 around the middle point: their weighted harmonic mean is 2 * 3 / (1 + 3) = 1.5.
/// At t = 1/2 of the first piece a cubic of slopes 0 and 1.5 over a rise of 0.1 per 0.1 is 0.05 - 1.5 * 0.1 / 8.
TEST(OpacityCurve, SmoothSlopesAreHarmonicMeans) {
    const Points points{{0, 0}, {0.1, 0.1}, {0.2, 0.4}};
    EXPECT_NEAR(opacityAt(points, 0.05, OpacityCurve::smooth), 0.05 - 1.5 * 0.1 / 8, 1e-15);
    constexpr double kSmall = 1e-6;
    const double slope = (opacityAt(points, 0.1 + kSmall, OpacityCurve::smooth) -
                          opacityAt(points, 0.1 - kSmall, OpacityCurve::smooth)) /
                         (2 * kSmall);
    EXPECT_NEAR(slope, 1.5, 1e-4);
}

TEST(OpacityCurve, SmoothGoesThroughItsPointsAndStaysBetweenThem) {
    std::mt19937 random(2026);
    const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
    for (int run = 0; run < 200; ++run) {
        Points points;
        double x = -1000;
        for (int i = 0; i < 9; ++i) {
            x += unit() < 0.2 ? 0 : std::pow(10, 4 * unit() - 1); // steps, and very unlike distances
            points.push_back({x, unit() < 0.3 ? std::round(unit()) : unit()});
        }
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            const auto [low, high] = std::minmax(points[i].y, points[i + 1].y);
            double last = points[i].y;
            for (int k = 0; k < 40 && points[i + 1].x > points[i].x; ++k) {
                const double s = points[i].x + (points[i + 1].x - points[i].x) * k / 40;
                const double opacity = opacityAt(points, s, OpacityCurve::smooth);
                ASSERT_GE(opacity, low);
                ASSERT_LE(opacity, high);
                const double rise = (opacity - last) * (points[i + 1].y - points[i].y);
                ASSERT_GE(rise, -1e-15) << "it turns back between two points";
                last = opacity;
            }
            ASSERT_EQ(opacityAt(points, points[i + 1].x, OpacityCurve::smooth),
                      opacityAt(points, points[i + 1].x, OpacityCurve::linear));
        }
    }
}

TEST(OpacityCurve, TablesAreBakedFromTheChosenKind) {
    const auto volume = testing::makeVolume<std::int16_t>(testing::gridOf({2, 1, 1}), VoxelType::int16,
                                                          [](glm::ivec3 v) { return v.x == 0 ? 0 : 4095; });
    Layer layer;
    layer.transfer.opacity = {{100, 0}, {900, 0.7}, {1500, 1}, {1500, 0.2}, {3000, 0}};
    for (const OpacityCurve curve : {OpacityCurve::linear, OpacityCurve::smooth, OpacityCurve::step}) {
        layer.transfer.curve = curve;
        const TransferTable table = bakeTransfer(layer, *volume);
        ASSERT_EQ(table.opacity.size(), 4096U);
        for (int k = 0; k < 4096; ++k)
            ASSERT_EQ(table.opacity[static_cast<std::size_t>(k)],
                      static_cast<float>(opacityAt(layer.transfer.opacity, k, curve)))
                << k;
    }
}

TEST(OpacityCurve, MultipliesAPlanesShapesByItsKind) {
    Transfer plane;
    plane.kind = TransferKind::twoDimensional;
    plane.axes = {"value", "gradient"};
    plane.opacity = {{0, 0.25}, {10, 0.75}};
    plane.curve = OpacityCurve::step;
    EXPECT_EQ(opacity2dAt(plane, 9, 0.5), 0.25);
    plane.curve = OpacityCurve::smooth;
    EXPECT_EQ(opacity2dAt(plane, 5, 0.5), 0.5);
}

TEST(OpacityCurve, IsWrittenOnlyWhereItIsNotLinear) {
    Figure figure;
    figure.layers.emplace_back();
    figure.layers[0].name = "Bone";
    figure.layers[0].transfer.opacity = {{0, 0}, {1, 1}};
    EXPECT_EQ(writeFigure(figure).find("opacity_curve"), std::string::npos);
    figure.layers[0].transfer.curve = OpacityCurve::smooth;
    const std::string text = writeFigure(figure);
    EXPECT_NE(text.find("\"opacity_curve\": \"smooth\""), std::string::npos);
    EXPECT_EQ(readFigure(text, "text").layers[0].transfer, figure.layers[0].transfer);
}

} // namespace
} // namespace limner
