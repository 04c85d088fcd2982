#include "core/style/transfer_function.h"

#include "support/make_volume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace limner {
namespace {

using testing::gridOf;
using testing::makeVolume;

std::vector<TransferNode> nodesAt(std::initializer_list<double> values) {
    std::vector<TransferNode> nodes;
    for (const double value : values) {
        nodes.push_back({value, {}, glm::dvec3(value)});
    }
    return nodes;
}

std::shared_ptr<const Volume> rampOf16Bit(int low, int high) {
    return makeVolume<std::int16_t>(gridOf({2, 1, 1}), VoxelType::int16,
                                    [&](glm::ivec3 v) { return v.x == 0 ? low : high; });
}

/// What a renderer reads: linear between entries.
double read(const TransferTable& table, const std::vector<float>& entries, double s) {
    const double last = static_cast<double>(entries.size() - 1);
    const double position = std::clamp((s - table.low) / (table.high - table.low) * last, 0.0, last);
    const auto k = std::min(static_cast<std::size_t>(position), entries.size() - 2);
    const double weight = position - static_cast<double>(k);
    return entries[k] * (1 - weight) + entries[k + 1] * weight;
}

TEST(OpacityAt, LinearBetweenConstantOutside) {
    const std::vector<glm::dvec2> points{{100, 0.2}, {200, 0.6}, {400, 0.0}};
    EXPECT_EQ(opacityAt(points, -1e30), 0.2);
    EXPECT_EQ(opacityAt(points, 100), 0.2);
    EXPECT_EQ(opacityAt(points, 150), 0.2 + 0.5 * (0.6 - 0.2));
    EXPECT_EQ(opacityAt(points, 200), 0.6);
    EXPECT_DOUBLE_EQ(opacityAt(points, 350), 0.15);
    EXPECT_EQ(opacityAt(points, 400), 0.0);
    EXPECT_EQ(opacityAt(points, 1e30), 0.0);
    EXPECT_EQ(opacityAt({}, 0), 0.0);
    EXPECT_EQ(opacityAt({{5, 0.3}}, 5), 0.3);
    EXPECT_EQ(opacityAt({{5, 0.3}}, 4), 0.3);
}

TEST(OpacityAt, StepsAreRightContinuous) {
    const std::vector<glm::dvec2> points{{0, 0.1}, {300, 0.1}, {300, 0.5}, {300, 0.9}, {500, 0.9}};
    EXPECT_DOUBLE_EQ(opacityAt(points, std::nextafter(300, 0)), 0.1);
    EXPECT_EQ(opacityAt(points, 300), 0.9);
    // A step at the first and at the last point.
    EXPECT_EQ(opacityAt({{0, 0}, {0, 1}}, -1e-9), 0);
    EXPECT_EQ(opacityAt({{0, 0}, {0, 1}}, 0), 1);
    EXPECT_EQ(opacityAt({{0, 0}, {0, 1}}, 1), 1);
}

TEST(NodeIndexAt, FractionalBetweenNodes) {
    const auto nodes = nodesAt({-100, 100, 500});
    EXPECT_EQ(nodeIndexAt(nodes, -1000), 0);
    EXPECT_EQ(nodeIndexAt(nodes, -100), 0);
    EXPECT_EQ(nodeIndexAt(nodes, -50), 0.25);
    EXPECT_EQ(nodeIndexAt(nodes, 100), 1);
    EXPECT_EQ(nodeIndexAt(nodes, 400), 1.75);
    EXPECT_EQ(nodeIndexAt(nodes, 500), 2);
    EXPECT_EQ(nodeIndexAt(nodes, 9999), 2);
    EXPECT_EQ(nodeIndexAt({}, 7), 0);
    EXPECT_EQ(nodeIndexAt(nodesAt({3}), 7), 0);
}

TEST(NodeIndexAt, TwoNodesAtOneValueAreAStep) {
    const auto nodes = nodesAt({0, 100, 100, 200});
    EXPECT_NEAR(nodeIndexAt(nodes, std::nextafter(100, 0)), 1, 1e-12);
    EXPECT_EQ(nodeIndexAt(nodes, 100), 2);
    EXPECT_EQ(nodeIndexAt(nodes, 150), 2.5);
}

TEST(BakeTransfer, EntriesAreExactAndCoverTheUsedRange) {
    Layer layer;
    layer.opacity = 0.5;
    layer.transfer.nodes = nodesAt({-200, 50, 50, 1800});
    layer.transfer.opacity = {{-500, 0}, {130, 0}, {130, 0.8}, {900, 0.25}, {1200, 1}};
    const auto volume = rampOf16Bit(-1024, 3071);
    const TransferTable table = bakeTransfer(layer, *volume);
    EXPECT_EQ(table.low, -1024);
    EXPECT_EQ(table.high, 3071);
    ASSERT_EQ(table.opacity.size(), 4096U); // one per stored number
    ASSERT_EQ(table.index.size(), table.opacity.size());
    for (int k = 0; k < 4096; ++k) {
        const double s = k - 1024;
        const auto entry = static_cast<std::size_t>(k);
        ASSERT_EQ(table.opacity[entry], static_cast<float>(0.5 * opacityAt(layer.transfer.opacity, s))) << s;
        ASSERT_EQ(table.index[entry], static_cast<float>(nodeIndexAt(layer.transfer.nodes, s))) << s;
    }
    // A step stays a step to within one entry, on the right side.
    EXPECT_EQ(read(table, table.opacity, 129), 0);
    EXPECT_FLOAT_EQ(static_cast<float>(read(table, table.opacity, 130)), 0.4F);
    EXPECT_LT(read(table, table.index, 49), 1);
    EXPECT_EQ(read(table, table.index, 50), 2);
    EXPECT_EQ(table.nodeEntries, (std::vector<double>{824, 1074, 1074, 2824}));
}

TEST(BakeTransfer, SizesFollowTheData) {
    Layer layer;
    layer.transfer.opacity = {{0, 0}, {1, 1}};
    const auto entriesOf16Bit = [&](int low, int high) {
        return bakeTransfer(layer, *rampOf16Bit(low, high)).opacity.size();
    };
    EXPECT_EQ(entriesOf16Bit(0, 1), 4096U);
    EXPECT_EQ(entriesOf16Bit(0, 1000), 5001U); // five per stored number
    EXPECT_EQ(entriesOf16Bit(0, 5000), 5001U);
    EXPECT_EQ(entriesOf16Bit(-32768, 32767), 16384U);
    EXPECT_EQ(entriesOf16Bit(7, 7), 4096U);
    const auto bytes =
        makeVolume<std::uint8_t>(gridOf({256, 1, 1}), VoxelType::uint8, [](glm::ivec3 v) { return v.x; });
    const TransferTable table = bakeTransfer(layer, *bytes);
    EXPECT_EQ(table.opacity.size(), 1276U);
    EXPECT_EQ(table.opacity[5], 1); // value 1, where the curve has its corner
    const auto floats =
        makeVolume<float>(gridOf({5, 1, 1}), VoxelType::float32, [](glm::ivec3 v) { return v.x * 0.25; });
    EXPECT_GE(bakeTransfer(layer, *floats).opacity.size(), 4096U);
}

TEST(BakeTransfer, TakesAsManyEntriesAsAreAskedFor) {
    Layer layer;
    layer.transfer.opacity = {{0, 0}, {1, 1}};
    const auto volume = rampOf16Bit(0, 5000);
    for (const int entries : {2, 256, 1024, 20000}) {
        const TransferTable table = bakeTransfer(layer, *volume, {}, entries);
        EXPECT_EQ(table.opacity.size(), static_cast<std::size_t>(entries));
        EXPECT_EQ(table.index.size(), static_cast<std::size_t>(entries));
        EXPECT_EQ(table.high, 5000);
    }
    EXPECT_EQ(bakeTransfer(layer, *volume, {}, 1).opacity.size(), 2U); // a line has two ends
    EXPECT_EQ(bakeTransfer(layer, *volume, {}, 0).opacity.size(), bakeTransfer(layer, *volume).opacity.size());
    layer.transfer.kind = TransferKind::twoDimensional;
    layer.transfer.axes = {"value", "gradient"};
    EXPECT_EQ(bakeTransfer(layer, *volume, {}, 100).opacity.size(), 100U);
    EXPECT_EQ(bakeTransfer(layer, *volume, {}, 1 << 20).opacity.size(), 2048U); // a plane has no more
}

TEST(BakeTransfer, ErrorFallsWithTheNumberOfEntries) {
    Layer layer;
    layer.transfer.curve = OpacityCurve::smooth;
    layer.transfer.opacity = {{310, 0}, {1700, 0.8}, {2600, 0.2}, {4400, 0.9}};
    layer.transfer.nodes = nodesAt({0, 5000});
    const auto volume = rampOf16Bit(0, 5000);
    const auto error = [&](int entries) {
        const TransferTable table = bakeTransfer(layer, *volume, {}, entries);
        double most = 0;
        for (double s = 0; s <= 5000; s += 3.7) {
            most = std::max(most, std::abs(read(table, table.opacity, s) - curveOpacityAt(layer.transfer, s)));
        }
        return most;
    };
    double before = error(32);
    for (const int entries : {128, 512, 2048}) { // linear between entries: a sixteenth for four times as many
        const double now = error(entries);
        EXPECT_LT(now, before / 8) << entries;
        before = now;
    }
    EXPECT_GT(error(32), 1e-3); // it can be seen
    EXPECT_LT(before, 1e-5);
}

TEST(BakeTransfer, StepAtEveryStoredNumberOfScaledDataFallsOnItsEntry) {
    // Slope and intercept as CT files have them; the number of entries per stored number is odd.
    const auto volume = makeVolume<std::int16_t>(
        gridOf({2, 1, 1}), VoxelType::int16, [](glm::ivec3 v) { return v.x == 0 ? 0 : 700; }, 2, -1000);
    for (int stored = 1; stored <= 700; ++stored) {
        const double s = 2.0 * stored - 1000;
        Layer layer;
        layer.transfer.opacity = {{s, 0}, {s, 1}};
        const TransferTable table = bakeTransfer(layer, *volume);
        const std::size_t perNumber = (table.opacity.size() - 1) / 700;
        ASSERT_EQ(table.opacity[static_cast<std::size_t>(stored) * perNumber], 1) << s;
        ASSERT_EQ(table.opacity[static_cast<std::size_t>(stored) * perNumber - 1], 0) << s;
    }
}

TEST(BakeTransfer, ConstantAndHugeRangesStayFinite) {
    Layer layer;
    layer.transfer.opacity = {{-1, 0.25}, {1, 0.75}};
    layer.transfer.nodes = nodesAt({0, 1e38});
    const auto constant = bakeTransfer(layer, *rampOf16Bit(40, 40));
    EXPECT_GT(constant.high, constant.low);
    EXPECT_EQ(constant.opacity.front(), 0.75F);
    auto huge = makeVolume<float>(
        gridOf({2, 1, 1}), VoxelType::float32, [](glm::ivec3 v) { return v.x; }, 1e308, 0);
    for (const float value : bakeTransfer(layer, *huge).index) {
        ASSERT_TRUE(std::isfinite(value));
    }
}

std::shared_ptr<const LitSphere> plainSphere(float grey) {
    return std::make_shared<const LitSphere>(4, std::vector<Rgba>(16, Rgba{grey, grey, grey, 1}));
}

TEST(IndexStyles, DistinctStylesAreFewerThanNodes) {
    Figure figure;
    figure.styles.resize(2);
    figure.styles[0].id = "a";
    figure.styles[0].sphere = plainSphere(0.25F);
    figure.styles[1].id = "b";
    figure.styles[1].sphere = plainSphere(0.75F);
    Transfer transfer;
    const glm::dvec3 red(1, 0, 0);
    transfer.nodes = {{0, "a", {}}, {1, "", red}, {2, "b", {}}, {3, "a", {}}, {4, "", red}, {5, "gone", {}}};
    const StyleIndex index = indexStyles(figure, transfer);
    EXPECT_EQ(index.nodeToStyle, (std::vector<int>{0, 1, 2, 0, 1, 3}));
    ASSERT_EQ(index.styles.size(), 4U);
    EXPECT_EQ(index.styles[0].sphere, figure.styles[0].sphere);
    EXPECT_EQ(index.styles[0].rgb, glm::dvec3(0.25));
    EXPECT_EQ(index.styles[1].sphere, nullptr);
    EXPECT_EQ(index.styles[1].rgb, red);
    EXPECT_EQ(index.styles[2].rgb, glm::dvec3(0.75));
    EXPECT_EQ(index.styles[3].sphere, nullptr);
    EXPECT_EQ(index.styles[3].rgb, glm::dvec3(0.5));
}

TEST(IndexStyles, TwoIdsOfOnePictureAreOneStyle) {
    Figure figure;
    figure.styles.resize(3);
    figure.styles[0].id = "a";
    figure.styles[1].id = "b";
    figure.styles[0].sphere = figure.styles[1].sphere = plainSphere(0.5F);
    figure.styles[2].id = "unresolved";
    Transfer transfer;
    transfer.nodes = {{0, "a", {}}, {1, "b", {}}, {2, "unresolved", {}}, {3, "", glm::dvec3(0.5)}};
    EXPECT_EQ(indexStyles(figure, transfer).nodeToStyle, (std::vector<int>{0, 0, 1, 1}));
    EXPECT_EQ(indexStyles(figure, Transfer{}).nodeToStyle, std::vector<int>{0});
}

} // namespace
} // namespace limner
