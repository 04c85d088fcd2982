#include "renderer/plan/plan_parts.h"
#include "support/make_volume.h"
#include "support/rendering.h"
#include "support/transfer_scenes.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <functional>

// What layers and their parts promise: how they compose, in closed form; that what changes nothing leaves no trace; cut
// faces that are flat. That the SIMD backend draws them as the reference does: transfer_agreement_test.cpp.

namespace limner {
namespace {

using testing::renderWhole;

constexpr int kVoxels = 12;
constexpr double kStep = 0.5;

Layer flatLayer(const glm::dvec3& rgb, double opacity) {
    Layer layer;
    layer.shading = Shading::flat;
    layer.transfer.nodes = {{0, "", rgb}};
    layer.transfer.opacity = {{0, opacity}};
    return layer;
}

/// A block of one value, 1 mm voxels, seen along y.
Figure blockFigure(const std::vector<Layer>& layers) {
    const Grid grid = accuracy::centredGrid(kVoxels, 1);
    Camera camera;
    camera.heightMm = 6;
    Figure figure = accuracy::plainFigure(
        testing::makeVolume<std::uint8_t>(grid, VoxelType::uint8, [](const glm::ivec3&) { return 100; }), camera);
    figure.layers = layers;
    figure.quality.stepVoxels = kStep;
    figure.quality.earlyTermination = 0;
    return figure;
}

Picture drawn(const Backend& backend, const Figure& figure, int size = 6) {
    PlanRequest request;
    request.size = {size, size};
    return renderWhole(backend, *testing::planOf(figure, request));
}

class LayersOfBlock : public testing::BackendTest {
  protected:
    void expectPixel(const Picture& picture, const glm::dvec4& expected) const {
        const float* pixel = picture.pixel(3, 2);
        for (int c = 0; c < 4; ++c) {
            EXPECT_NEAR(pixel[c], expected[c], rounding(2e-7, 3e-6)) << "channel " << c;
        }
    }
};
LIMNER_ON_EVERY_BACKEND(LayersOfBlock);

double ofStep(double opacity) { return 1 - std::pow(1 - opacity, kStep); }

/// Two layers at each of the block's samples, one composed after the other.
glm::dvec4 composed(const glm::dvec3& first, double a, const glm::dvec3& second, double b) {
    const double sample = 1 - (1 - ofStep(a)) * (1 - ofStep(b));
    const glm::dvec3 colour = ofStep(a) * first + (1 - ofStep(a)) * ofStep(b) * second;
    const double all = 1 - std::pow(1 - sample, kVoxels / kStep);
    return {colour * (all / sample), all};
}

TEST_P(LayersOfBlock, ComposeInTheirOrder) {
    const glm::dvec3 red(0.9, 0.1, 0.2);
    const glm::dvec3 blue(0.1, 0.3, 0.8);
    const Layer thin = flatLayer(red, 0.06);
    const Layer thick = flatLayer(blue, 0.4);
    expectPixel(drawn(backend(), blockFigure({thin, thick})), composed(red, 0.06, blue, 0.4));
    expectPixel(drawn(backend(), blockFigure({thick, thin})), composed(blue, 0.4, red, 0.06));
    const Layer wall = flatLayer(red, 1);
    expectPixel(drawn(backend(), blockFigure({wall, thick})), {red, 1});
    // A wall after the thick layer: the first sample is all there is to see.
    expectPixel(drawn(backend(), blockFigure({thick, wall})), {ofStep(0.4) * blue + (1 - ofStep(0.4)) * red, 1});
}

TEST_P(LayersOfBlock, WithoutOpacityAreNotThere) {
    const Layer thin = flatLayer({0.9, 0.1, 0.2}, 0.06);
    const Picture one = drawn(backend(), blockFigure({thin}));
    Layer none = flatLayer({0, 1, 0}, 0.7);
    none.opacity = 0;
    EXPECT_TRUE(testing::sameBits(one, drawn(backend(), blockFigure({none, thin}))));
    EXPECT_TRUE(testing::sameBits(one, drawn(backend(), blockFigure({thin, none}))));
    Layer hidden = flatLayer({0, 1, 0}, 0.7);
    hidden.visible = false;
    EXPECT_TRUE(testing::sameBits(one, drawn(backend(), blockFigure({hidden, thin}))));
    Layer solo = thin;
    solo.solo = true;
    hidden.visible = true;
    EXPECT_TRUE(testing::sameBits(one, drawn(backend(), blockFigure({hidden, solo}))));
}

TEST_P(LayersOfBlock, AreCutOneByOne) {
    // The first layer is cut away over the front third, whatever the lattice; the second is whole.
    const glm::dvec3 red(0.9, 0.1, 0.2);
    const glm::dvec3 blue(0.1, 0.3, 0.8);
    Layer shell = flatLayer(red, 0.3);
    const double removed = 4.2;
    const double front = -0.5 * kVoxels;
    shell.clip.emplace().planes = {{{0, -2, 0}, -2 * (front + removed)}}; // kept: y >= front + removed
    expectPixel(drawn(backend(), blockFigure({shell})),
                {red * (1 - std::pow(0.7, kVoxels - removed)), 1 - std::pow(0.7, kVoxels - removed)});
    const Layer core = flatLayer(blue, 0.05);
    const Picture both = drawn(backend(), blockFigure({shell, core}));
    EXPECT_NEAR(both.pixel(3, 2)[3], 1 - std::pow(0.7, kVoxels - removed) * std::pow(0.95, kVoxels),
                rounding(2e-7, 3e-6));
    EXPECT_GT(both.pixel(3, 2)[2], 0.1F) << "the core shows where the shell is cut";
    shell.clip->planes = {{{0, -1, 0}, -100}}; // nothing left
    EXPECT_NEAR(drawn(backend(), blockFigure({shell})).pixel(3, 2)[3], 0, 1e-7);
    shell.transfer.opacity = {{0, 1}}; // nor of what is opaque
    EXPECT_NEAR(drawn(backend(), blockFigure({shell})).pixel(3, 2)[3], 0, 1e-7);
}

TEST_P(LayersOfBlock, FadeAlongAnAxis) {
    Layer layer = flatLayer({1, 1, 1}, 0.2);
    layer.position.emplace().axis = "z";
    layer.position->ramp = {{0, {0.5, 0.25, 1, 0}}, {1, {0.5, 0.25, 1, 1}}};
    Figure figure = blockFigure({layer});
    figure.camera.heightMm = kVoxels;
    const Picture picture = drawn(backend(), figure, kVoxels);
    for (int y = 0; y < kVoxels; ++y) { // z falls down the picture; a row's middle is a voxel's
        const double place = std::clamp((kVoxels - 1 - y + 0.5) / kVoxels, 0.0, 1.0);
        const double alpha = 1 - std::pow(1 - 0.2 * place, kVoxels);
        const float* pixel = picture.pixel(5, y);
        EXPECT_NEAR(pixel[3], alpha, rounding(3e-7, 1e-4)) << y;
        EXPECT_NEAR(pixel[1], 0.25 * alpha, rounding(3e-7, 1e-4)) << y;
    }
}

TEST_P(LayersOfBlock, LeaveNoTraceOfPartsThatChangeNothing) {
    testing::SmoothScene scene;
    Figure figure = testing::smoothFigure(scene);
    figure.layers[0].shading = Shading::style;
    testing::makeLine(figure.layers[0], "value");
    const Picture plain = drawn(backend(), figure, 24);
    const std::pair<const char*, std::function<void(Figure&)>> changes[] = {
        {"tone without keys", [](Figure& f) { f.layers[0].tone.emplace(); }},
        {"clear outline", [](Figure& f) { f.layers[0].silhouette.emplace().opacity = 0; }},
        {"highlight of no strength", [](Figure& f) { f.layers[0].specular.emplace().strength = 0; }},
        {"line map without lines",
         [](Figure& f) {
             f.layers[0].lineGradientOpacity.emplace().push_back({0, 0});
         }},
        {"empty ramp", [](Figure& f) { f.layers[0].position.emplace(); }},
        {"all in focus", [](Figure& f) { f.layers[0].depthOfField.emplace().strength = 0; }},
        {"clip of nothing", [](Figure& f) { f.layers[0].clip.emplace().face.emplace(); }},
        {"faces without cuts", [](Figure& f) { f.clip.face.emplace(); }},
        {"cues of no strength", [](Figure& f) { f.depthCues.emplace().shadow.emplace().strength = 0; }},
        {"lock", [](Figure& f) { f.layers[0].locked = true; }},
    };
    for (const auto& [name, change] : changes) {
        Figure changed = figure;
        change(changed);
        EXPECT_TRUE(testing::sameBits(plain, drawn(backend(), changed, 24))) << name;
    }
}

TEST_P(LayersOfBlock, ShowFlatFacesWhereTheyAreCut) {
    testing::SmoothScene scene;
    Figure figure = testing::smoothFigure(scene);
    figure.camera.direction = {0, 1, 0};
    figure.camera.heightMm = 6; // all face
    Layer& layer = figure.layers[0];
    layer.shading = Shading::style;
    testing::makeLine(layer, "value");
    layer.transfer.nodes = {{0, "a", {}}};
    layer.transfer.opacity = {{0, 1}};
    figure.clip.planes = {{{0.3, -1, 0.2}, 0}};
    const auto spread = [](const Picture& picture) {
        double low = 1;
        double high = 0;
        for (std::size_t i = 0; i < picture.rgba().size(); i += 4) {
            low = std::min<double>(low, picture.rgba()[i]);
            high = std::max<double>(high, picture.rgba()[i]);
        }
        return high - low;
    };
    EXPECT_GT(spread(drawn(backend(), figure, 20)), 0.05) << "the data's own directions";
    figure.clip.face.emplace();
    EXPECT_LT(spread(drawn(backend(), figure, 20)), 1e-3) << "the plane's";
    figure.clip.face->rgb = glm::dvec3(0.7, 0.2, 0.1);
    const Picture coloured = drawn(backend(), figure, 20);
    EXPECT_LT(spread(coloured), 1e-5);
    EXPECT_NEAR(coloured.pixel(9, 9)[0], 0.7, 1e-5);
}

TEST_P(LayersOfBlock, BlurAwayFromTheFocus) {
    // A board of 2-voxel squares: sharp at the focus, grey far from it.
    const Grid grid = accuracy::centredGrid(24, 1);
    Camera camera;
    camera.heightMm = 16;
    Figure figure = accuracy::plainFigure(
        testing::makeVolume<std::uint8_t>(grid, VoxelType::uint8,
                                          [](const glm::ivec3& v) { return (v.x / 2 + v.z / 2) % 2 == 0 ? 200 : 20; }),
        camera);
    Layer layer = flatLayer({0, 0, 0}, 1);
    layer.transfer.nodes = {{20, "", glm::dvec3(0)}, {200, "", glm::dvec3(1)}};
    layer.transfer.opacity = {{0, 1}};
    const auto contrast = [&](double focus) {
        layer.depthOfField = DepthOfField{focus, 2};
        figure.layers = {layer};
        const Picture picture = drawn(backend(), figure, 32);
        double low = 1;
        double high = 0;
        for (int x = 8; x < 24; ++x) {
            low = std::min<double>(low, picture.pixel(x, 13)[0]); // inside a row of squares
            high = std::max<double>(high, picture.pixel(x, 13)[0]);
        }
        return high - low;
    };
    EXPECT_GT(contrast(0), 0.6);
    EXPECT_LT(contrast(1), 0.1);
}

TEST(PlannedParts, MakePlansOnlyOfWhatTheyAre) {
    Figure figure = testing::smoothFigure({});
    const auto plan = [&] {
        PlanRequest request;
        request.size = {16, 16};
        return testing::planOf(figure, request);
    };
    EXPECT_FALSE(plan()->layers[0].parts);
    EXPECT_TRUE(opacityByValue(plan()->layers[0]));
    figure.layers[0].tone.emplace().keys = {{0, {0, 0, 1}}, {1, {1, 1, 0}}};
    EXPECT_TRUE(plan()->layers[0].parts);
    EXPECT_TRUE(opacityByValue(plan()->layers[0])) << "tone leaves opacity alone";
    EXPECT_TRUE(readsNormal(*plan()));
    EXPECT_TRUE(plan()->blurs.empty());
    figure.layers[0].silhouette.emplace();
    EXPECT_FALSE(opacityByValue(plan()->layers[0]));
}

TEST(PlannedParts, BoundTheOpacityOfTheirLines) {
    PlanParts parts;
    parts.silhouette = Silhouette{{0, 0, 0}, {0, 1}, 0.5};
    parts.position.emplace().ramp = {{0, {1, 1, 1, 0.5}}, {1, {1, 1, 1, 2}}};
    EXPECT_DOUBLE_EQ(greatestOpacity(parts, 0.3), 0.6 + 0.3 - 0.18);
    EXPECT_DOUBLE_EQ(greatestOpacity(parts, 0.9), 1);
}

} // namespace
} // namespace limner
