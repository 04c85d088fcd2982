#include "core/style/transfer_function.h"

#include "support/make_volume.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace limner {
namespace {

using testing::gridOf;
using testing::makeVolume;

std::shared_ptr<const Volume> rampOf16Bit(int low, int high) {
    return makeVolume<std::int16_t>(gridOf({2, 1, 1}), VoxelType::int16,
                                    [&](glm::ivec3 v) { return v.x == 0 ? low : high; });
}

OpacityShape shapeOf(const std::string& kind, std::vector<double> x, std::vector<double> y) {
    OpacityShape shape;
    shape.shape = kind;
    shape.x = std::move(x);
    shape.y = std::move(y);
    return shape;
}

OpacityShape maskOf(int columns, std::vector<double> values) {
    OpacityShape mask = shapeOf("mask", {0, 8}, {10, 14});
    mask.columns = columns;
    mask.values = std::move(values);
    return mask;
}

Transfer planeOf(std::vector<std::string> axes, std::vector<OpacityShape> shapes) {
    Transfer transfer;
    transfer.kind = TransferKind::twoDimensional;
    transfer.axes = std::move(axes);
    transfer.opacity2d = std::move(shapes);
    return transfer;
}

double shapeAt(const OpacityShape& shape, double x, double y) {
    return opacity2dAt(planeOf({"value", "gradient"}, {shape}), x, y);
}

TEST(TransferAxes, AreNamedAsInTheDocument) {
    EXPECT_EQ(transferAxis("value"), TransferAxis::value);
    EXPECT_EQ(transferAxis("gradient"), TransferAxis::gradient);
    EXPECT_EQ(transferAxis("label"), TransferAxis::label);
    EXPECT_EQ(transferAxis("distance"), TransferAxis::distance);
    EXPECT_EQ(transferAxis("importance"), TransferAxis::importance);
    EXPECT_EQ(transferAxis("curvature"), TransferAxis::curvature);
    EXPECT_EQ(transferAxis("second"), TransferAxis::second);
    EXPECT_EQ(transferAxis("smell"), TransferAxis::value);
    Transfer transfer;
    transfer.axis = "distance";
    EXPECT_EQ(firstAxis(transfer), TransferAxis::distance);
    EXPECT_EQ(secondAxis(transfer), std::nullopt);
    transfer = planeOf({"curvature", "label"}, {});
    EXPECT_EQ(firstAxis(transfer), TransferAxis::curvature);
    EXPECT_EQ(secondAxis(transfer), TransferAxis::label);
    EXPECT_EQ(secondAxis(planeOf({"curvature"}, {})), std::nullopt);
}

TEST(Opacity2dAt, RectangleIsClosedAndSoftInside) {
    OpacityShape shape = shapeOf("rectangle", {10, 30}, {0.25, 0.75});
    shape.opacity = 0.5;
    for (const double x : {10.0, 20.0, 30.0}) {
        for (const double y : {0.25, 0.5, 0.75}) {
            EXPECT_EQ(shapeAt(shape, x, y), 0.5);
        }
    }
    EXPECT_EQ(shapeAt(shape, std::nextafter(10, 0), 0.5), 0);
    EXPECT_EQ(shapeAt(shape, std::nextafter(30, 40), 0.5), 0);
    EXPECT_EQ(shapeAt(shape, 20, std::nextafter(0.25, 0)), 0);
    EXPECT_EQ(shapeAt(shape, 20, std::nextafter(0.75, 1)), 0);
    shape.soft = 0.5; // ramps 5 wide along x, 0.125 along y
    EXPECT_EQ(shapeAt(shape, 10, 0.5), 0);
    EXPECT_EQ(shapeAt(shape, 11, 0.5), 0.5 * 0.2);
    EXPECT_EQ(shapeAt(shape, 29, 0.5), 0.5 * 0.2);
    EXPECT_EQ(shapeAt(shape, 15, 0.5), 0.5);
    EXPECT_EQ(shapeAt(shape, 20, 0.25 + 0.0625), 0.5 * 0.5);
    EXPECT_EQ(shapeAt(shape, 11, 0.75 - 0.0625), 0.5 * 0.2 * 0.5);
    shape.soft = 1;
    EXPECT_EQ(shapeAt(shape, 20, 0.5), 0.5);
    EXPECT_EQ(shapeAt(shape, 15, 0.5), 0.25);
}

TEST(Opacity2dAt, TrapezoidIsTheProductOfItsRamps) {
    const OpacityShape shape = shapeOf("trapezoid", {-250, -150, 50, 150}, {0.125, 0.25, 1, 1});
    const auto along = [](double x) { // by hand, from the corners
        return x < -150 ? (x + 250) / 100 : x > 50 ? (150 - x) / 100 : 1;
    };
    for (const double x : {-250.0, -225.0, -150.0, 0.0, 50.0, 100.0, 150.0}) {
        EXPECT_DOUBLE_EQ(shapeAt(shape, x, 0.5), along(x)) << x;
        EXPECT_DOUBLE_EQ(shapeAt(shape, x, 0.1875), along(x) / 2) << x;
        EXPECT_DOUBLE_EQ(shapeAt(shape, x, 1), along(x)) << x; // a step at the top, its border inside
        EXPECT_EQ(shapeAt(shape, x, std::nextafter(1, 2)), 0) << x;
        EXPECT_EQ(shapeAt(shape, x, 0.12), 0) << x;
    }
    EXPECT_EQ(shapeAt(shape, -251, 0.5), 0);
    EXPECT_EQ(shapeAt(shape, 151, 0.5), 0);
}

TEST(Opacity2dAt, EllipseFallsAlongTheRadius) {
    OpacityShape shape = shapeOf("ellipse", {-4, 4}, {1, 3});
    EXPECT_EQ(shapeAt(shape, 0, 2), 1);
    EXPECT_EQ(shapeAt(shape, 4, 2), 1); // the four vertices are inside
    EXPECT_EQ(shapeAt(shape, -4, 2), 1);
    EXPECT_EQ(shapeAt(shape, 0, 1), 1);
    EXPECT_EQ(shapeAt(shape, 0, 3), 1);
    EXPECT_EQ(shapeAt(shape, 4 * 0.8 - 1e-9, 2.6 - 1e-9), 1);
    EXPECT_EQ(shapeAt(shape, 4 * 0.8 + 1e-9, 2.6 + 1e-9), 0);
    EXPECT_EQ(shapeAt(shape, 3.9, 2.9), 0);
    shape.soft = 0.5;
    EXPECT_EQ(shapeAt(shape, 4, 2), 0);
    EXPECT_EQ(shapeAt(shape, 3, 2), 0.5);            // radius 3/4, halfway up the ramp
    EXPECT_NEAR(shapeAt(shape, 0, 2.9), 0.2, 1e-15); // radius 9/10
    EXPECT_DOUBLE_EQ(shapeAt(shape, 0.6 * 3, 2 + 0.8 * 0.75), std::min(1.0, (1 - std::hypot(0.45, 0.6)) / 0.5));
    EXPECT_EQ(shapeAt(shape, 2, 2), 1);
    // No vertex is lost to rounding where the corners are no round numbers.
    const OpacityShape odd = shapeOf("ellipse", {0.1, 0.3}, {-0.7, 1.3});
    EXPECT_EQ(shapeAt(odd, 0.1, 0.3) + shapeAt(odd, 0.3, 0.3), 2);
}

TEST(Opacity2dAt, PolygonIsSoftByTheDistanceToItsEdges) {
    // A triangle with its right angle at (0, 0), legs 100 and 2: half extents 50 and 1.
    OpacityShape shape = shapeOf("polygon", {0, 100, 0}, {0, 0, 2});
    EXPECT_EQ(shapeAt(shape, 20, 0.5), 1);
    EXPECT_EQ(shapeAt(shape, 60, 1), 0);
    for (const auto& [x, y] : {std::pair(0.0, 0.0), {100.0, 0.0}, {0.0, 2.0}, {40.0, 0.0}, {0.0, 1.1}, {30.0, 1.4}}) {
        EXPECT_EQ(shapeAt(shape, x, y), 1) << x << " " << y; // corners and edges
    }
    EXPECT_EQ(shapeAt(shape, 30.01, 1.4), 0);
    EXPECT_EQ(shapeAt(shape, -1e-9, 1), 0);
    shape.soft = 0.8;
    EXPECT_EQ(shapeAt(shape, 0, 1), 0);
    EXPECT_DOUBLE_EQ(shapeAt(shape, 10, 0.8), 0.2 / 0.8);   // left edge nearest: 10 of 50
    EXPECT_DOUBLE_EQ(shapeAt(shape, 30, 0.25), 0.25 / 0.8); // lower edge nearest: 0.25 of 1
    // The long edge is nearest: normalised, x + y = 0, at the distance |x + y| / sqrt(2).
    EXPECT_DOUBLE_EQ(shapeAt(shape, 40, 1), 0.2 / std::sqrt(2.0) / 0.8);
}

TEST(Opacity2dAt, PolygonsMayBeConcaveAndCrossThemselves) {
    const OpacityShape arrow = shapeOf("polygon", {0, 4, 0, 1}, {0, 2, 4, 2});
    EXPECT_EQ(shapeAt(arrow, 0.75, 2), 0);
    EXPECT_EQ(shapeAt(arrow, 1.5, 2), 1);
    // A five-pointed star drawn in one go: its middle is outside.
    OpacityShape star = shapeOf("polygon", {}, {});
    for (int k = 0; k < 5; ++k) {
        const double angle = 2 * M_PI * 2 * k / 5;
        star.x.push_back(std::sin(angle));
        star.y.push_back(std::cos(angle));
    }
    EXPECT_EQ(shapeAt(star, 0, 0), 0);
    EXPECT_EQ(shapeAt(star, 0, 0.8), 1);
}

TEST(Opacity2dAt, MaskIsBilinearBetweenCellCentres) {
    // Cells 2 wide and 2 high: centres at 1, 3, 5, 7 and at 11, 13.
    const OpacityShape mask = maskOf(4, {0, 0.25, 0.5, 1, 1, 0.75, 0.5, 0});
    EXPECT_EQ(shapeAt(mask, 3, 11), 0.25);
    EXPECT_EQ(shapeAt(mask, 7, 11), 1);
    EXPECT_EQ(shapeAt(mask, 1, 13), 1);
    EXPECT_EQ(shapeAt(mask, 4, 11), 0.375);
    EXPECT_EQ(shapeAt(mask, 3, 12), 0.5);
    EXPECT_EQ(shapeAt(mask, 6, 12.5), 0.25 * 0.75 + 0.75 * 0.25);
    EXPECT_EQ(shapeAt(mask, 8, 10), 1); // constant from the outer centres to the closed box
    EXPECT_EQ(shapeAt(mask, 0, 14), 1);
    EXPECT_EQ(shapeAt(mask, 8.001, 11), 0);
    EXPECT_EQ(shapeAt(mask, 7, 9.999), 0);
}

TEST(Opacity2dAt, GreatestShapeTimesTheCurve) {
    OpacityShape faint = shapeOf("rectangle", {0, 10}, {0, 1});
    faint.opacity = 0.25;
    OpacityShape strong = shapeOf("rectangle", {5, 20}, {0, 1});
    strong.opacity = 0.75;
    Transfer transfer = planeOf({"value", "gradient"}, {strong, faint});
    EXPECT_EQ(opacity2dAt(transfer, 2, 0.5), 0.25);
    EXPECT_EQ(opacity2dAt(transfer, 7, 0.5), 0.75);
    EXPECT_EQ(opacity2dAt(transfer, 25, 0.5), 0);
    transfer.opacity = {{0, 0}, {20, 1}};
    EXPECT_EQ(opacity2dAt(transfer, 10, 0.5), 0.5 * 0.75);
    transfer.opacity2d.clear();
    EXPECT_EQ(opacity2dAt(transfer, 10, 0.5), 0.5);
    transfer.opacity.clear();
    EXPECT_EQ(opacity2dAt(transfer, 10, 0.5), 1);
}

TEST(Opacity2dAt, DegenerateCornersAreHarmless) {
    // All corners one, or one axis without extent: the closed border alone is left.
    for (const double soft : {0.0, 0.5}) {
        for (const char* kind : {"rectangle", "ellipse", "trapezoid", "polygon", "mask"}) {
            OpacityShape point = shapeOf(kind, {3, 3, 3, 3}, {5, 5, 5, 5});
            point.soft = soft;
            point.columns = 1;
            point.values = {1};
            const bool soften = soft > 0 && point.shape == "polygon"; // all of it is border
            EXPECT_EQ(shapeAt(point, 3, 5), soften ? 0 : 1) << kind;
            EXPECT_EQ(shapeAt(point, std::nextafter(3, 4), 5), 0) << kind;
            EXPECT_EQ(shapeAt(point, 3, std::nextafter(5, 4)), 0) << kind;
        }
    }
    EXPECT_EQ(shapeAt(shapeOf("rectangle", {3, 3}, {0, 1}), 3, 0.5), 1);
    EXPECT_EQ(shapeAt(shapeOf("ellipse", {3, 3}, {0, 1}), 3, 1), 1);
    // The wrong way round is the same shape.
    EXPECT_EQ(shapeAt(shapeOf("rectangle", {4, 2}, {1, 0}), 3, 0.5), 1);
    EXPECT_EQ(shapeAt(shapeOf("trapezoid", {4, 3, 2, 0}, {1, 1, 0, 0}), 1, 0.5), 0.5);
    // What is no shape covers nothing.
    EXPECT_EQ(shapeAt(shapeOf("rectangle", {1}, {0, 1}), 1, 0.5), 0);
    EXPECT_EQ(shapeAt(shapeOf("trapezoid", {0, 1}, {0, 1}), 0.5, 0.5), 0);
    EXPECT_EQ(shapeAt(shapeOf("polygon", {0, 1, 1}, {0, 1}), 0.5, 0.5), 0);
    EXPECT_EQ(shapeAt(shapeOf("polygon", {}, {}), 0, 0), 0);
    EXPECT_EQ(shapeAt(shapeOf("blob", {0, 1}, {0, 1}), 0.5, 0.5), 0);
    EXPECT_EQ(shapeAt(maskOf(0, {1}), 4, 12), 0);
    EXPECT_EQ(shapeAt(maskOf(-3, {1}), 4, 12), 0);
    EXPECT_EQ(shapeAt(maskOf(3, {1}), 4, 12), 0);
}

TEST(Opacity2dAt, StaysWithinZeroAndOneWhateverTheNumbers) {
    const double strange[] = {0, 1, -1, 1e-320, 1e308, -1e308, std::numeric_limits<double>::infinity(), std::nan("")};
    std::mt19937 random(17);
    std::uniform_int_distribution<std::size_t> any(0, std::size(strange) - 1);
    for (int run = 0; run < 20000; ++run) {
        for (const char* kind : {"rectangle", "ellipse", "trapezoid", "polygon", "mask"}) {
            OpacityShape shape = shapeOf(kind, {}, {});
            for (int k = 0; k < 4; ++k) {
                shape.x.push_back(strange[any(random)]);
                shape.y.push_back(strange[any(random)]);
                shape.values.push_back(strange[any(random)]);
            }
            shape.columns = 2;
            shape.soft = strange[any(random)];
            shape.opacity = strange[any(random)];
            const double opacity = shapeAt(shape, strange[any(random)], strange[any(random)]);
            ASSERT_TRUE(opacity >= 0 && opacity <= 1) << kind << " " << opacity;
        }
    }
}

TEST(GridIndexAt, FractionalBetweenPositions) {
    const std::vector<double> positions{-100, 100, 500};
    EXPECT_EQ(gridIndexAt(positions, -1000, false), 0);
    EXPECT_EQ(gridIndexAt(positions, -50, false), 0.25);
    EXPECT_EQ(gridIndexAt(positions, 100, false), 1);
    EXPECT_EQ(gridIndexAt(positions, 400, false), 1.75);
    EXPECT_EQ(gridIndexAt(positions, 1e9, false), 2);
    EXPECT_EQ(gridIndexAt({}, 3, false), 0);
    EXPECT_EQ(gridIndexAt({7}, 3, false), 0);
}

TEST(GridIndexAt, LabelsHaveTheirOwnRowOrTheOthers) {
    const std::vector<double> positions{1, 4, 7.2};
    EXPECT_EQ(gridIndexAt(positions, 1, true), 0);
    EXPECT_EQ(gridIndexAt(positions, 4.3, true), 1);
    EXPECT_EQ(gridIndexAt(positions, 7, true), 2);
    EXPECT_EQ(gridIndexAt(positions, 5, true), -1);
    EXPECT_EQ(gridIndexAt({}, 5, true), -1);
    EXPECT_EQ(gridIndexAt({-1, 4}, 5, true), 0);
    EXPECT_EQ(gridIndexAt({-1, 4}, 4, true), 1);
    EXPECT_EQ(gridIndexAt({-1, 4}, -1, true), 0);
}

/// A layer over a plane with shapes of all kinds, on [0, 1000] x [0, 1].
Layer layerWithShapes(std::vector<std::string> axes) {
    Layer layer;
    layer.opacity = 0.75;
    layer.transfer = planeOf(std::move(axes),
                             {shapeOf("rectangle", {100, 300}, {0.1, 0.6}), shapeOf("ellipse", {200, 700}, {0.3, 0.9}),
                              shapeOf("trapezoid", {500, 600, 800, 950}, {0, 0.25, 0.5, 1}),
                              shapeOf("polygon", {0, 400, 900, 600, 100}, {0, 0.1, 0.5, 1, 0.7}),
                              shapeOf("mask", {650, 1000}, {0, 1})});
    double opacity = 0.9;
    for (OpacityShape& shape : layer.transfer.opacity2d) {
        shape.soft = 0.3;
        shape.opacity = opacity;
        opacity -= 0.125;
    }
    layer.transfer.opacity2d.back().columns = 16;
    for (int k = 0; k < 16 * 12; ++k) {
        layer.transfer.opacity2d.back().values.push_back(0.5 + 0.5 * std::sin(k * 0.3));
    }
    layer.transfer.opacity = {{0, 0.5}, {1000, 1}};
    return layer;
}

TEST(BakePlane, EntriesAreExact) {
    Layer layer = layerWithShapes({"value", "gradient"});
    layer.transfer.grid = TransferGrid{{100, 500, 900}, {0.2, 0.4}, {{"a", "b", "a"}, {"b", "b", "a"}}};
    const TransferTable table = bakeTransfer(layer, *rampOf16Bit(-24, 1000));
    EXPECT_EQ(table.axisX, TransferAxis::value);
    EXPECT_EQ(table.axisY, TransferAxis::gradient);
    EXPECT_EQ(table.opacity.size(), 1025U); // one per stored number
    EXPECT_EQ(table.rows, 256);
    EXPECT_EQ(table.lowY, 0);
    EXPECT_EQ(table.highY, 1);
    EXPECT_TRUE(table.labels.empty());
    EXPECT_EQ(table.nodesX, 3);
    EXPECT_EQ(table.nodesY, 2);
    EXPECT_EQ(table.nodeStrideX, 1);
    EXPECT_EQ(table.nodeStrideY, 3);
    ASSERT_EQ(table.rowIndex.size(), 256U);
    ASSERT_EQ(table.opacity2d.size(), 256U * 1025U);
    for (std::size_t k = 0; k < 1025; ++k) {
        const double x = static_cast<double>(k) - 24;
        float greatest = 0;
        for (std::size_t row = 0; row < 256; ++row) {
            const double y = static_cast<double>(row) / 255;
            const float exact = static_cast<float>(0.75 * opacity2dAt(layer.transfer, x, y));
            ASSERT_EQ(table.opacity2d[row * 1025 + k], exact) << x << " " << y;
            greatest = std::max(greatest, exact);
        }
        ASSERT_EQ(table.opacity[k], greatest) << x;
        ASSERT_EQ(table.index[k], static_cast<float>(gridIndexAt(layer.transfer.grid->x, x, false))) << x;
    }
    EXPECT_EQ(table.rowIndex[0], 0);
    EXPECT_EQ(table.rowIndex[255], 1);
    EXPECT_FLOAT_EQ(table.rowIndex[85], static_cast<float>((85 / 255.0 - 0.2) / 0.2));
    EXPECT_EQ(table.nodeEntries, (std::vector<double>{124, 524, 924}));
    ASSERT_EQ(table.nodeRows.size(), 2U);
    EXPECT_DOUBLE_EQ(table.nodeRows[0], 51);
    EXPECT_DOUBLE_EQ(table.nodeRows[1], 102);
}

TEST(BakePlane, SizesFollowTheAxes) {
    const auto entries = [](const std::string& axis, int low, int high) {
        return bakeTransfer(layerWithShapes({axis, "importance"}), *rampOf16Bit(low, high)).opacity.size();
    };
    EXPECT_EQ(entries("value", 0, 255), 256U);
    EXPECT_EQ(entries("value", 0, 1), 256U);   // the steps of a coarse scan are parted further
    EXPECT_EQ(entries("value", 0, 100), 301U); // three entries per stored number
    EXPECT_EQ(entries("value", 0, 2047), 2048U);
    EXPECT_EQ(entries("value", 0, 2048), 2048U);
    EXPECT_EQ(entries("value", -32768, 32767), 2048U);
    EXPECT_EQ(entries("gradient", 0, 255), 1024U);
    AxisRanges ranges;
    ranges.distance = {0, 80};
    ranges.curvature = {0, 3};
    ranges.second = {-5, 5};
    const auto volume = rampOf16Bit(0, 255);
    const TransferTable near = bakeTransfer(layerWithShapes({"distance", "curvature"}), *volume, ranges);
    EXPECT_EQ(near.axisX, TransferAxis::distance);
    EXPECT_EQ(near.high, 80);
    EXPECT_EQ(near.highY, 3);
    const TransferTable second = bakeTransfer(layerWithShapes({"second", "importance"}), *volume, ranges);
    EXPECT_EQ(second.low, -5);
    EXPECT_EQ(second.high, 5);
    ranges.second = {2, 2};
    EXPECT_GT(bakeTransfer(layerWithShapes({"second", "importance"}), *volume, ranges).high, 2);
    ranges.second = {std::nan(""), std::numeric_limits<double>::infinity()};
    EXPECT_TRUE(std::isfinite(bakeTransfer(layerWithShapes({"second", "importance"}), *volume, ranges).high));
}

TEST(BakePlane, TheValueIsAlwaysX) {
    Layer layer = layerWithShapes({"gradient", "value"});
    for (OpacityShape& shape : layer.transfer.opacity2d) {
        std::swap(shape.x, shape.y);
    }
    layer.transfer.opacity = {{0, 0.25}, {1, 1}}; // along the document's first axis
    layer.transfer.grid = TransferGrid{{0.2, 0.4}, {100, 500, 900}, {{"a", "b"}, {"c", "d"}, {"e", "f"}}};
    const TransferTable table = bakeTransfer(layer, *rampOf16Bit(0, 1000));
    EXPECT_EQ(table.axisX, TransferAxis::value);
    EXPECT_EQ(table.axisY, TransferAxis::gradient);
    ASSERT_EQ(table.opacity.size(), 1001U);
    for (std::size_t k = 0; k < 1001; k += 7) {
        for (std::size_t row = 0; row < 256; row += 3) {
            const double exact =
                0.75 * opacity2dAt(layer.transfer, static_cast<double>(row) / 255, static_cast<double>(k));
            ASSERT_EQ(table.opacity2d[row * 1001 + k], static_cast<float>(exact)) << k << " " << row;
        }
    }
    EXPECT_EQ(table.index[300], 0.5F);
    EXPECT_EQ(table.nodesX, 3);
    EXPECT_EQ(table.nodesY, 2);
    // Nodes are counted in the document's order: cell (gradient 1, value 2) is "f", the sixth.
    EXPECT_EQ(2 * table.nodeStrideX + 1 * table.nodeStrideY, 5);
    EXPECT_EQ(2 * table.nodeStrideX + 0 * table.nodeStrideY, 4);
}

TEST(BakePlane, LabelsAreRowsWhicheverAxisTheyAre) {
    Layer layer;
    layer.transfer =
        planeOf({"value", "label"}, {shapeOf("rectangle", {0, 50}, {-1, 3}), shapeOf("rectangle", {20, 100}, {5, 5})});
    layer.transfer.opacity2d[0].opacity = 0.5;
    layer.transfer.opacity = {{0, 0}, {100, 1}};
    layer.transfer.grid = TransferGrid{{0, 100}, {3, 5, 9.2}, {{"a", "b"}, {"c", "d"}, {"e", "f"}}};
    const auto volume = rampOf16Bit(0, 100);
    const TransferTable table = bakeTransfer(layer, *volume);
    EXPECT_EQ(table.axisX, TransferAxis::value);
    EXPECT_EQ(table.axisY, TransferAxis::label);
    EXPECT_EQ(table.labels, (std::vector<int>{-1, 3, 5, 9}));
    EXPECT_EQ(table.rows, 4);
    EXPECT_EQ(table.rowIndex, (std::vector<float>{0, 0, 1, 2}));
    const std::size_t entries = table.opacity.size();
    ASSERT_EQ(table.opacity2d.size(), 4 * entries);
    const std::size_t at40 = 40 * (entries - 1) / 100;
    EXPECT_EQ(table.opacity2d[at40], 0); // -1 has no position: all other labels are invisible, shapes or not
    EXPECT_FLOAT_EQ(table.opacity2d[entries + at40], 0.4F * 0.5F);
    EXPECT_FLOAT_EQ(table.opacity2d[2 * entries + at40], 0.4F);
    EXPECT_EQ(table.opacity2d[3 * entries + at40], 0);
    EXPECT_FLOAT_EQ(table.opacity[at40], 0.4F);
    EXPECT_EQ(opacity2dAt(layer.transfer, 40, 2), 0); // label 2 has no position
    EXPECT_EQ(opacity2dAt(layer.transfer, 40, 3), 0.4 * 0.5);

    layer.transfer.grid->y[0] = -1; // now label 3 is one of the others
    const TransferTable others = bakeTransfer(layer, *volume);
    EXPECT_EQ(others.labels, (std::vector<int>{-1, 5, 9}));
    EXPECT_FLOAT_EQ(others.opacity2d[at40], 0.4F * 0.5F);
    EXPECT_EQ(opacity2dAt(layer.transfer, 40, 2), 0.4 * 0.5);
    EXPECT_EQ(opacity2dAt(layer.transfer, 40, 77), 0.4 * 0.5);

    Layer turned = layer;
    turned.transfer.axes = {"label", "value"};
    for (OpacityShape& shape : turned.transfer.opacity2d) {
        std::swap(shape.x, shape.y);
    }
    turned.transfer.opacity = {{-1, 0.25}, {5, 1}}; // along the labels
    turned.transfer.grid = TransferGrid{{-1, 5, 9}, {0, 100}, {{"a", "c", "e"}, {"b", "d", "f"}}};
    const TransferTable swapped = bakeTransfer(turned, *volume);
    EXPECT_EQ(swapped.axisX, TransferAxis::value);
    EXPECT_EQ(swapped.axisY, TransferAxis::label);
    EXPECT_EQ(swapped.labels, others.labels);
    EXPECT_EQ(swapped.index, others.index);
    EXPECT_FLOAT_EQ(swapped.opacity2d[at40], 0.25F * 0.5F);
    EXPECT_FLOAT_EQ(swapped.opacity2d[entries + at40], 1);
    EXPECT_EQ(swapped.nodesX, 2);
    EXPECT_EQ(swapped.nodesY, 3);
    // Value 100 and label 9: "f", the last of the document's rows.
    EXPECT_EQ(1 * swapped.nodeStrideX + 2 * swapped.nodeStrideY, 5);
    EXPECT_EQ(0 * swapped.nodeStrideX + 1 * swapped.nodeStrideY, 1);
}

TEST(BakePlane, TheSameLabelTwiceIsOneRow) {
    Layer layer;
    layer.transfer = planeOf({"gradient", "label"}, {});
    layer.transfer.grid = TransferGrid{{0}, {2.9, 3.1, 1e300}, {{"a"}, {"b"}, {"c"}}};
    const TransferTable table = bakeTransfer(layer, *rampOf16Bit(0, 100));
    EXPECT_EQ(table.labels, (std::vector<int>{-1, 3}));
    EXPECT_EQ(table.rowIndex[1], 0);
    layer.transfer.grid.reset();
    EXPECT_EQ(bakeTransfer(layer, *rampOf16Bit(0, 100)).labels, std::vector<int>{-1});
}

TEST(BakeTransfer, OneDimensionOverOtherAxes) {
    Layer layer;
    layer.opacity = 0.5;
    layer.transfer.axis = "gradient";
    layer.transfer.opacity = {{0.25, 0}, {0.75, 1}};
    layer.transfer.nodes = {{0.2, "a", {}}, {0.6, "b", {}}};
    const auto volume = rampOf16Bit(-1000, 3000);
    const TransferTable table = bakeTransfer(layer, *volume);
    EXPECT_EQ(table.axisX, TransferAxis::gradient);
    EXPECT_EQ(table.low, 0);
    EXPECT_EQ(table.high, 1);
    EXPECT_EQ(table.rows, 0);
    EXPECT_EQ(table.nodesX, 2);
    EXPECT_EQ(table.nodesY, 1);
    ASSERT_EQ(table.opacity.size(), 4096U);
    for (std::size_t k = 0; k < 4096; ++k) {
        const double x = static_cast<double>(k) / 4095;
        ASSERT_EQ(table.opacity[k], static_cast<float>(0.5 * opacityAt(layer.transfer.opacity, x)));
        ASSERT_EQ(table.index[k], static_cast<float>(nodeIndexAt(layer.transfer.nodes, x)));
    }
    layer.transfer.axis = "distance";
    AxisRanges ranges;
    ranges.distance = {0, 45};
    EXPECT_EQ(bakeTransfer(layer, *volume, ranges).high, 45);
}

TEST(BakeTransfer, OneDimensionOverLabelsIsAPlane) {
    Layer layer;
    layer.opacity = 0.5;
    layer.transfer.axis = "label";
    layer.transfer.opacity = {{1, 0.25}, {5, 1}};
    layer.transfer.nodes = {{1, "a", {}}, {3, "b", {}}, {4, "a", {}}};
    const TransferTable table = bakeTransfer(layer, *rampOf16Bit(-1000, 3000));
    EXPECT_EQ(table.axisX, TransferAxis::value);
    EXPECT_EQ(table.axisY, TransferAxis::label);
    EXPECT_EQ(table.low, -1000);
    EXPECT_EQ(table.high, 3000);
    EXPECT_EQ(table.labels, (std::vector<int>{-1, 1, 3, 4}));
    EXPECT_EQ(table.rowIndex, (std::vector<float>{0, 0, 1, 2}));
    EXPECT_EQ(table.index, (std::vector<float>{0, 0}));
    EXPECT_EQ(table.opacity2d, (std::vector<float>{0, 0, 0.125F, 0.125F, 0.3125F, 0.3125F, 0.40625F, 0.40625F}));
    EXPECT_EQ(table.opacity, (std::vector<float>{0.40625F, 0.40625F}));
    EXPECT_EQ(table.nodesX, 1);
    EXPECT_EQ(table.nodesY, 3);
    EXPECT_EQ(table.nodeStrideY, 1);
    EXPECT_EQ(opacity2dAt(layer.transfer, 3, 0), 0.625);
    EXPECT_EQ(opacity2dAt(layer.transfer, 2, 0), 0); // no node of its own

    layer.transfer.nodes.insert(layer.transfer.nodes.begin(), {-1, "c", {}});
    const TransferTable others = bakeTransfer(layer, *rampOf16Bit(-1000, 3000));
    EXPECT_EQ(others.rowIndex, (std::vector<float>{0, 1, 2, 3}));
    EXPECT_EQ(others.opacity2d[0], 0.125F);
    EXPECT_EQ(opacity2dAt(layer.transfer, 2, 0), 0.25); // the curve at -1
}

TEST(IndexStyles, GridsHaveColoursAndStyles) {
    Figure figure;
    figure.styles.resize(1);
    figure.styles[0].id = "a";
    figure.styles[0].sphere = std::make_shared<const LitSphere>(4, std::vector<Rgba>(16, Rgba{0.25F, 0.25F, 0.25F, 1}));
    Transfer transfer = planeOf({"value", "label"}, {});
    transfer.grid = TransferGrid{{0, 1, 2}, {0, 1, 2}, {{"a", "#ff8000", "gone"}, {"#FF8000", "a", "#12345"}, {"a"}}};
    const StyleIndex index = indexStyles(figure, transfer);
    EXPECT_EQ(index.nodeToStyle, (std::vector<int>{0, 1, 2, 1, 0, 2, 0, 2, 2}));
    ASSERT_EQ(index.styles.size(), 3U);
    EXPECT_EQ(index.styles[0].sphere, figure.styles[0].sphere);
    EXPECT_EQ(index.styles[1].sphere, nullptr);
    EXPECT_EQ(index.styles[1].rgb, glm::dvec3(1, 128 / 255.0, 0));
    EXPECT_EQ(index.styles[2].rgb, glm::dvec3(0.5));
    transfer.grid.reset();
    EXPECT_EQ(indexStyles(figure, transfer).nodeToStyle, std::vector<int>{0});
}

} // namespace
} // namespace limner
