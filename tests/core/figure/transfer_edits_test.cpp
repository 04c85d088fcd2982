#include "core/figure/transfer_edits.h"

#include "core/style/lit_sphere.h"
#include "core/style/texture_tile.h"
#include "core/style/transfer_function.h"

#include <gtest/gtest.h>

#include <random>

namespace limner {
namespace {

Style styleNamed(const std::string& id) {
    Style style;
    style.card.id = id;
    style.card.name = id;
    style.file = "bundled:" + id;
    style.sphere = std::make_shared<const LitSphere>(4, std::vector<Rgba>(16));
    return style;
}

Figure twoLayers() {
    Figure figure;
    figure.styles = {{"ivory", "bundled:ivory", "", "", "", nullptr}, {"own", "styles/own.png", "", "", "", nullptr}};
    Layer layer;
    layer.transfer.nodes = {{100, "ivory", std::nullopt}, {200, "", glm::dvec3(1, 0, 0)}};
    layer.transfer.opacity = {{100, 0}, {300, 1}};
    layer.shading = Shading::phong;
    figure.layers = {layer, Layer{}};
    return figure;
}

TEST(TransferEdits, PointsKeepTheirOrderUnderAnyMoves) {
    OpacityPoints points{{0, 0}, {10, 0.5}, {20, 1}, {30, 0.2}};
    std::mt19937 random(5);
    std::uniform_real_distribution<double> value(-50, 80);
    std::uniform_real_distribution<double> opacity(-1, 2);
    for (int i = 0; i < 2000; ++i) {
        points = withPointMoved(points, random() % points.size(), {value(random), opacity(random)});
        for (std::size_t k = 0; k < points.size(); ++k) {
            EXPECT_GE(points[k].y, 0);
            EXPECT_LE(points[k].y, 1);
            if (k > 0) {
                EXPECT_GE(points[k].x, points[k - 1].x);
            }
        }
    }
}

TEST(TransferEdits, APointOnTheCurveChangesNothingThatIsDrawn) {
    const OpacityPoints points{{0, 0}, {10, 0.5}, {10, 0.8}, {20, 1}};
    for (const double at : {-5.0, 4.0, 15.0, 25.0}) {
        const AddedPoint added = withPointAdded(points, {at, opacityAt(points, at)});
        EXPECT_EQ(added.points[added.index].x, at);
        for (double s = -10; s <= 30; s += 0.25)
            EXPECT_NEAR(opacityAt(added.points, s), opacityAt(points, s), 1e-12);
        EXPECT_EQ(withPointRemoved(added.points, added.index), points);
    }
}

TEST(TransferEdits, AStepJumpsOnce) {
    const OpacityPoints points{{0, 0.2}, {10, 0.9}};
    const OpacityPoints stepped = withStepAt(points, 1);
    EXPECT_EQ(opacityAt(stepped, 9.99), 0.2);
    EXPECT_EQ(opacityAt(stepped, 10), 0.9);
    EXPECT_EQ(withStepAt(stepped, 1), stepped);
    EXPECT_EQ(withStepAt(stepped, 2), stepped);
    EXPECT_EQ(withStepAt(points, 0), (OpacityPoints{{0, 0}, {0, 0.2}, {10, 0.9}}));
}

TEST(TransferEdits, AStyleGoesOntoOneNodeOrAll) {
    const Figure figure = twoLayers();
    const Figure one = withStyle(figure, 0, 1, styleNamed("ink"));
    EXPECT_EQ(one.layers[0].transfer.nodes[0].style, "ivory");
    EXPECT_EQ(one.layers[0].transfer.nodes[1].style, "ink");
    EXPECT_FALSE(one.layers[0].transfer.nodes[1].rgb);
    EXPECT_EQ(one.layers[0].shading, Shading::style);
    const Figure all = withStyle(figure, 0, std::nullopt, styleNamed("ink"));
    EXPECT_EQ(all.layers[0].transfer.nodes[0].style, "ink");
    EXPECT_EQ(all.findStyle("ivory"), nullptr);
    EXPECT_NE(all.findStyle("own"), nullptr) << "a style of the user's own is never dropped";
    EXPECT_EQ(all.layers[1], figure.layers[1]);
}

TEST(TransferEdits, AStyleIsListedOnceAndNeverTakesAnothersName) {
    Figure figure = twoLayers();
    figure = withStyle(figure, 0, 0, styleNamed("own"));
    EXPECT_EQ(figure.layers[0].transfer.nodes[0].style, "own-2");
    EXPECT_EQ(figure.findStyle("own")->file, "styles/own.png");
    const std::size_t count = figure.styles.size();
    figure = withStyle(figure, 0, 1, styleNamed("own"));
    EXPECT_EQ(figure.styles.size(), count);
}

/// What the library on disk has comes with its path and its texture, leaves when nothing uses it, and is never mixed up
/// with a bundled style of that id.
TEST(TransferEdits, AStyleOfTheUsersOwnIsListedByItsFile) {
    Style chalk = styleNamed("chalk");
    const Figure bundled = withStyle(twoLayers(), 0, 0, chalk);
    chalk.file = "/styles/chalk.png";
    chalk.sphere = std::make_shared<const LitSphere>(8, std::vector<Rgba>(64));
    chalk.texture = std::make_shared<const TextureTile>(TextureTile(4, std::vector<Rgba>(16, Rgba{1, 1, 1, 1})));
    const Figure both = withStyle(bundled, 0, 1, chalk);
    EXPECT_EQ(both.layers[0].transfer.nodes[0].style, "chalk");
    EXPECT_EQ(both.layers[0].transfer.nodes[1].style, "chalk-2");
    const StyleEntry* entry = both.findStyle("chalk-2");
    ASSERT_NE(entry, nullptr);
    EXPECT_EQ(entry->file, "/styles/chalk.png");
    ASSERT_TRUE(entry->texture);
    EXPECT_EQ(entry->texture->file, "/styles/chalk-texture.png");
    EXPECT_EQ(entry->texture->tile, chalk.texture);
    const Figure again = withStyle(both, 0, 1, styleNamed("ink"));
    EXPECT_EQ(again.findStyle("chalk-2"), nullptr) << "the library has it";
}

TEST(TransferEdits, AStyleGoesOntoOneCellOfAPlaneOrAll) {
    Figure figure = twoLayers();
    Transfer& transfer = figure.layers[0].transfer;
    transfer.kind = TransferKind::twoDimensional;
    transfer.axes = {"value", "label"};
    transfer.grid = TransferGrid{{0, 100}, {-1, 5}, {{"ivory", "#ff0000"}, {"own", "own"}}};
    const Figure one = withStyle(figure, 0, 3, styleNamed("ink"));
    EXPECT_EQ(one.layers[0].transfer.grid->styles,
              (std::vector<std::vector<std::string>>{{"ivory", "#ff0000"}, {"own", "ink"}}));
    const Figure all = withStyle(figure, 0, std::nullopt, styleNamed("ink"));
    EXPECT_EQ(all.layers[0].transfer.grid->styles,
              (std::vector<std::vector<std::string>>{{"ink", "ink"}, {"ink", "ink"}}));
    EXPECT_EQ(all.layers[0].transfer.nodes, transfer.nodes) << "a plane does not read them";
    transfer.grid.reset();
    const Figure fresh = withStyle(figure, 0, std::nullopt, styleNamed("ink"));
    EXPECT_EQ(fresh.layers[0].transfer.grid, (TransferGrid{{0}, {-1}, {{"ink"}}}));
}

TEST(TransferEdits, ALayerWithoutNodesGetsOne) {
    const Figure figure = withStyle(twoLayers(), 1, std::nullopt, styleNamed("ink"));
    ASSERT_EQ(figure.layers[1].transfer.nodes.size(), 1U);
    EXPECT_EQ(figure.layers[1].transfer.nodes[0].style, "ink");
}

TEST(TransferEdits, NewNodesStandInOrder) {
    const Figure figure = withStyleNode(twoLayers(), 0, 150, styleNamed("ink"));
    ASSERT_EQ(figure.layers[0].transfer.nodes.size(), 3U);
    EXPECT_EQ(figure.layers[0].transfer.nodes[1].style, "ink");
    EXPECT_EQ(nodePlace(figure.layers[0].transfer.nodes, 99), 0U);
    EXPECT_EQ(nodePlace(figure.layers[0].transfer.nodes, 500), 3U);
}

} // namespace
} // namespace limner
