#include "core/figure/layer_edits.h"

#include "core/figure/figure_json.h"
#include "core/figure/light_frame.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace limner {
namespace {

Layer layerOf(const std::string& name, const std::string& style) {
    Layer layer;
    layer.name = name;
    layer.transfer.nodes = {{100, style, std::nullopt}};
    layer.transfer.opacity = {{100, 0}, {300, 1}};
    return layer;
}

Figure threeLayers() {
    Figure figure;
    for (const char* id : {"bone", "skin", "cut"})
        figure.styles.push_back({id, std::string("bundled:") + id, id, "", "", nullptr});
    figure.layers = {layerOf("Bone", "bone"), layerOf("Skin", "skin"), layerOf("Vessel", "skin")};
    return figure;
}

std::string names(const Figure& figure) {
    std::string text;
    for (const Layer& layer : figure.layers)
        text += layer.name + " ";
    return text;
}

TEST(LayerEdits, LayersMoveBothWaysAndBack) {
    const Figure figure = threeLayers();
    EXPECT_EQ(names(withLayerMoved(figure, 0, 2)), "Skin Vessel Bone ");
    EXPECT_EQ(names(withLayerMoved(figure, 2, 0)), "Vessel Bone Skin ");
    EXPECT_EQ(names(withLayerMoved(figure, 1, 1)), names(figure));
    for (std::size_t from = 0; from < 3; ++from)
        for (std::size_t to = 0; to < 3; ++to)
            EXPECT_EQ(withLayerMoved(withLayerMoved(figure, from, to), to, from), figure);
}

TEST(LayerEdits, ACopyIsFreeAndNamedApart) {
    Figure figure = threeLayers();
    figure.layers[1].locked = true;
    figure.layers[1].solo = true;
    const Figure twice = withLayerDuplicated(withLayerDuplicated(figure, 1), 1);
    EXPECT_EQ(names(twice), "Bone Skin Skin 3 Skin 2 Vessel ");
    EXPECT_FALSE(twice.layers[2].locked);
    EXPECT_FALSE(twice.layers[2].solo);
    EXPECT_EQ(twice.layers[2].transfer, figure.layers[1].transfer);
    EXPECT_TRUE(mayChange(twice, 2));
    EXPECT_FALSE(mayChange(twice, 1));
    EXPECT_FALSE(mayChange(twice, 5));
}

TEST(LayerEdits, ARemovedLayerTakesItsStylesWithItUnlessTheyAreUsed) {
    Figure figure = threeLayers();
    figure.layers[0].clip.emplace().face = CutFace{"cut", std::nullopt};
    const Figure withoutSkin = withLayerRemoved(figure, 1);
    EXPECT_EQ(names(withoutSkin), "Bone Vessel ");
    EXPECT_TRUE(withoutSkin.findStyle("skin")) << "the vessels draw with it";
    EXPECT_TRUE(withoutSkin.findStyle("cut")) << "the bone's cuts draw with it";
    EXPECT_FALSE(withLayerRemoved(withoutSkin, 1).findStyle("skin"));
}

TEST(LayerEdits, AFreshLayerIsValidWithAndWithoutStyles) {
    Figure figure = threeLayers();
    EXPECT_EQ(freshLayer(figure).transfer.nodes[0].style, "bone");
    figure = withLayerAdded(figure, 99, freshLayer(figure));
    EXPECT_EQ(names(figure), "Bone Skin Vessel Layer ");
    Figure empty;
    EXPECT_TRUE(freshLayer(empty).transfer.nodes[0].rgb);
    empty = withLayerAdded(empty, 0, freshLayer(empty));
    for (const Figure& checked : {figure, empty})
        for (const Problem& problem : validateFigure(checked))
            EXPECT_FALSE(problem.fatal) << problem.pointer << " " << problem.why;
}

TEST(LightFrame, ALightKeepsItsPlaceWhenItsKindChanges) {
    Camera camera;
    camera.direction = {0.4, 0.8, -0.2};
    const Light head{"head", {-2, 3, 4}};
    const glm::dvec3 seen = lightSeen(head, camera);
    EXPECT_NEAR(glm::length(seen), 1, 1e-12);
    EXPECT_GT(seen.z, 0) << "before the object";
    const Light fixed = lightToBeSeen("object", seen, camera);
    EXPECT_NEAR(glm::distance(lightSeen(fixed, camera), seen), 0, 1e-12);
    Camera front; // looks along +y, from the patient's front, who stands upright
    EXPECT_NEAR(glm::distance(lightToBeSeen("object", {1, 0, 0}, front).direction, {1, 0, 0}), 0, 1e-12);
    EXPECT_NEAR(glm::distance(lightToBeSeen("object", {0, 0, 1}, front).direction, {0, -1, 0}), 0, 1e-12);
    EXPECT_EQ(lightSeen({"head", {0, 0, 0}}, front), glm::dvec3(0, 0, 1));
}

} // namespace
} // namespace limner
