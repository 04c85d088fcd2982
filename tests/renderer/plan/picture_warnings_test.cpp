#include "renderer/plan/picture_warnings.h"

#include "renderer/plan/planner.h"
#include "support/make_volume.h"

#include <gtest/gtest.h>

namespace limner {
namespace {

/// Values that rise by 100 a voxel along x; voxels of 2 mm.
Figure rampFigure(const Grid& grid) {
    Figure figure;
    figure.volume = VolumeReference{};
    figure.volume->data =
        testing::makeVolume<std::int16_t>(grid, VoxelType::int16, [](glm::ivec3 v) { return 100 * v.x; });
    Layer layer;
    layer.name = "Bone";
    layer.shading = Shading::flat;
    layer.transfer.nodes = {{500, "", glm::dvec3(1)}};
    layer.transfer.opacity = {{400, 0}, {500, 1}};
    figure.layers = {layer};
    return figure;
}

Grid twoMm() {
    Grid grid = testing::gridOf({16, 16, 16});
    grid.spacingMm = glm::dvec3(2);
    return grid;
}

std::vector<std::string> warningsOf(const Figure& figure) {
    Planner planner;
    Task task;
    PlanRequest request;
    request.size = {16, 16};
    return pictureWarnings(*planner.plan(figure, request, task));
}

TEST(PictureWarnings, TheSteepestChangeIsPerMillimetre) {
    EXPECT_DOUBLE_EQ(steepestChange(*rampFigure(twoMm()).volume->data), 50);
    Grid flat = testing::gridOf({1, 1, 1});
    EXPECT_EQ(steepestChange(*testing::makeVolume<std::uint8_t>(flat, VoxelType::uint8, [](glm::ivec3) { return 3; })),
              0);
}

TEST(PictureWarnings, AJumpIsSaidAGentleSlopeIsNot) {
    Figure figure = rampFigure(twoMm());
    EXPECT_TRUE(warningsOf(figure).empty()); // half a voxel's step changes by 50: the ramp of 100 is met twice
    figure.layers[0].transfer.opacity = {{400, 0}, {405, 1}};
    const std::vector<std::string> steep = warningsOf(figure);
    ASSERT_EQ(steep.size(), 1U);
    EXPECT_NE(steep[0].find("\"Bone\""), std::string::npos);
    EXPECT_NE(steep[0].find("within 5"), std::string::npos) << steep[0];
    figure.quality.stepVoxels = 0.1; // a step changes by 10
    EXPECT_TRUE(warningsOf(figure).empty());
    figure.quality.stepVoxels = 0.5;
    figure.layers[0].visible = false;
    EXPECT_TRUE(warningsOf(figure).empty()) << "what is not drawn needs no word";
}

TEST(PictureWarnings, ThickSlicesAndMirroredFilesAreSaid) {
    Grid grid = twoMm();
    grid.spacingMm = {0.5, 0.5, 5};
    std::vector<std::string> said = warningsOf(rampFigure(grid));
    ASSERT_EQ(said.size(), 1U);
    EXPECT_NE(said[0].find("5 mm apart"), std::string::npos) << said[0];
    grid = twoMm();
    grid.direction[2] = {0, 0, -1};
    said = warningsOf(rampFigure(grid));
    ASSERT_EQ(said.size(), 1U);
    EXPECT_NE(said[0].find("mirrored"), std::string::npos) << said[0];
}

} // namespace
} // namespace limner
