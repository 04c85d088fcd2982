#include "renderer/plan/planner.h"

#include "core/base/error.h"
#include "core/volume/phantom.h"
#include "renderer/backend.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace limner {
namespace {

std::shared_ptr<const LitSphere> greyBall() {
    std::vector<Rgba> pixels;
    for (int i = 0; i < 32 * 32; ++i) {
        const float tone = static_cast<float>(i) / (32 * 32);
        pixels.push_back({tone, tone, tone, 1});
    }
    return std::make_shared<const LitSphere>(32, pixels);
}

Figure headFigure() {
    static const auto head = makeHeadPhantom(48);
    Figure figure;
    figure.volume.emplace();
    figure.volume->data = head;
    figure.camera.targetMm = head->grid().centreMm();
    figure.styles.push_back({.id = "ball", .file = "", .name = "", .credit = "", .licence = "", .sphere = greyBall()});
    Layer layer;
    layer.transfer.nodes = {{0, "ball", {}}, {1000, "ball", {}}};
    layer.transfer.opacity = {{200, 0}, {400, 1}};
    figure.layers.push_back(layer);
    return figure;
}

class PlannerTest : public ::testing::Test {
  protected:
    std::shared_ptr<const RenderPlan> plan(const Figure& figure) {
        PlanRequest request;
        request.size = {64, 64};
        return planner_.plan(figure, request, task_);
    }
    std::string refusal(const Figure& figure) {
        try {
            plan(figure);
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::badInput);
            return error.text().where;
        }
        return "drawn";
    }
    Planner planner_;
    Task task_;
};

bool names(const std::vector<PlanFeature>& features, const std::string& name) {
    return std::any_of(features.begin(), features.end(), [&](const PlanFeature& f) { return f.name == name; });
}

TEST_F(PlannerTest, AnEditOfOpacityAloneKeepsGridsAndAtlas) {
    Figure figure = headFigure();
    const auto before = plan(figure);
    figure.layers[0].transfer.opacity[1].y = 0.5;
    const auto after = plan(figure);
    EXPECT_EQ(before->skip, after->skip);
    EXPECT_EQ(before->atlas, after->atlas);
    EXPECT_EQ(before->volume, after->volume);
    figure.layers[0].transfer.opacity[0].x = -500; // more of the head shows
    EXPECT_NE(plan(figure)->skip, before->skip);
}

TEST_F(PlannerTest, PartsThatAreNotUsedAreNotInThePlan) {
    Figure figure = headFigure();
    const auto styled = plan(figure);
    EXPECT_TRUE(names(styled->featuresUsed, "lit-sphere styles"));
    EXPECT_TRUE(names(styled->featuresNotAsked, "Phong shading"));
    EXPECT_TRUE(names(styled->featuresNotAsked, "perspective"));
    figure.layers[0].shading = Shading::phong;
    const auto phong = plan(figure);
    EXPECT_EQ(phong->atlas, nullptr);
    EXPECT_TRUE(names(phong->featuresNotAsked, "lit-sphere styles"));
    figure.layers[0].visible = false;
    EXPECT_TRUE(plan(figure)->layers.empty());
    EXPECT_EQ(makeCpuBackend()->render(*plan(figure), {{0, 0}, {64, 64}}, task_).samples, 0U);
}

TEST_F(PlannerTest, SaysWhetherStylesHaveMipLevels) {
    Figure figure = headFigure();
    EXPECT_TRUE(names(plan(figure)->featuresNotAsked, "mip levels of styles")); // orthographic: one serves all
    figure.camera.projection = Projection::perspective;
    figure.camera.heightMm = 960; // pixels of three voxels
    const auto far = plan(figure);
    EXPECT_TRUE(names(far->featuresUsed, "mip levels of styles"));
    EXPECT_EQ(far->atlas->levelStart.size(), far->atlas->pictures.size());
    figure.camera.heightMm = 120; // of a third
    EXPECT_FALSE(names(plan(figure)->featuresNotAsked, "mip levels of styles"));
    EXPECT_FALSE(plan(figure)->mipLevels);
    figure.layers[0].shading = Shading::phong;
    figure.camera.heightMm = 960;
    EXPECT_TRUE(names(plan(figure)->featuresNotAsked, "mip levels of styles"));
}

TEST_F(PlannerTest, HiddenLayersAreInNoPlan) {
    Figure figure = headFigure();
    figure.layers.push_back(figure.layers[0]);
    figure.layers[0].visible = false;
    figure.layers[1].opacity = 0;
    PlanRequest request;
    request.size = {64, 64};
    EXPECT_TRUE(planner_.plan(figure, request, task_)->layers.empty());
    request.omit = false;
    EXPECT_EQ(planner_.plan(figure, request, task_)->layers.size(), 1U);
}

TEST_F(PlannerTest, PlainColoursInAStyleLayerAreFlatUnlessAStyleIsThere) {
    Figure figure = headFigure();
    figure.layers[0].transfer.nodes = {{0, "", glm::dvec3(1, 0, 0)}, {1000, "", glm::dvec3(0, 1, 0)}};
    EXPECT_EQ(plan(figure)->layers[0].shading, Shading::flat);
    figure.layers[0].transfer.nodes[1] = {1000, "ball", {}};
    const auto mixed = plan(figure);
    EXPECT_EQ(mixed->layers[0].shading, Shading::style);
    EXPECT_EQ(mixed->atlas->slots, 2);
}

TEST_F(PlannerTest, CamerasThatSeeNothingAreRefusedByName) {
    const auto with = [](auto change) {
        Figure figure = headFigure();
        change(figure.camera);
        return figure;
    };
    EXPECT_EQ(refusal(with([](Camera& c) { c.direction = {0, 0, 0}; })), "/camera/direction");
    EXPECT_EQ(refusal(with([](Camera& c) { c.up = c.direction * -2.0; })), "/camera/up");
    EXPECT_EQ(refusal(with([](Camera& c) { c.heightMm = 0; })), "/camera/height_mm");
    EXPECT_EQ(refusal(with([](Camera& c) {
                  c.projection = Projection::perspective;
                  c.fovDeg = 180;
              })),
              "/camera/fov_deg");
    Figure empty = headFigure();
    empty.volume.reset();
    EXPECT_EQ(refusal(empty), "/volume");
}

} // namespace
} // namespace limner
