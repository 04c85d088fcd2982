#include "renderer/style_target.h"

#include "core/figure/transfer_edits.h"
#include "support/make_volume.h"
#include "support/rendering.h"

#include <cmath>

namespace limner {
namespace {

constexpr glm::ivec2 kSize{40, 40};
constexpr int kFront = 6; ///< voxels of skin along the view, 1 mm each
/// Skin counts from 25 to 75: from half way between air and skin to a tenth of the way to bone of 300.
constexpr double kSkinMm = 5.6;
constexpr double kStep = 0.1;
/// Bone is clear enough that its inside is seen, not only the slope that leads to it.
constexpr double kBone = 0.3;

/// Seen from the front, one pixel a voxel: skin of 50 from y = 10 on, `kFront` thick, and behind it bone of three kinds
/// side by side: 150 on the picture's right, 300 in the middle, 500 on the left (the patient's left is on the right).
/// Above z = 30 there is nothing.
std::shared_ptr<const Volume> slabs() {
    return testing::makeVolume<std::int16_t>(testing::gridOf({40, 40, 40}), VoxelType::int16, [](glm::ivec3 v) {
        if (v.z >= 30 || v.y < 10 || v.y >= 30) {
            return 0;
        }
        return v.y < 10 + kFront ? 50 : v.x < 13 ? 500 : v.x < 27 ? 300 : 150;
    });
}

/// Skin in one plain colour, `opacity` a mm; bone with a node for each kind.
Figure twoLayers(double opacity) {
    Figure figure;
    figure.volume = VolumeReference{};
    figure.volume->data = slabs();
    figure.camera.targetMm = figure.volume->data->grid().centreMm();
    figure.camera.heightMm = 40;
    Layer skin;
    skin.name = "Skin";
    skin.shading = Shading::flat;
    skin.transfer.nodes = {{50, "", glm::dvec3(0.9, 0.6, 0.5)}};
    skin.transfer.opacity = {{25, 0}, {25, opacity}, {75, opacity}, {75, 0}};
    Layer bone = skin;
    bone.name = "Bone";
    bone.transfer.nodes = {{150, "", glm::dvec3(1)}, {300, "", glm::dvec3(0.9)}, {500, "", glm::dvec3(0.8)}};
    bone.transfer.opacity = {{100, 0}, {100, kBone}, {600, kBone}};
    figure.layers = {skin, bone};
    figure.quality.stepVoxels = kStep;
    return figure;
}

std::shared_ptr<const RenderPlan> planned(const Figure& figure) {
    PlanRequest request;
    request.size = kSize;
    return testing::planOf(figure, request);
}

std::optional<StyleTarget> targetAt(const Figure& figure, const glm::dvec2& pixel) {
    return styleTarget(*planned(figure), pixel);
}

TEST(StyleTarget, IsTheLayerThatMakesMostOfThePixel) {
    const double boneAlone = 1 - std::pow(1 - kBone, 14.3); // from 100 on its way up to 100 on its way down
    const double even = 1 - std::pow(boneAlone / (1 + boneAlone), 1 / kSkinMm); // skin hides as much as bone shows
    const double tolerance = 0.01;                                              // a step's share of the skin
    const auto bone = targetAt(twoLayers(even * 0.95), {20, 25});
    ASSERT_TRUE(bone);
    EXPECT_EQ(bone->layer, 1U);
    EXPECT_NEAR(bone->share, boneAlone * std::pow(1 - even * 0.95, kSkinMm), tolerance);
    const auto skin = targetAt(twoLayers(even * 1.05), {20, 25});
    ASSERT_TRUE(skin);
    EXPECT_EQ(skin->layer, 0U);
    EXPECT_NEAR(skin->share, 1 - std::pow(1 - even * 1.05, kSkinMm), tolerance);
    EXPECT_EQ(skin->node, 0U);
    EXPECT_DOUBLE_EQ(skin->value, 50);
    EXPECT_EQ(skin->range.low, 25) << "as far as the layer is visible";
    EXPECT_EQ(skin->range.high, 75);
}

TEST(StyleTarget, IsTheNodeThatGovernsTheValuesThere) {
    const Figure figure = twoLayers(0.01);
    struct Expected {
        double pixel;
        std::size_t node;
        double value;
        double low;
        double high;
    };
    for (const Expected& e : {Expected{35, 0, 150, 100, 225}, {20, 1, 300, 225, 400}, {5, 2, 500, 400, 500}}) {
        // on either side, as the patient's left may be
        const auto target = targetAt(figure, {e.pixel, 25});
        ASSERT_TRUE(target);
        EXPECT_EQ(target->layer, 1U);
        EXPECT_EQ(target->node, e.node) << e.pixel;
        EXPECT_NEAR(target->value, e.value, 1) << e.pixel;
        EXPECT_EQ(target->range.low, e.low);
        EXPECT_EQ(target->range.high, e.high) << "no farther than the data";
    }
}

TEST(StyleTarget, IsNothingOnPaperAndCountsWhatIsDrawnAlone) {
    Figure figure = twoLayers(0.01);
    EXPECT_FALSE(targetAt(figure, {20, 3}));
    EXPECT_FALSE(targetAt(figure, {-5, 20}));
    figure.layers[1].visible = false;
    const auto skin = targetAt(figure, {20, 25});
    ASSERT_TRUE(skin) << "a veil of six hundredths";
    EXPECT_EQ(skin->layer, 0U);
    figure.layers[0].opacity = 0.1;
    EXPECT_FALSE(targetAt(figure, {20, 25})) << "hardly anything";
}

/// The index is the figure's, whatever the plan leaves out.
TEST(StyleTarget, CountsLayersAsTheFigureDoes) {
    Figure figure = twoLayers(0.01);
    figure.layers.insert(figure.layers.begin(), figure.layers.front());
    figure.layers.front().visible = false;
    figure.layers[1].opacity = 0;
    EXPECT_EQ(targetAt(figure, {20, 25})->layer, 2U);
}

TEST(StyleTarget, IsACellOfAPlanesGrid) {
    Figure figure = twoLayers(0.01);
    Transfer& transfer = figure.layers[1].transfer;
    transfer.kind = TransferKind::twoDimensional;
    transfer.axes = {"value", "gradient"};
    transfer.nodes.clear();
    transfer.grid = TransferGrid{{150, 300, 500}, {0, 1}, {{"a", "b", "c"}, {"d", "e", "f"}}};
    const auto flat = targetAt(figure, {20, 25});
    ASSERT_TRUE(flat);
    EXPECT_EQ(styleNodes(transfer), 6U);
    ASSERT_TRUE(flat->node);
    EXPECT_EQ(*flat->node % 3, 1U) << "the middle column";
    EXPECT_NEAR(flat->value, 300, 150);
    transfer.grid.reset();
    const auto whole = targetAt(figure, {20, 25});
    ASSERT_TRUE(whole);
    EXPECT_FALSE(whole->node);
}

TEST(StyleTarget, ALabelledPartIsMeantAlone) {
    Figure figure = twoLayers(0.01);
    figure.labels = LabelReference{};
    figure.labels->data = testing::makeVolume<std::uint8_t>(figure.volume->data->grid(), VoxelType::uint8,
                                                            [](glm::ivec3 v) { return v.x < 20 ? 3 : 7; });
    Transfer& transfer = figure.layers[1].transfer;
    transfer.kind = TransferKind::twoDimensional;
    transfer.axes = {"value", "label"};
    transfer.nodes.clear();
    transfer.grid = TransferGrid{{0}, {-1, 3, 7}, {{"#808080"}, {"#ff8080"}, {"#80ff80"}}};
    const auto left = targetAt(figure, {8, 25});
    const auto right = targetAt(figure, {32, 25});
    ASSERT_TRUE(left && right);
    EXPECT_EQ(left->node, 1U);
    EXPECT_EQ(right->node, 2U);
}

/// An opaque surface is seen at the values that lead to it.
TEST(StyleTarget, AnOpaqueSurfaceIsSeenWhereItBegins) {
    Figure figure = twoLayers(0.01);
    figure.layers[1].transfer.opacity = {{100, 0}, {100, 1}, {600, 1}};
    const auto target = targetAt(figure, {5, 25});
    ASSERT_TRUE(target);
    EXPECT_EQ(target->node, 0U) << "the first one above 100, whatever lies behind";
    EXPECT_NEAR(target->value, 100, kStep * 450);
}

/// A thin bright part behind a thick veil is what importance is for.
TEST(StyleTarget, CountsImportanceAsThePictureDoes) {
    Figure figure = twoLayers(0.2);
    EXPECT_EQ(targetAt(figure, {20, 25})->layer, 0U);
    figure.importance.emplace();
    figure.importance->global = 1;
    figure.importance->weights.intensity = 40;
    EXPECT_EQ(targetAt(figure, {20, 25})->layer, 1U);
}

/// Red over red and green is the share that the ray finds.
TEST(TargetMap, IsRedByTheShareThatIsMeant) {
    Figure figure = twoLayers(0.08);
    figure.layers[0].tone.emplace();
    figure.layers[1].specular.emplace();
    figure.background.rgba = {0, 0, 1, 1};
    const auto shareAt = [&](std::size_t layer, std::optional<std::size_t> node, int x) {
        const Picture picture = testing::renderWhole(*makeCpuBackend(), *planned(targetMap(figure, layer, node)));
        const float* pixel = picture.pixel(x, 25);
        return static_cast<double>(pixel[0]) / (pixel[0] + pixel[1]);
    };
    const double skin = 1 - std::pow(1 - 0.08, kSkinMm);
    const double bone = std::pow(1 - 0.08, kSkinMm) * (1 - std::pow(1 - kBone, 14.3));
    EXPECT_NEAR(shareAt(0, std::nullopt, 20), skin / (skin + bone), 0.01);
    EXPECT_NEAR(shareAt(1, std::nullopt, 20), bone / (skin + bone), 0.01);
    EXPECT_GT(shareAt(1, 1, 20), 0.6 * shareAt(1, std::nullopt, 20));
    EXPECT_LT(shareAt(1, 2, 20), 0.01) << "no value there is near it";
    EXPECT_NEAR(shareAt(1, 0, 20) + shareAt(1, 1, 20) + shareAt(1, 2, 20), bone / (skin + bone), 0.01)
        << "nodes share their layer";
}

} // namespace
} // namespace limner
