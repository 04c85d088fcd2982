#include "core/figure/annotation_layout.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <random>

namespace limner {
namespace {

constexpr glm::dvec2 kSheet(180, 140);

using Random = std::mt19937;

double between(double low, double high, Random& random) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

/// Labels of one to three lines whose points lie in the middle of the sheet, as a drawing between two columns has them.
std::vector<LabelBox> someLabels(std::size_t count, Random& random) {
    std::vector<LabelBox> labels;
    for (std::size_t i = 0; i < count; ++i) {
        const int lines = std::uniform_int_distribution<int>(1, 3)(random);
        LabelBox label;
        label.sizeMm = {between(10, 35, random), 3.2 * lines};
        label.portDownMm = 1.7;
        label.anchorMm = {between(55, 125, random), between(15, 125, random)};
        labels.push_back(label);
    }
    return labels;
}

int crossings(std::span<const LabelBox> labels, std::span<const PlacedLabel> placed) {
    int count = 0;
    for (std::size_t a = 0; a < labels.size(); ++a) {
        for (std::size_t b = a + 1; b < labels.size(); ++b) {
            count += leadersCross(placed[a].portMm, labels[a].anchorMm, placed[b].portMm, labels[b].anchorMm) ? 1 : 0;
        }
    }
    return count;
}

int overlaps(std::span<const PlacedLabel> placed, std::span<const SheetBox> taken) {
    int count = 0;
    for (std::size_t a = 0; a < placed.size(); ++a) {
        for (std::size_t b = a + 1; b < placed.size(); ++b) {
            count += placed[a].box.overlaps(placed[b].box) ? 1 : 0;
        }
        for (const SheetBox& box : taken) {
            count += placed[a].box.overlaps(box) ? 1 : 0;
        }
    }
    return count;
}

void expectSound(const LabelSheet& sheet, std::span<const LabelBox> labels, const std::string& what) {
    const std::vector<PlacedLabel> placed = layOutLabels(sheet, labels);
    ASSERT_EQ(placed.size(), labels.size());
    EXPECT_EQ(crossings(labels, placed), 0) << what;
    EXPECT_EQ(overlaps(placed, sheet.taken), 0) << what;
    for (std::size_t i = 0; i < placed.size(); ++i) {
        const PlacedLabel& one = placed[i];
        EXPECT_TRUE(one.box.lowMm.x >= 0 && one.box.lowMm.y >= 0 && one.box.highMm.x <= sheet.sizeMm.x + 1e-9 &&
                    one.box.highMm.y <= sheet.sizeMm.y + 1e-9)
            << what << ": label " << i << " leaves the sheet";
        EXPECT_NEAR(glm::length(one.box.sizeMm() - labels[i].sizeMm), 0, 1e-9);
        EXPECT_GE(one.portMm.x, one.box.lowMm.x - 1e-9);
        EXPECT_LE(one.portMm.x, one.box.highMm.x + 1e-9);
    }
    EXPECT_EQ(layOutLabels(sheet, labels), placed) << what << ": the same twice";
}

TEST(AnnotationLayout, TellsCrossingLeaders) {
    EXPECT_TRUE(leadersCross({0, 0}, {2, 2}, {0, 2}, {2, 0}));
    EXPECT_FALSE(leadersCross({0, 0}, {2, 0}, {0, 1}, {2, 1}));
    EXPECT_TRUE(leadersCross({0, 0}, {2, 0}, {1, 0}, {1, 2})) << "one ends on the other";
    EXPECT_FALSE(leadersCross({0, 0}, {2, 2}, {0, 3}, {2, 2})) << "two labels of one point";
    EXPECT_TRUE(leadersCross({0, 0}, {3, 0}, {1, 0}, {2, 0})) << "one lies in the other";
    EXPECT_FALSE(leadersCross({0, 0}, {1, 0}, {2, 0}, {3, 0})) << "one after the other";
}

class EveryLayout : public ::testing::TestWithParam<LabelLayout> {};

TEST_P(EveryLayout, CrossesNoLeadersAndOverlapsNoBoxes) {
    Random random(20);
    constexpr int kRuns = 400;
    for (int run = 0; run < kRuns; ++run) {
        LabelSheet sheet;
        sheet.sizeMm = kSheet;
        sheet.layout = GetParam();
        const std::size_t count = 1 + static_cast<std::size_t>(run) % 14; // 14 of three lines fill half of the columns
        expectSound(sheet, someLabels(count, random), "run " + std::to_string(run));
    }
}

TEST_P(EveryLayout, LeavesRoomForTitlesAndScaleBars) {
    Random random(21);
    for (int run = 0; run < 200; ++run) {
        LabelSheet sheet;
        sheet.sizeMm = kSheet;
        sheet.layout = GetParam();
        sheet.taken = {{{40, 4}, {140, 10}}, {{4, 126}, {40, 136}}, {{150, 118}, {176, 136}}};
        expectSound(sheet, someLabels(1 + static_cast<std::size_t>(run) % 9, random), "run " + std::to_string(run));
    }
}

INSTANTIATE_TEST_SUITE_P(Layouts, EveryLayout,
                         ::testing::Values(LabelLayout::columns, LabelLayout::ring, LabelLayout::free));

TEST(AnnotationLayout, ColumnsStandAtTheEdgesNearTheirPoints) {
    LabelSheet sheet;
    sheet.sizeMm = kSheet;
    LabelBox label;
    label.sizeMm = {20, 3};
    label.portDownMm = 1.5;
    label.anchorMm = {70, 50};
    LabelBox other = label;
    other.anchorMm = {110, 90};
    const auto placed = layOutLabels(sheet, std::vector{label, other});
    EXPECT_EQ(placed[0].portMm, glm::dvec2(24, 50)) << "a margin of 4 and a width of 20";
    EXPECT_EQ(placed[1].portMm, glm::dvec2(156, 90));
    EXPECT_EQ(placed[0].box.lowMm, glm::dvec2(4, 48.5));
}

TEST(AnnotationLayout, ALeaderDoesNotRunThroughAnotherPoint) {
    LabelSheet sheet;
    sheet.sizeMm = kSheet;
    LabelBox far;
    far.sizeMm = {20, 3};
    far.portDownMm = 1.5;
    far.anchorMm = {110, 60};
    LabelBox near = far;
    near.anchorMm = {140, 60}; // on the straight way to the column at 156
    const auto placed = layOutLabels(sheet, std::vector{far, near});
    EXPECT_FALSE(leadersCross(placed[0].portMm, far.anchorMm, placed[1].portMm, near.anchorMm));
    // Height of the far one's leader over the near one's point: a millimetre is left between them.
    const double share = (140.0 - 110) / (156 - 110);
    EXPECT_GT(std::abs(60 + share * (placed[0].portMm.y - 60) - 60), 1);
    EXPECT_LT(std::abs(placed[0].portMm.y - 60), 7);
}

TEST(AnnotationLayout, ABoxOverItsOwnPointMovesOutwards) {
    LabelSheet sheet;
    sheet.sizeMm = kSheet;
    LabelBox wide;
    wide.sizeMm = {40, 3};
    wide.portDownMm = 1.5;
    wide.anchorMm = {110, 100};
    LabelBox narrow = wide;
    narrow.sizeMm.x = 20;
    narrow.anchorMm = {150, 50}; // the column begins at 136
    const auto placed = layOutLabels(sheet, std::vector{wide, narrow});
    EXPECT_EQ(placed[0].portMm.x, 136);
    EXPECT_EQ(placed[1].portMm.x, 153);
    narrow.anchorMm.x = 170; // too near to the edge: it stays
    EXPECT_EQ(layOutLabels(sheet, std::vector{wide, narrow})[1].portMm.x, 136);
}

TEST(AnnotationLayout, AGivenSideIsKept) {
    LabelSheet sheet;
    sheet.sizeMm = kSheet;
    LabelBox label;
    label.sizeMm = {20, 3};
    label.anchorMm = {60, 50};
    label.side = LabelSide::right;
    EXPECT_GT(layOutLabels(sheet, std::vector{label})[0].box.lowMm.x, 150);
}

TEST(AnnotationLayout, WhatTheUserPlacedStaysAndTheOthersMakeWay) {
    Random random(22);
    for (int run = 0; run < 300; ++run) {
        LabelSheet sheet;
        sheet.sizeMm = kSheet;
        std::vector<LabelBox> labels = someLabels(7, random);
        const bool left = labels[3].anchorMm.x < kSheet.x / 2;
        labels[3].atMm = {left ? between(36, 40, random) : between(140, 144, random), labels[3].anchorMm.y};
        const auto placed = layOutLabels(sheet, labels);
        EXPECT_EQ(placed[3].portMm, *labels[3].atMm);
        EXPECT_EQ(overlaps(placed, {}), 0) << run;
    }
}

TEST(AnnotationLayout, ManyMoreThanThereIsRoomForStillHaveBoxesOfTheirOwn) {
    Random random(23);
    LabelSheet sheet;
    sheet.sizeMm = kSheet;
    sheet.layout = LabelLayout::ring; // has no room for so many: columns
    const std::vector<LabelBox> labels = someLabels(120, random);
    const auto placed = layOutLabels(sheet, labels);
    EXPECT_EQ(overlaps(placed, {}), 0) << "they go on below the sheet";
    EXPECT_EQ(crossings(labels, placed), 0);
}

TEST(AnnotationLayout, AnyPointsAnywhereGiveAnAnswer) {
    Random random(24);
    for (const LabelLayout layout : {LabelLayout::columns, LabelLayout::ring, LabelLayout::free}) {
        LabelSheet sheet;
        sheet.sizeMm = {40, 30};
        sheet.layout = layout;
        std::vector<LabelBox> labels = someLabels(256, random); // as many as a figure may have, on a stamp
        for (LabelBox& label : labels) {
            label.anchorMm = {between(0, 40, random), between(0, 30, random)};
        }
        labels[1].anchorMm = labels[0].anchorMm; // two names of one point
        labels[2].sizeMm = {400, 300};
        EXPECT_EQ(layOutLabels(sheet, labels).size(), labels.size());
    }
}

TEST(AnnotationLayout, PointsGoThroughTheCamera) {
    Camera camera;
    camera.direction = {0, 1, 0};
    camera.up = {0, 0, 1};
    camera.targetMm = {10, 20, 30};
    camera.heightMm = 100;
    const Output output{200, 100, 300, false};
    EXPECT_EQ(paperPerPatient(camera, output), 1);
    // Looking along +y with z up, right is +x: direction x up.
    EXPECT_EQ(onSheet(camera, output, {10, 20, 30}), glm::dvec2(100, 50));
    EXPECT_EQ(onSheet(camera, output, {60, 999, 55}), glm::dvec2(150, 25));
    EXPECT_EQ(onSheet(camera, output, {111, 20, 30}), std::nullopt) << "beside the sheet";
    camera.projection = Projection::perspective;
    camera.fovDeg = 90; // the eye is 50 mm before the target
    EXPECT_EQ(onSheet(camera, output, {10, -40, 30}), std::nullopt) << "behind the eye";
    const auto far = onSheet(camera, output, {60, 70, 30}); // twice as far as the target
    ASSERT_TRUE(far);
    EXPECT_NEAR(far->x, 125, 1e-9);
}

TEST(Annotation, HasUsualSizesAndRoundBars) {
    Annotation annotation;
    EXPECT_EQ(sizePtOf(annotation), 8);
    annotation.kind = "title";
    EXPECT_EQ(sizePtOf(annotation), 14);
    annotation.sizePt = 5;
    EXPECT_EQ(sizePtOf(annotation), 5);
    EXPECT_EQ(roundBarMm(250), 50);
    EXPECT_EQ(roundBarMm(249), 20);
    EXPECT_EQ(roundBarMm(100), 20);
    EXPECT_EQ(roundBarMm(5), 1);
    EXPECT_DOUBLE_EQ(roundBarMm(0.6), 0.1);
    EXPECT_EQ(lengthText(50), "50\u00A0mm");
    EXPECT_EQ(lengthText(2.5), "2.5\u00A0mm");
    EXPECT_EQ(lengthText(0.2), "200\u00A0µm");
}

} // namespace
} // namespace limner
