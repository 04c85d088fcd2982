#include "renderer/marks/curves.h"

#include "renderer/marks/inner_lines.h"

#include "mark_shapes.h"

#include <gtest/gtest.h>

#include <tbb/global_control.h>

namespace limner {
namespace {

using testing::ball;
using testing::closedStroke;
using testing::fieldOf;
using testing::roundedCube;
using testing::strokesIn;
using testing::torus;
using testing::viewOf;

std::vector<MarkGroup> silhouettes(const MarkField& field, const MarkView& view, const StippleCurves& settings = {},
                                   bool moving = false) {
    const MarkDepth depth(field, view, false);
    return drawSilhouettes({field, view, depth, InkColour(0), moving}, settings);
}

/// Mean and largest distance on paper of a group's points from a circle around the paper's middle.
glm::dvec2 offCircle(const MarkGroup& group, double radiusMm, double paperMm) {
    double sum = 0;
    double most = 0;
    for (const StrokePoint& p : group.points) {
        const double off = std::abs(glm::distance(glm::dvec2(p.placeMm), glm::dvec2(paperMm / 2)) - radiusMm);
        sum += off;
        most = std::max(most, off);
    }
    return {sum / static_cast<double>(group.points.size()), most};
}

TEST(Silhouettes, OfABallIsOneClosedCircle) {
    const MarkField field = fieldOf(ball(26), 52, 1.3);
    for (const glm::dvec3 direction : {glm::dvec3(0, 1, 0), glm::dvec3(1, 2, -0.7)}) {
        const MarkView view = viewOf(direction, 80, 120);
        const std::vector<MarkGroup> groups = silhouettes(field, view);
        ASSERT_EQ(strokesIn(groups), 1U);
        EXPECT_TRUE(closedStroke(groups[0], groups[0].strokes[0]));
        const glm::dvec2 off = offCircle(groups[0], 26 * 1.5, 120);
        const double voxel = 1.3 * 1.5;
        EXPECT_LT(off.x, 0.1 * voxel);
        EXPECT_LT(off.y, 0.3 * voxel);
        RecordProperty("mean distance in voxels", std::to_string(off.x / voxel));
        RecordProperty("largest distance in voxels", std::to_string(off.y / voxel));
    }
}

TEST(Silhouettes, OfABallInPerspectiveLieBeforeItsMiddle) {
    const MarkField field = fieldOf(ball(26), 52, 1.3);
    const MarkView view = viewOf({0, 1, 0}, 80, 120, 50);
    const std::vector<MarkGroup> groups = silhouettes(field, view);
    ASSERT_EQ(strokesIn(groups), 1U);
    const double eye = 40 / std::tan(25 * std::numbers::pi / 180);
    const double radius = 26 / std::sqrt(1 - (26 / eye) * (26 / eye)); // in the target plane
    EXPECT_GT(radius, 27);
    const glm::dvec2 off = offCircle(groups[0], radius * 1.5, 120);
    EXPECT_LT(off.x, 0.1 * 1.3 * 1.5);
}

TEST(Silhouettes, OfATorusAreItsLoops) {
    const MarkField field = fieldOf(torus(20, 8), 64, 1);
    EXPECT_EQ(strokesIn(silhouettes(field, viewOf({0, 0, 1}, 70, 100))), 2U) << "outline and hole";
    // From the side the hole is hidden, and what shows is the outline with two ends of lines within it.
    StippleCurves settings;
    settings.hiddenLines = "thin";
    const std::vector<MarkGroup> tilted = silhouettes(field, viewOf({0, 1, 0.45}, 70, 100), settings);
    ASSERT_EQ(tilted.size(), 2U);
    EXPECT_EQ(tilted[0].name, "Silhouettes, hidden");
    EXPECT_EQ(tilted[1].name, "Silhouettes");
    EXPECT_LE(tilted[1].strokes.size(), 4U);
    EXPECT_GE(tilted[1].strokes.size(), 2U);
    EXPECT_TRUE(std::any_of(tilted[1].strokes.begin(), tilted[1].strokes.end(),
                            [&](const Stroke& s) { return closedStroke(tilted[1], s); }));
}

TEST(Silhouettes, OfAPlaneThatFacesTheViewerAreNone) {
    const MarkField field = fieldOf([](const glm::dvec3& p) { return p.y + 0.2; }, 24, 1);
    EXPECT_GT(field.voxels.size(), 1000U);
    for (const bool moving : {false, true}) {
        EXPECT_EQ(strokesIn(silhouettes(field, viewOf({0, 1, 0}, 30, 50), {}, moving)), 0U);
    }
}

TEST(Silhouettes, BehindMatterAreLeftOutDashedOrThin) {
    // A small ball behind a large one, whole behind it.
    const testing::Shape both = [](const glm::dvec3& p) {
        return std::min(ball(14, {0, -12, 0})(p), ball(6, {0, 16, 0})(p));
    };
    const MarkField field = fieldOf(both, 60, 1);
    const MarkView view = viewOf({0, 1, 0}, 60, 100);
    StippleCurves settings;
    EXPECT_EQ(strokesIn(silhouettes(field, view, settings)), 1U);
    settings.hiddenLines = "thin";
    const std::vector<MarkGroup> thin = silhouettes(field, view, settings);
    ASSERT_EQ(thin.size(), 2U);
    EXPECT_EQ(thin[0].strokes.size(), 1U);
    EXPECT_LT(thin[0].points[0].widthMm, 0.5F * static_cast<float>(settings.widthMm));
    settings.hiddenLines = "dashed";
    const std::vector<MarkGroup> dashed = silhouettes(field, view, settings);
    ASSERT_EQ(dashed.size(), 2U);
    const double around = 2 * std::numbers::pi * 6 * 100 / 60;
    EXPECT_NEAR(static_cast<double>(dashed[0].strokes.size()), around / (11.5 * settings.widthMm), 2);
    // Nothing hides anything: both are whole.
    EXPECT_EQ(strokesIn(drawSilhouettes({field, view, MarkDepth(), InkColour(0), false}, settings)), 2U);
}

TEST(Silhouettes, WidthsAreOnPaper) {
    const MarkField field = fieldOf(torus(20, 6), 60, 1);
    StippleCurves settings;
    settings.widthMm = 0.5;
    for (const double paper : {50.0, 200.0}) {
        for (const MarkGroup& group : silhouettes(field, viewOf({0, 0, 1}, 60, paper), settings)) {
            for (const StrokePoint& p : group.points) {
                EXPECT_FLOAT_EQ(p.widthMm, 0.5F);
            }
        }
    }
    settings.widthBy = "depth";
    const std::vector<MarkGroup> deep = silhouettes(field, viewOf({0, 1, -0.6}, 60, 100), settings);
    const auto [thin, thick] =
        std::minmax_element(deep[0].points.begin(), deep[0].points.end(),
                            [](const StrokePoint& a, const StrokePoint& b) { return a.widthMm < b.widthMm; });
    EXPECT_GT(thick->widthMm, 1.6F * thin->widthMm);
    EXPECT_GT(thick->placeMm.y, thin->placeMm.y) << "seen from above, the near side is below";
}

TEST(Silhouettes, AreThickWhereTheFormBends) {
    const testing::Shape both = [](const glm::dvec3& p) {
        return std::min(ball(16, {-14, 0, 0})(p), ball(4, {18, 0, 0})(p));
    };
    const MarkField field = fieldOf(both, 64, 1);
    StippleCurves settings;
    settings.widthBy = "curvature";
    const std::vector<MarkGroup> groups = silhouettes(field, viewOf({0, 1, 0}, 64, 64), settings);
    ASSERT_EQ(strokesIn(groups), 2U);
    for (const StrokePoint& p : groups[0].points) {
        const double radius = p.placeMm.x < 32 + 4 ? 16 : 4;
        EXPECT_NEAR(p.widthMm, settings.widthMm * (0.4 + 0.9 * (1 - std::exp(-8 / radius))), 0.12 * settings.widthMm);
    }
}

TEST(Silhouettes, WhileMovingAreASegmentPerVoxel) {
    const MarkField field = fieldOf(ball(26), 52, 1.3);
    const MarkView view = viewOf({1, 2, -0.7}, 80, 120);
    const std::vector<MarkGroup> groups = silhouettes(field, view, {}, true);
    ASSERT_EQ(groups.size(), 1U);
    EXPECT_GT(groups[0].strokes.size(), 400U);
    for (const Stroke& stroke : groups[0].strokes) {
        ASSERT_EQ(stroke.count, 2U);
        const glm::vec2 a = groups[0].points[stroke.first].placeMm;
        const glm::vec2 b = groups[0].points[stroke.first + 1].placeMm;
        const glm::vec2 out = 0.5F * (a + b) - 60.0F;
        // |n.e| < 0.3: within R (1 - sqrt(1 - 0.3^2)) inside the outline, and along it.
        EXPECT_NEAR(glm::length(out), 39 * (1 + std::sqrt(1 - 0.09)) / 2, 39 * (1 - std::sqrt(1 - 0.09)) / 2 + 0.3);
        EXPECT_LT(std::abs(glm::dot(glm::normalize(out), glm::normalize(b - a))), 0.05F);
    }
    StippleCurves narrower;
    narrower.eye = 0.1;
    EXPECT_LT(strokesIn(silhouettes(field, view, narrower, true)), groups[0].strokes.size() / 2);
}

TEST(Silhouettes, ThresholdsLeaveOut) {
    const MarkField field = fieldOf(ball(20), 48, 1);
    const MarkView view = viewOf({1, 2, -0.7}, 60, 100);
    for (const bool moving : {false, true}) {
        StippleCurves settings;
        settings.log = -10;
        EXPECT_EQ(strokesIn(silhouettes(field, view, settings, moving)), 0U);
        settings = {};
        settings.eye = 0;
        EXPECT_EQ(strokesIn(silhouettes(field, view, settings, moving)), 0U);
        settings = {};
        settings.gradient = 1;
        EXPECT_EQ(strokesIn(silhouettes(field, view, settings, moving)), 0U);
    }
}

StippleInnerLines only(double ridges, double valleys) { return {ridges, valleys, 0.15}; }

TEST(InnerLines, OfARoundedCubeAreItsEdges) {
    const MarkField field = fieldOf(roundedCube(16, 3), 48, 1);
    const StippleInnerLines settings = only(0.2, 0.2);
    const std::vector<SurfaceLine> traced = traceInnerLines(field, settings);
    ASSERT_EQ(traced.size(), 12U);
    const double crest = 16 - 3 + 3 / std::numbers::sqrt2;
    for (const SurfaceLine& line : traced) {
        double off = 0;
        for (const LinePoint& p : line.points) {
            glm::dvec3 a = glm::abs(p.mm);
            const double least = std::min({a.x, a.y, a.z}); // along the edge
            const double sum = a.x + a.y + a.z - least;
            off += std::abs(sum / 2 - crest);
        }
        EXPECT_LT(off / static_cast<double>(line.points.size()), 0.35);
        EXPECT_GT(glm::distance(line.points.front().mm, line.points.back().mm), 20);
    }
    const MarkView view = viewOf({1, 1.1, -0.9}, 60, 100);
    const MarkDepth depth(field, view, false);
    EXPECT_EQ(strokesIn(drawInnerLines({field, view, depth, InkColour(0), false}, traced, settings)), 3U)
        << "three edges lie within the outline of a cube, the others are its outline or behind it";
    EXPECT_TRUE(traceInnerLines(field, only(0, 0.2)).empty());
    EXPECT_TRUE(traceInnerLines(field, only(0.6, 0)).empty());
}

TEST(InnerLines, OfAGrooveIsAValley) {
    // A block whose face to the viewer has a round groove along z at x = 0.
    const testing::Shape block = [](const glm::dvec3& p) {
        const double groove = std::hypot(p.x, p.y + 10) - 2.5;
        const double plane = -(p.y + 10);
        // smooth maximum of the plane and what is outside the groove, so that the rims are round
        const double a = plane;
        const double b = -groove;
        const double k = 2;
        const double h = std::max(k - std::abs(a - b), 0.0) / k;
        return std::max(a, b) + h * h * k / 4;
    };
    const MarkField field = fieldOf(block, 40, 1);
    const std::vector<SurfaceLine> traced = traceInnerLines(field, only(0, 0.2));
    ASSERT_EQ(traced.size(), 1U);
    for (const LinePoint& p : traced[0].points) {
        EXPECT_NEAR(p.mm.x, 0, 0.5);
        EXPECT_NEAR(p.mm.y, -7.5, 0.5);
    }
    EXPECT_GT(std::abs(traced[0].points.front().mm.z - traced[0].points.back().mm.z), 30);
}

TEST(InnerLines, OfABallAreNone) { EXPECT_TRUE(traceInnerLines(fieldOf(ball(4), 24, 1), only(0.1, 0.1)).empty()); }

TEST(Lines, AreTheSameForAnyNumberOfThreads) {
    const MarkField field = fieldOf(torus(20, 7), 60, 1);
    const MarkView view = viewOf({0.3, 1, 0.5}, 60, 100);
    StippleCurves curves;
    curves.hiddenLines = "dashed";
    const auto all = [&] {
        const MarkDepth depth(field, view, false);
        const LineScene still{field, view, depth, InkColour(0), false};
        std::vector<MarkGroup> groups = drawSilhouettes(still, curves);
        const StippleInnerLines settings = only(0.05, 0.05);
        for (auto& group : drawInnerLines(still, traceInnerLines(field, settings), settings)) {
            groups.push_back(std::move(group));
        }
        for (auto& group : silhouettes(field, view, curves, true)) {
            groups.push_back(std::move(group));
        }
        return groups;
    };
    const std::vector<MarkGroup> many = all();
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_TRUE(testing::sameMarks(many, all()));
    EXPECT_GT(strokesIn(many), 100U);
}

TEST(Lines, OfPoorFieldsAreSound) {
    const MarkView view = viewOf({0, 1, 0}, 10, 50);
    MarkField field = fieldOf(ball(1e6), 3, 1);
    for (const int voxels : {0, 1, 27}) {
        field.voxels.clear();
        field.curvatures.clear();
        field.rowStart = {0};
        for (int row = 0; row < 9; ++row) {
            for (int x = 0; x < 3 && static_cast<int>(field.voxels.size()) < voxels; ++x) {
                MarkVoxel voxel = testing::voxelAt({x, row % 3, row / 3}, 0, glm::dvec3(0), 1);
                field.voxels.push_back(voxel); // its normal has no direction
                field.curvatures.emplace_back();
            }
            field.rowStart.push_back(static_cast<std::uint32_t>(field.voxels.size()));
        }
        for (const bool moving : {false, true}) {
            EXPECT_EQ(strokesIn(silhouettes(field, view, {}, moving)), 0U);
        }
        EXPECT_TRUE(traceInnerLines(field, only(0.1, 0.1)).empty());
    }
}

} // namespace
} // namespace limner
