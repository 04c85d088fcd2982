#include "renderer/marks/mark_field.h"
#include "support/make_volume.h"
#include "support/mark_scenes.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limner {
namespace {

using namespace testing;

constexpr double kRadius = 18;

Figure ballFigure() {
    Figure figure = inkFigure(bodyVolume(48, [](const glm::dvec3& p) { return glm::length(p) - kRadius; }), 120, 44);
    figure.stipple->curves.emplace();
    return figure;
}

std::shared_ptr<const MarkField> fieldOf(const Figure& figure) { return markPlan(figure)->marks->field; }

TEST(MarkField, NormalsPlacesAndCurvaturesOfABall) {
    const auto field = fieldOf(ballFigure());
    ASSERT_GT(field->voxels.size(), 1000U);
    double place = 0;
    double bend = 0;
    double weight = 0;
    double turn = 0;
    for (std::size_t i = 0; i < field->voxels.size(); ++i) {
        const MarkVoxel& voxel = field->voxels[i];
        if (!(voxel.share > 0)) {
            continue;
        }
        const glm::dvec3 mm = field->placeMm(voxel);
        const glm::dvec3 n(voxel.normalMm);
        const double part = static_cast<double>(voxel.share);
        turn += part * std::acos(std::min(glm::dot(n, glm::normalize(mm)), 1.0));
        const glm::dvec3 surface = mm + n * static_cast<double>(voxel.edgeOffsetMm);
        place += part * std::abs(glm::length(surface) - kRadius);
        // A level surface of a ball's edge is a ball: 1 / its own radius.
        bend += part * static_cast<double>(field->curvatures[i].most) * glm::length(mm);
        weight += part;
    }
    EXPECT_LT(turn / weight, 0.05);  // under three degrees, in the mean over what is drawn
    EXPECT_LT(place / weight, 0.25); // mm, a quarter of a voxel
    EXPECT_NEAR(bend / weight, 1, 0.15);
}

TEST(MarkField, SharesAddUpToTheSurfaceHoweverItLies) {
    for (const glm::dvec3 n : {glm::dvec3(0, 0, 1), glm::dvec3(1, 2, 3), glm::dvec3(1, 1, 1), glm::dvec3(0, 1, 1.01)}) {
        for (const double edge : {1.0, 3.0}) { // edges of two voxels, and of six: as many marks
            const glm::dvec3 unit = glm::normalize(n);
            const auto field = fieldOf(
                inkFigure(bodyVolume(48, [&](const glm::dvec3& p) { return glm::dot(p, unit) / edge; }), 120, 44));
            constexpr double radius = 15; // of the disc of it that is measured
            double area = 0;
            for (const MarkVoxel& voxel : field->voxels) {
                const glm::dvec3 surface =
                    field->placeMm(voxel) + glm::dvec3(voxel.normalMm) * static_cast<double>(voxel.edgeOffsetMm);
                if (glm::length(surface) < radius) {
                    area += static_cast<double>(voxel.share) * field->mmPerVoxel * field->mmPerVoxel;
                }
            }
            // At 45 degrees to two axes neighbours choose differently: a column is met twice, or missed.
            EXPECT_NEAR(area / (std::numbers::pi * radius * radius), 1, 0.06) << n.x << n.y << n.z << ", " << edge;
        }
    }
}

TEST(MarkField, OneVoxelOfAColumnDraws) {
    const auto field = fieldOf(inkFigure(slabVolume(32), 120, 32));
    for (int x = 4; x < 28; x += 6) {
        int drawing = 0;
        for (int z = 0; z < 32; ++z) {
            const std::int64_t i = field->find({x, 16, z});
            drawing += i >= 0 && field->voxels[static_cast<std::size_t>(i)].share > 0 ? 1 : 0;
        }
        EXPECT_EQ(drawing, 1);
    }
    EXPECT_EQ(field->find({-1, 0, 0}), -1);
    EXPECT_EQ(field->find({16, 16, 2}), -1);
}

TEST(MarkField, LiesInSpaceAsTheVolumeDoes) {
    // Spacing, direction and origin of no special kind: a ball in mm is one for the field too.
    Grid grid = gridOf({40, 30, 20});
    grid.spacingMm = {1, 1.4, 2};
    grid.direction = glm::dmat3(glm::dvec3(0.6, 0.8, 0), glm::dvec3(0.8, -0.6, 0), glm::dvec3(0, 0, 1));
    grid.originMm = {5, -7, 11};
    const glm::dvec3 middle = grid.centreMm();
    const auto volume = makeVolume<std::uint8_t>(grid, VoxelType::uint8, [&](const glm::ivec3& v) {
        return std::lround(255 * std::clamp(0.5 - 0.3 * (glm::distance(grid.mmFromVoxel(v), middle) - 13), 0.0, 1.0));
    });
    const auto field = fieldOf(inkFigure(volume, 120, 44));
    ASSERT_GT(field->voxels.size(), 200U);
    double turn = 0;
    double weight = 0;
    for (const MarkVoxel& voxel : field->voxels) {
        const glm::dvec3 out = glm::normalize(field->placeMm(voxel) - middle);
        const double part = static_cast<double>(voxel.share);
        turn += part * std::acos(std::clamp(glm::dot(glm::dvec3(voxel.normalMm), out), -1.0, 1.0));
        weight += part;
    }
    EXPECT_LT(turn / weight, 0.08);
}

TEST(MarkField, NothingToDrawIsSaid) {
    const auto constant =
        makeVolume<std::uint8_t>(gridOf({8, 8, 8}), VoxelType::uint8, [](const glm::ivec3&) { return 7; });
    const auto field = fieldOf(inkFigure(constant, 60, 10));
    EXPECT_TRUE(field->voxels.empty());
    ASSERT_EQ(field->warnings.size(), 1U);
    EXPECT_TRUE(marksOf(inkFigure(constant, 60, 10)).empty());
}

TEST(MarkField, OneVoxelThickVolumesAndSingleVoxelsAreDrawn) {
    const auto disk = makeVolume<std::uint8_t>(gridOf({32, 32, 1}), VoxelType::uint8, [](const glm::ivec3& v) {
        return glm::length(glm::dvec2(v.x - 15.5, v.y - 15.5)) < 10 ? 255 : 0;
    });
    Figure figure = inkFigure(disk, 60, 40);
    lookFromAbove(figure);
    figure.stipple->hidden = "show";
    figure.stipple->curves.emplace();
    for (const MarkVoxel& voxel : fieldOf(figure)->voxels) {
        EXPECT_EQ(voxel.normalMm.z, 0);
    }
    marksOf(figure);
    marksOf(figure, true);
    const auto one = makeVolume<std::uint8_t>(gridOf({1, 1, 1}), VoxelType::uint8, [](const glm::ivec3&) { return 1; });
    EXPECT_TRUE(marksOf(inkFigure(one, 60, 4)).empty());
}

TEST(MarkField, ViewsShareItAndSettingsThatItReadsRenewIt) {
    Planner planner;
    Task task;
    PlanRequest request;
    request.size = {32, 32};
    Figure figure = ballFigure();
    figure.stipple->sizeMm = 2; // two voxels are no more than the five pixels of a moving view
    const auto field = [&] { return planner.plan(figure, request, task)->marks->field; };
    const auto first = field();
    figure.camera.direction = {1, 1, 0.2};
    figure.camera.heightMm *= 1.2;
    figure.stipple->lighting.emplace();
    EXPECT_EQ(field(), first);
    request.moving = true;
    const auto coarse = field();
    EXPECT_LT(coarse->voxels.size(), first->voxels.size());
    request.moving = false;
    EXPECT_EQ(field(), first);
    figure.stipple->threshold = 0.3;
    EXPECT_NE(field(), first);
}

} // namespace
} // namespace limner
