#include "core/figure/style_edits.h"

#include "core/figure/transfer_edits.h"
#include "core/style/style_library.h"
#include "core/style/texture_tile.h"

#include <gtest/gtest.h>

#include <filesystem>

#include <unistd.h>

namespace limner {
namespace {

namespace fs = std::filesystem;

std::shared_ptr<const TextureTile> tileOf(float factor) {
    return std::make_shared<const TextureTile>(16, std::vector<Rgba>(256, Rgba{factor, factor, factor, 1}));
}

Style own(const std::string& id, float grey) {
    Style style;
    style.card = {id, "Name of " + id, {}, "", "The maker", "CC0"};
    style.sphere = std::make_shared<const LitSphere>(16, std::vector<Rgba>(256, Rgba{grey, grey, grey, 1}));
    style.file = "/library/" + id + ".png";
    return style;
}

Figure oneLayer() {
    Figure figure;
    Layer layer;
    layer.transfer.nodes = {{100, "", glm::dvec3(1, 0, 0)}};
    layer.transfer.opacity = {{100, 0}, {300, 1}};
    figure.layers = {layer};
    return figure;
}

TEST(StyleEdits, AnOwnStyleJoinsWithAllThatIsKnownOfIt) {
    Figure figure;
    Style style = own("ochre", 0.5F);
    style.texture = tileOf(1.25F);
    EXPECT_EQ(joinStyle(figure, style), "ochre");
    ASSERT_EQ(figure.styles.size(), 1U);
    const StyleEntry& entry = figure.styles[0];
    EXPECT_EQ(entry.file, "/library/ochre.png");
    EXPECT_EQ(entry.name, "Name of ochre");
    EXPECT_EQ(entry.credit, "The maker");
    EXPECT_EQ(entry.licence, "CC0");
    EXPECT_EQ(entry.sphere, style.sphere);
    ASSERT_TRUE(entry.texture);
    EXPECT_EQ(entry.texture->file, "/library/ochre-texture.png");
    EXPECT_EQ(entry.texture->tile, style.texture);
    EXPECT_EQ(entry.texture->strength, 1);
}

TEST(StyleEdits, WhatLooksTheSameIsUsedAgainAndWhatDoesNotGetsANumber) {
    Figure figure;
    EXPECT_EQ(joinStyle(figure, own("ochre", 0.5F)), "ochre");
    EXPECT_EQ(joinStyle(figure, own("ochre", 0.5F)), "ochre") << "read from disk again";
    EXPECT_EQ(joinStyle(figure, own("ochre", 0.6F)), "ochre-2") << "same file, another picture by now";
    EXPECT_EQ(joinStyle(figure, own("ochre", 0.6F)), "ochre-2");
    EXPECT_EQ(joinStyle(figure, own("ochre", 0.7F)), "ochre-3");
    EXPECT_EQ(figure.styles.size(), 3U);
    Style moved = own("ochre", 0.7F);
    moved.file = "styles/ochre.png"; // of a project that it was saved in
    EXPECT_EQ(joinStyle(figure, moved), "ochre-3");
    Style nameless = own("", 0.8F);
    nameless.card.name = "Red clay";
    EXPECT_EQ(joinStyle(figure, nameless), "red-clay");
}

TEST(StyleEdits, ABundledStyleIsItsFileAlone) {
    const Style& bundled = *findBundledStyle("ivory-bone");
    Figure figure;
    Style own = bundled;
    own.file = "/library/ivory-bone.png";
    EXPECT_EQ(joinStyle(figure, own), "ivory-bone");
    EXPECT_EQ(joinStyle(figure, bundled), "ivory-bone-2") << "nothing in the figure stands for the bundled one";
    EXPECT_EQ(figure.styles[1].file, "bundled:ivory-bone");
    EXPECT_EQ(joinStyle(figure, bundled), "ivory-bone-2");
    EXPECT_EQ(joinStyle(figure, own), "ivory-bone");
}

TEST(StyleEdits, AnotherTextureIsAnotherStyle) {
    Figure figure;
    Style style = own("ochre", 0.5F);
    style.texture = tileOf(1.25F);
    joinStyle(figure, style);
    style.texture = tileOf(0.75F);
    EXPECT_EQ(joinStyle(figure, style), "ochre-2");
    figure.styles[0].texture.reset(); // taken off in the figure
    style.texture = tileOf(1.25F);
    EXPECT_EQ(joinStyle(figure, style), "ochre");
    EXPECT_FALSE(figure.styles[0].texture) << "and stays off";
}

TEST(StyleEdits, ACreditTypedInLaterIsTaken) {
    Figure figure;
    Style style = own("ochre", 0.5F);
    joinStyle(figure, style);
    style.card.credit = "E. Haeckel, 1904";
    joinStyle(figure, style);
    EXPECT_EQ(figure.styles[0].credit, "E. Haeckel, 1904");
}

TEST(StyleEdits, StylesOfTheProjectCanBeUsedAgain) {
    Figure figure;
    joinStyle(figure, *findBundledStyle("ivory-bone"));
    Style textured = own("ochre", 0.5F);
    textured.texture = tileOf(1.25F);
    joinStyle(figure, textured);
    figure.styles.push_back({"lost", "styles/lost.png", "Lost", "", "", nullptr});
    figure.styles.push_back({"plain", "styles/plain.png", "", "", "", own("x", 0.1F).sphere});
    const std::vector<Style> styles = projectStyles(figure);
    ASSERT_EQ(styles.size(), 2U);
    EXPECT_EQ(styles[0].card.id, "ochre");
    EXPECT_EQ(styles[0].card.credit, "The maker");
    EXPECT_EQ(styles[0].texture, textured.texture);
    EXPECT_EQ(styles[1].card.name, "plain");
    for (const Style& style : styles) {
        const Figure before = figure;
        EXPECT_EQ(joinStyle(figure, style), style.card.id);
        EXPECT_EQ(figure, before);
    }
}

TEST(StyleEdits, OneOfTwoThatLookAlikeKeepsItsOwnId) {
    Figure figure;
    figure.styles.push_back({"a", "styles/a.png", "A", "", "", own("x", 0.1F).sphere});
    figure.styles.push_back({"b", "styles/b.png", "B", "", "", own("x", 0.1F).sphere});
    EXPECT_EQ(joinStyle(figure, projectStyles(figure)[1]), "b");
}

TEST(StyleEdits, UnusedStylesLeaveWhereTheyHaveAHome) {
    Figure figure = withStyle(oneLayer(), 0, std::nullopt, own("ochre", 0.5F));
    figure.styles.push_back({"kept", "styles/kept.png", "", "", "", nullptr});
    figure.styles.push_back({"fresh", "", "", "", "", own("x", 0.3F).sphere});
    figure = withStyle(figure, 0, std::nullopt, own("umber", 0.2F));
    EXPECT_EQ(figure.layers[0].transfer.nodes[0].style, "umber");
    EXPECT_EQ(figure.findStyle("ochre"), nullptr) << "it is in the user's folder";
    EXPECT_NE(figure.findStyle("kept"), nullptr) << "the project may be all that holds it";
    EXPECT_NE(figure.findStyle("fresh"), nullptr);
    EXPECT_NE(figure.findStyle("umber"), nullptr);
}

TEST(StyleEdits, NamedStylesJoin) {
    const fs::path folder = fs::temp_directory_path() / ("limner-named-" + std::to_string(::getpid()));
    fs::remove_all(folder);
    const StyleLibrary mine(folder);
    Style ochre = own("ochre", 0.5F);
    mine.add(ochre);
    Figure figure = oneLayer();
    figure.layers[0].transfer.nodes = {{1, "ochre", std::nullopt},
                                       {2, (folder / "ochre.png").string(), std::nullopt},
                                       {3, "bundled:ivory-bone", std::nullopt},
                                       {4, "ivory-bone", std::nullopt},
                                       {5, "none-such", std::nullopt}};
    figure.layers[0].clip.emplace().face.emplace().style = "ochre";
    figure.clip.face.emplace().style = "ochre";
    joinNamedStyles(figure, mine);
    const TransferNodes& nodes = figure.layers[0].transfer.nodes;
    EXPECT_EQ(nodes[0].style, "ochre");
    EXPECT_EQ(nodes[1].style, "ochre");
    EXPECT_EQ(nodes[2].style, "ivory-bone");
    EXPECT_EQ(nodes[3].style, "ivory-bone");
    EXPECT_EQ(nodes[4].style, "none-such") << "left for validation to name";
    EXPECT_EQ(figure.clip.face->style, "ochre");
    EXPECT_EQ(figure.styles.size(), 2U);
    EXPECT_EQ(figure.findStyle("ochre")->file, (folder / "ochre.png").string());
    const Figure again = figure;
    joinNamedStyles(figure, mine);
    EXPECT_EQ(figure, again);
    fs::remove_all(folder);
}

} // namespace
} // namespace limner
