#include "renderer/pick.h"

#include "core/figure/view_frame.h"
#include "support/make_volume.h"
#include "support/rendering.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace limner {
namespace {

constexpr double kStepMm = 0.25;

/// Fog of 40 mm edge that starts at y = 10 mm behind air, seen from the front; half its reference length is opaque to
/// `opacity`.
Figure fogFigure(double opacity) {
    Grid grid = testing::gridOf({40, 40, 40});
    grid.originMm = {-20, 3, 7};
    Figure figure;
    figure.volume = VolumeReference{};
    figure.volume->data =
        testing::makeVolume<std::uint8_t>(grid, VoxelType::uint8, [](glm::ivec3 v) { return v.y >= 10 ? 200 : 0; });
    figure.camera.targetMm = grid.centreMm();
    figure.camera.heightMm = 50;
    Layer fog;
    fog.shading = Shading::flat;
    fog.transfer.nodes = {{0, "", glm::dvec3(0.5)}};
    fog.transfer.opacity = {{99, 0}, {100, opacity}, {255, opacity}}; // half way between the voxels: y = 9.5
    figure.layers = {fog};
    figure.quality.stepVoxels = kStepMm;
    return figure;
}

std::optional<Pick> pickAt(const Figure& figure, const glm::dvec2& pixel, glm::ivec2 size = {80, 60}) {
    PlanRequest request;
    request.size = size;
    return pickMatter(*testing::planOf(figure, request), pixel);
}

TEST(Pick, OpaqueMatterIsPickedAtItsFace) {
    const Figure figure = fogFigure(1);
    const auto pick = pickAt(figure, {40, 30});
    ASSERT_TRUE(pick);
    EXPECT_NEAR(pick->pointMm.y, 3 + 9.5, kStepMm);
    EXPECT_NEAR(pick->pointMm.x, figure.camera.targetMm.x, 1e-9);
    EXPECT_NEAR(pick->pointMm.z, figure.camera.targetMm.z, 1e-9);
    EXPECT_GE(pick->value, 99);
}

TEST(Pick, FogIsPickedWhereHalfOfItIsSeen) {
    for (const double opacity : {0.5, 0.2, 0.05}) {
        const auto pick = pickAt(fogFigure(opacity), {40, 30});
        ASSERT_TRUE(pick);
        const double depth = std::log(0.5) / std::log(1 - opacity); // (1 - a)^depth = 1/2
        EXPECT_NEAR(pick->pointMm.y, 3 + 9.5 + depth, 2 * kStepMm) << opacity;
    }
    EXPECT_FALSE(pickAt(fogFigure(0.01), {40, 30})) << "thirty millimetres of it hide less than a half";
}

TEST(Pick, LayersAddUp) {
    Figure figure = fogFigure(0.01);
    Layer second = figure.layers.front();
    second.transfer.opacity = {{99, 0}, {100, 0.04}, {255, 0.04}};
    figure.layers.push_back(second);
    const auto pick = pickAt(figure, {40, 30});
    ASSERT_TRUE(pick);
    const double depth = std::log(0.5) / (std::log(1 - 0.01) + std::log(1 - 0.04));
    EXPECT_NEAR(pick->pointMm.y, 3 + 9.5 + depth, 2 * kStepMm);
    figure.layers.back().visible = false;
    EXPECT_FALSE(pickAt(figure, {40, 30}));
}

TEST(Pick, ThePointLiesUnderThePlaceInThePicture) {
    Figure figure = fogFigure(1);
    figure.camera.direction = {0.4, 1, -0.3};
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
        figure.camera.projection = projection;
        for (const glm::dvec2 pixel : {glm::dvec2(40, 30), glm::dvec2(30.25, 22), glm::dvec2(52, 40.5)}) {
            const auto pick = pickAt(figure, pixel);
            ASSERT_TRUE(pick);
            const glm::dvec3 seen = ViewFrame(figure.camera, 80.0 / 60).project(pick->pointMm);
            EXPECT_NEAR(seen.x / seen.z * 80, pixel.x, 1e-6);
            EXPECT_NEAR(seen.y / seen.z * 60, pixel.y, 1e-6);
        }
    }
}

TEST(Pick, NothingOnPaperAndNothingThatIsCutAway) {
    Figure figure = fogFigure(1);
    EXPECT_FALSE(pickAt(figure, {2, 2})) << "beside the volume";
    figure.clip.planes.push_back({{0, -1, 0}, -33}); // away with what lies in front of y = 33
    const auto pick = pickAt(figure, {40, 30});
    ASSERT_TRUE(pick);
    EXPECT_NEAR(pick->pointMm.y, 33, kStepMm);
}

/// A wall at y = 10 whose right half is too faint to show, and a shown one far behind it: the hand stays on its wall.
TEST(Pick, ATrailFollowsItsStructureWhereItDoesNotShow) {
    Figure figure = fogFigure(1);
    const Grid grid = figure.volume->data->grid();
    figure.volume->data = testing::makeVolume<std::uint8_t>(grid, VoxelType::uint8, [](glm::ivec3 v) {
        const bool wall = v.y >= 10 && v.y < 14;
        return v.y >= 34 ? 220 : wall ? (v.x < 20 ? 200 : 90) : 0;
    });
    PlanRequest request;
    request.size = {80, 60};
    const auto plan = testing::planOf(figure, request);
    PickTrail trail{{99, 255}, 6, std::nullopt};
    const auto start = followMatter(*plan, {32, 30}, trail);
    ASSERT_TRUE(start);
    EXPECT_GE(start->value, 99);
    const auto faint = followMatter(*plan, {48, 30}, trail);
    ASSERT_TRUE(faint);
    EXPECT_NEAR(faint->value, 90, 1e-9) << "the value nearest to those that show";
    EXPECT_LT(faint->pointMm.y, 3 + 14);
    EXPECT_GT(pickMatter(*plan, {48, 30})->pointMm.y, 3 + 30) << "what is seen there lies far behind";
    EXPECT_EQ(trail.last->value, faint->value);
    PickTrail fresh{{99, 255}, 6, std::nullopt};
    EXPECT_GT(followMatter(*plan, {48, 30}, fresh)->value, 99) << "a hand that begins there means what is seen";
    EXPECT_FALSE(followMatter(*plan, {1, 1}, fresh));
}

TEST(Pick, TheGradientIsAShareOfTheGreatest) {
    const auto pick = pickAt(fogFigure(1), {40, 30});
    ASSERT_TRUE(pick);
    EXPECT_GT(pick->gradient, 0.3) << "a face";
    EXPECT_LE(pick->gradient, 1);
    const auto deep = pickAt(fogFigure(0.05), {40, 30});
    EXPECT_LT(deep->gradient, 0.01) << "inside even fog";
}

} // namespace
} // namespace limner
