#include "core/figure/transfer_kinds.h"

#include "core/figure/figure_json.h"
#include "core/style/transfer_function.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace limner {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
const PlaneBox kPlane{{-1000, 0}, {3000, 1}};

Transfer lineOf(std::vector<glm::dvec2> points) {
    Transfer line;
    line.opacity = std::move(points);
    line.nodes = {{100, "ivory", std::nullopt}, {900, "", glm::dvec3(1, 0.5, 0)}};
    return line;
}

/// The plane shows at every height what the line shows.
void expectSame(const Transfer& plane, const Transfer& line) {
    for (int i = 0; i <= 400; ++i) {
        const double x = -1000 + 10.0 * i;
        for (const double y : {0.0, 0.3, 1.0})
            ASSERT_NEAR(opacity2dAt(plane, x, y), curveOpacityAt(line, x), 1e-12) << x;
    }
}

TEST(TransferKinds, BumpsBecomeTrapezoidsAndComeBack) {
    const Transfer line =
        lineOf({{-200, 0}, {-100, 0.1}, {100, 0.1}, {150, 0}, {300, 0}, {400, 0.9}, {900, 0.9}, {901, 0}});
    const Transfer plane = withTwoAxes(line, "gradient", kPlane);
    ASSERT_EQ(plane.opacity2d.size(), 2U);
    EXPECT_EQ(plane.opacity2d[0].shape, "trapezoid");
    EXPECT_EQ(plane.opacity2d[0].x, (std::vector<double>{-200, -100, 100, 150}));
    EXPECT_EQ(plane.opacity2d[1].opacity, 0.9);
    EXPECT_TRUE(plane.opacity.empty());
    EXPECT_EQ(plane.axes, (std::vector<std::string>{"value", "gradient"}));
    ASSERT_TRUE(plane.grid);
    EXPECT_EQ(plane.grid->x, (std::vector<double>{100, 900}));
    EXPECT_EQ(plane.grid->styles, (std::vector<std::vector<std::string>>{{"ivory", "#ff8000"}}));
    expectSame(plane, line);
    const Transfer back = withOneAxis(plane, kPlane);
    EXPECT_EQ(back.opacity, line.opacity);
    EXPECT_EQ(back.kind, TransferKind::oneDimensional);
    EXPECT_EQ(back.axis, "value");
    EXPECT_EQ(back.nodes[0], line.nodes[0]);
    EXPECT_NEAR(back.nodes[1].rgb->y, 0.5, 0.5 / 255);
}

TEST(TransferKinds, AnOpenEndStaysOpen) {
    const Transfer line = lineOf({{150, 0}, {250, 0.8}});
    const Transfer plane = withTwoAxes(line, "gradient", kPlane);
    ASSERT_EQ(plane.opacity2d.size(), 1U);
    EXPECT_EQ(plane.opacity2d[0].x, (std::vector<double>{150, 250, 3000, 3000}));
    expectSame(plane, line);
    EXPECT_EQ(withOneAxis(plane, kPlane).opacity, line.opacity);
}

TEST(TransferKinds, OtherCurvesStayCurvesOverAFullRectangle) {
    Transfer line = lineOf({{150, 0}, {250, 0.8}, {1000, 1}});
    for (const OpacityCurve curve : {OpacityCurve::linear, OpacityCurve::smooth, OpacityCurve::step}) {
        line.curve = curve;
        const Transfer plane = withTwoAxes(line, "gradient", kPlane);
        ASSERT_EQ(plane.opacity2d.size(), 1U);
        EXPECT_EQ(plane.opacity2d[0].shape, "rectangle");
        expectSame(plane, line);
        const Transfer back = withOneAxis(plane, kPlane);
        EXPECT_EQ(back.opacity, line.opacity);
        EXPECT_EQ(back.curve, curve);
    }
}

TEST(TransferKinds, OtherShapesLeaveTheirOutline) {
    Transfer plane = withTwoAxes(lineOf({{0, 0}, {1, 1}}), "gradient", kPlane);
    plane.opacity.clear();
    OpacityShape ellipse = freshShape("ellipse", {{0, 0.2}, {1000, 0.6}});
    ellipse.opacity = 0.5;
    ellipse.soft = 1; // along the middle 0.5 * (1 - |x - 500| / 500)
    plane.opacity2d = {ellipse};
    const Transfer line = withOneAxis(plane, kPlane);
    EXPECT_LT(line.opacity.size(), 12U);
    for (const double x : {-500.0, 100.0, 250.0, 500.0, 900.0, 2000.0})
        EXPECT_NEAR(curveOpacityAt(line, x), std::max(0.0, 0.5 * (1 - std::abs(x - 500) / 500)), 0.011) << x;
}

TEST(TransferKinds, StepsOfNodesAndLayersWithoutNodesAreLegalGrids) {
    Figure figure;
    figure.layers.emplace_back();
    for (const int nodes : {0, 2}) {
        Transfer line = lineOf({{150, 0}, {250, 0.8}});
        line.nodes.clear();
        for (int i = 0; i < nodes; ++i)
            line.nodes.push_back({300, "", glm::dvec3(0.2 * i)});
        figure.layers[0].transfer = withTwoAxes(line, "gradient", kPlane);
        for (const Problem& problem : validateFigure(figure))
            EXPECT_EQ(problem.pointer.find("/layers/0/transfer"), std::string::npos) << problem.why;
    }
}

TEST(TransferKinds, AFlankMovesOutToShowAValue) {
    const Transfer line = lineOf({{-200, 0}, {-100, 0.1}, {100, 0.1}, {150, 0}, {300, 0}, {400, 0.9}});
    // 280 is 120 below bone's full point and 180 above skin's: bone's flank comes, skin's fall-off is not touched.
    const Transfer bone = withValueShown(line, 280);
    EXPECT_EQ(bone.opacity,
              (std::vector<glm::dvec2>{{-200, 0}, {-100, 0.1}, {100, 0.1}, {150, 0}, {180, 0}, {280, 0.9}}));
    const Transfer skin = withValueShown(line, 200);
    EXPECT_EQ(skin.opacity[2], glm::dvec2(200, 0.1));
    EXPECT_EQ(skin.opacity[3], glm::dvec2(250, 0));
    EXPECT_EQ(skin.opacity[4], glm::dvec2(300, 0));
    EXPECT_EQ(withValueShown(line, 2000), line) << "it shows already";
    EXPECT_EQ(withValueShown(line, 360), line) << "more than half of it shows";
    EXPECT_EQ(withValueShown(line, -500).opacity[1], glm::dvec2(-500, 0.1));
    EXPECT_EQ(withValueShown(Transfer{}, 5), Transfer{});
}

TEST(TransferKinds, TheNearestShapeGrowsToHoldAPlace) {
    Transfer plane = withTwoAxes(lineOf({{0, 0}, {1, 1}}), "gradient", kPlane);
    plane.opacity.clear();
    for (const char* kind : {"rectangle", "trapezoid", "ellipse", "polygon"})
        for (const double soft : {0.0, 0.5}) {
            OpacityShape near = freshShape(kind, {{0, 0.2}, {400, 0.4}});
            near.soft = soft;
            const OpacityShape far = freshShape("rectangle", {{2000, 0.8}, {2500, 1}});
            plane.opacity2d = {near, far};
            const glm::dvec2 at(600, 0.5);
            const Transfer grown = withPlaceShown(plane, at, {4000, 1});
            EXPECT_GT(opacity2dAt(grown, at.x, at.y), 0) << kind << soft;
            EXPECT_GE(boxOf(grown.opacity2d[0]).high.x, 600);
            EXPECT_EQ(grown.opacity2d[1], far);
            EXPECT_EQ(withPlaceShown(plane, {200, 0.3}, {4000, 1}), plane) << kind << " holds its middle";
        }
    plane.opacity2d.clear();
    EXPECT_EQ(withPlaceShown(plane, {1, 1}, {1, 1}), plane);
}

TEST(ShapeEdits, HandlesMoveTheirNumbersAndNoOthers) {
    for (const char* kind : {"rectangle", "trapezoid", "ellipse", "polygon", "mask"}) {
        const OpacityShape shape = freshShape(kind, {{0, 0}, {300, 0.6}});
        const std::vector<ShapeHandle> handles = handlesOf(shape);
        ASSERT_EQ(handles.size(), std::string(kind) == "polygon" ? 4U : 8U) << kind;
        for (std::size_t i = 0; i < handles.size(); ++i) {
            const OpacityShape moved = withHandleMoved(shape, i, handles[i].at + glm::dvec2(7, 0.01));
            for (std::size_t k = 0; k < shape.x.size(); ++k)
                EXPECT_NEAR(moved.x[k] - shape.x[k], static_cast<int>(k) == handles[i].x ? 7 : 0, 1e-9) << kind << i;
            if (std::string(kind) == "trapezoid")
                continue; // its two lower and its two upper numbers stand together and hold each other
            for (std::size_t k = 0; k < shape.y.size(); ++k)
                EXPECT_NEAR(moved.y[k] - shape.y[k], static_cast<int>(k) == handles[i].y ? 0.01 : 0, 1e-9) << kind << i;
        }
        const OpacityShape held = withHandleMoved(shape, 0, {kInf, kInf});
        if (std::string(kind) != "polygon") {
            EXPECT_EQ(held.x[0], held.x[1]) << "numbers keep their order";
        }
        const OpacityShape shifted = withShapeMoved(shape, {10, 0.1});
        EXPECT_EQ(boxOf(shifted).low, glm::dvec2(10, 0.1));
    }
}

TEST(ShapeEdits, PolygonsGainAndLosePoints) {
    const OpacityShape diamond = freshShape("polygon", {{0, 0}, {2, 2}}); // (1,0) (2,1) (1,2) (0,1)
    const AddedCorner added = withCornerAdded(diamond, {1.6, 1.7}, {1, 1});
    EXPECT_EQ(added.index, 2U);
    EXPECT_EQ(added.shape.x, (std::vector<double>{1, 2, 1.6, 1, 0}));
    const AddedCorner closing = withCornerAdded(diamond, {0.4, 0.3}, {1, 1});
    EXPECT_EQ(closing.index, 4U) << "the edge from the last point to the first";
    OpacityShape triangle = withCornerRemoved(diamond, 1);
    EXPECT_EQ(triangle.x, (std::vector<double>{1, 1, 0}));
    EXPECT_EQ(withCornerRemoved(triangle, 0), triangle);
}

TEST(ShapeEdits, ABrushPaintsAndErases) {
    OpacityShape mask = freshShape("mask", {{0, 0}, {64, 64}}); // a cell per unit
    mask = withMaskPainted(mask, {{32, 32}, {5, 5}, 1, 0});
    EXPECT_EQ(membershipAt(mask, {32, 32}), 1);
    EXPECT_EQ(membershipAt(mask, {40, 32}), 0);
    const OpacityShape again = withMaskPainted(mask, {{32, 32}, {5, 5}, 1, 1});
    EXPECT_EQ(again, mask) << "a softer brush takes nothing away";
    const OpacityShape hole = withMaskPainted(mask, {{32, 32}, {2, 2}, 0, 0});
    EXPECT_EQ(membershipAt(hole, {32, 32}), 0);
    EXPECT_EQ(membershipAt(hole, {35.5, 32}), 1);
}

TEST(ShapeEdits, GridsKeepTheirLooksAndStrictOrder) {
    const TransferGrid grid{{0, 10}, {0.5}, {{"a", "b"}}};
    const TransferGrid wide = withColumnAdded(grid, 4);
    EXPECT_EQ(wide.x, (std::vector<double>{0, 4, 10}));
    EXPECT_EQ(wide.styles, (std::vector<std::vector<std::string>>{{"a", "a", "b"}}));
    const TransferGrid tall = withRowAdded(wide, 0.9);
    EXPECT_EQ(tall.y, (std::vector<double>{0.5, 0.9}));
    EXPECT_EQ(tall.styles[1], wide.styles[0]);
    EXPECT_EQ(withRowRemoved(tall, 1), wide);
    EXPECT_EQ(withColumnRemoved(wide, 1), grid);
    EXPECT_EQ(withRowRemoved(grid, 0), grid) << "the last row stays";
    const TransferGrid moved = withColumnMoved(wide, 1, 99);
    EXPECT_LT(moved.x[1], 10);
    EXPECT_GT(moved.x[1], 9.99);
    EXPECT_GT(withColumnAdded(grid, 10).x[2], 10);
}

} // namespace
} // namespace limner
