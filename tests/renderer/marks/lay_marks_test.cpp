#include "renderer/marks/lay_marks.h"

#include "support/mark_crowd.h"

#include <gtest/gtest.h>

#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace limner {
namespace {

using testing::addStroke;
using testing::crowd;
using testing::paper;

constexpr int kSize = 64;
constexpr double kPi = std::numbers::pi;

Picture laid(const Marks& marks, glm::ivec2 size = {kSize, kSize}) {
    Picture picture(size);
    layMarks(marks, size, {{0, 0}, size}, picture);
    return picture;
}

double area(const Picture& picture) {
    double sum = 0;
    for (std::size_t i = 3; i < picture.rgba().size(); i += 4)
        sum += picture.rgba()[i];
    return sum;
}

bool equal(const Picture& a, const Picture& b) { return std::ranges::equal(a.rgba(), b.rgba()); }

double largestDifference(const Picture& a, const Picture& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.rgba().size(); ++i)
        largest = std::max(largest, static_cast<double>(std::abs(a.rgba()[i] - b.rgba()[i])));
    return largest;
}

/// Share of a pixel inside of a shape, by 64 x 64 places.
template <typename Inside>
double sampledShare(int x, int y, Inside inside) {
    constexpr int kPlaces = 64;
    int count = 0;
    for (int j = 0; j < kPlaces; ++j)
        for (int i = 0; i < kPlaces; ++i)
            count += inside(glm::dvec2(x + (i + 0.5) / kPlaces, y + (j + 0.5) / kPlaces)) ? 1 : 0;
    return count / static_cast<double>(kPlaces * kPlaces);
}

template <typename Inside>
double worstShare(const Picture& picture, Inside inside) {
    double worst = 0;
    for (int y = 0; y < picture.size().y; ++y)
        for (int x = 0; x < picture.size().x; ++x)
            worst = std::max(worst, std::abs(picture.pixel(x, y)[3] - sampledShare(x, y, inside)));
    return worst;
}

double distanceToSegment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
    const double t = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
    return glm::distance(p, a + t * (b - a));
}

TEST(LayMarks, DotsCoverTheirAreaWhereverTheyLie) {
    for (const float radius : {0.01F, 0.05F, 0.2F, 0.37F, 0.5F, 0.75F, 1.0F, 1.49F, 1.51F, 2.0F, 3.3F, 10.0F, 20.0F})
        for (const glm::vec2 place : {glm::vec2(32, 32), glm::vec2(31.5F, 30.5F), glm::vec2(30.27F, 33.81F)}) {
            Marks marks = paper(kSize);
            marks.groups[0].dots.push_back({place, 0, radius, 1, {0, 0, 0}});
            const double wanted = kPi * radius * radius;
            EXPECT_NEAR(area(laid(marks)) / wanted, 1, radius < 1.5F ? 0.003 : (radius < 2 ? 0.02 : 0.006))
                << radius << ' ' << place.x;
        }
}

TEST(LayMarks, APixelsShareOfADotIsItsAreas) {
    for (const float radius : {0.4F, 0.8F, 1.4F, 1.6F, 2.3F, 6.0F}) {
        Marks marks = paper(kSize);
        const glm::dvec2 place(30.3, 33.6);
        marks.groups[0].dots.push_back({place, 0, radius, 1, {0, 0, 0}});
        // Small ones lie on 32nds of a pixel; the edge of large ones is straight within a pixel.
        EXPECT_LT(worstShare(laid(marks), [&](glm::dvec2 p) { return glm::distance(p, place) < radius; }),
                  radius < 1.5F ? 0.03 : 0.05)
            << radius;
    }
}

TEST(LayMarks, StrokesCoverTheirAreaAtEveryAngle) {
    for (const float width : {0.1F, 0.4F, 0.8F, 1.2F, 2.0F, 5.0F})
        for (int degrees = 0; degrees < 180; degrees += 15) {
            const auto angle = static_cast<float>(degrees * kPi / 180);
            for (const float length : {0.7F, 4.0F, 25.0F}) {
                // Thin short lines cover their area in the mean over where they lie.
                const glm::vec2 along(std::cos(angle), std::sin(angle));
                double mean = 0;
                for (int i = 0; i < 64; ++i) {
                    Marks marks = paper(kSize);
                    const glm::vec2 a(31 + static_cast<float>(i % 8) / 8, 31 + static_cast<float>(i / 8) / 8);
                    addStroke(marks.groups[0], {{a, width}, {a + along * length, width}});
                    mean += area(laid(marks)) / 64;
                }
                EXPECT_NEAR(mean / (width * length + kPi * width * width / 4), 1, 0.01)
                    << width << ' ' << degrees << ' ' << length;
            }
        }
}

TEST(LayMarks, APixelsShareOfAStrokeIsItsAreas) {
    const std::vector<glm::dvec2> places{{10.2, 50.1}, {30.4, 12.3}, {33.9, 44.4}, {55.6, 40.2}, {57.1, 20.8}};
    for (const float width : {0.5F, 1.0F, 3.0F, 8.0F}) {
        Marks marks = paper(kSize);
        std::vector<StrokePoint> points;
        for (const glm::dvec2& place : places)
            points.push_back({place, width});
        addStroke(marks.groups[0], points);
        const auto inside = [&](glm::dvec2 p) {
            for (std::size_t i = 1; i < places.size(); ++i)
                if (distanceToSegment(p, places[i - 1], places[i]) < 0.5 * width)
                    return true;
            return false;
        };
        EXPECT_LT(worstShare(laid(marks), inside), 0.05) << width;
    }
}

TEST(LayMarks, JointsAreNoDarkerThanTheRest) {
    Marks whole = paper(kSize);
    addStroke(whole.groups[0], {{{5.3F, 9.1F}, 2.5F}, {{55.3F, 49.1F}, 2.5F}}, 0.5F);
    Marks pieces = paper(kSize);
    std::vector<StrokePoint> points;
    for (int i = 0; i <= 40; ++i)
        points.push_back({glm::vec2(5.3F, 9.1F) + glm::vec2(50, 40) * (static_cast<float>(i) / 40), 2.5F});
    addStroke(pieces.groups[0], points, 0.5F);
    EXPECT_LT(largestDifference(laid(whole), laid(pieces)), 1e-4);
    float most = 0;
    const Picture picture = laid(pieces);
    for (std::size_t i = 3; i < picture.rgba().size(); i += 4)
        most = std::max(most, picture.rgba()[i]);
    EXPECT_NEAR(most, 0.5, 1e-5);
}

TEST(LayMarks, AStrokeThatHardlyMovesIsADot) {
    Marks marks = paper(kSize);
    addStroke(marks.groups[0], {{{30.3F, 30.6F}, 2.4F}, {{30.32F, 30.6F}, 2.4F}, {{30.29F, 30.6F}, 2.4F}});
    EXPECT_NEAR(area(laid(marks)), kPi * 1.44, 0.06);
}

TEST(LayMarks, WidthRunsLinearlyAlongAStroke) {
    Marks marks = paper(kSize);
    addStroke(marks.groups[0], {{{4, 32}, 0}, {{60, 32}, 8}});
    const Picture picture = laid(marks);
    for (const int x : {12, 30, 50}) {
        double across = 0;
        for (int y = 0; y < kSize; ++y)
            across += picture.pixel(x, y)[3];
        EXPECT_NEAR(across, (x + 0.5 - 4) / 56 * 8, 0.01) << x;
    }
}

TEST(LayMarks, AnyTilingAndAnyNumberOfThreadsGivesTheSameBits) {
    for (const int colours : {1, 4}) {
        const Marks marks = crowd(4000, 400, colours);
        const glm::ivec2 size(230, 170); // other pixels to the mm across than down
        const Picture whole = laid(marks, size);
        EXPECT_GT(area(whole), 1000);
        {
            const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
            EXPECT_TRUE(equal(whole, laid(marks, size)));
        }
        for (const glm::ivec2 edge : {glm::ivec2(230, 33), glm::ivec2(31, 170), glm::ivec2(17, 5), glm::ivec2(1, 170)})
            for (int top = 0; top < size.y; top += edge.y)
                for (int left = 0; left < size.x; left += edge.x) {
                    const Tile tile{{left, top}, glm::min(edge, size - glm::ivec2(left, top))};
                    Picture part(tile.size);
                    layMarks(marks, size, tile, part);
                    for (int y = 0; y < tile.size.y; ++y)
                        ASSERT_TRUE(std::equal(part.pixel(0, y), part.pixel(0, y) + 4 * tile.size.x,
                                               whole.pixel(left, top + y)))
                            << colours << ' ' << left << ' ' << top + y;
                }
    }
}

TEST(LayMarks, MarksOfOneColourCountAlikeInAnyOrder) {
    Marks marks = crowd(3000, 0, 1);
    const Picture before = laid(marks, {200, 200});
    std::ranges::reverse(marks.groups[0].dots);
    std::ranges::reverse(marks.groups);
    EXPECT_LT(largestDifference(before, laid(marks, {200, 200})), 1e-5);
}

TEST(LayMarks, TheNearerDotOfAnotherColourLiesOverTheFarther) {
    for (const bool redFirst : {false, true}) {
        Marks marks = paper(kSize);
        const Dot red{{32, 32}, 5, 10, 1, {255, 0, 0}}; // nearer
        const Dot blue{{32, 32}, -5, 10, 1, {0, 0, 255}};
        marks.groups[0].dots = redFirst ? std::vector{red, blue} : std::vector{blue, red};
        const Picture picture = laid(marks);
        EXPECT_FLOAT_EQ(picture.pixel(32, 32)[0], 1);
        EXPECT_FLOAT_EQ(picture.pixel(32, 32)[2], 0);
        EXPECT_FLOAT_EQ(picture.pixel(32, 32)[3], 1);
    }
}

TEST(LayMarks, LaterGroupsLieOverEarlierOnes) {
    Marks marks = paper(kSize);
    marks.groups.resize(2);
    marks.groups[0].dots.push_back({{32, 32}, 5, 10, 1, {255, 0, 0}});
    marks.groups[1].dots.push_back({{32, 32}, -5, 10, 0.5F, {0, 0, 255}});
    const Picture picture = laid(marks);
    EXPECT_FLOAT_EQ(picture.pixel(32, 32)[0], 0.5F);
    EXPECT_FLOAT_EQ(picture.pixel(32, 32)[2], 0.5F);
}

TEST(LayMarks, LayersLieOverOrUnderTheMarks) {
    Marks marks = paper(kSize);
    marks.groups[0].dots.push_back({{32, 32}, 0, 30, 0.5F, {0, 255, 0}});
    const std::array<float, 4> layer{0.6F, 0, 0, 0.75F};
    for (const MarkOrder order : {MarkOrder::underLayers, MarkOrder::overLayers}) {
        marks.order = order;
        Picture picture({kSize, kSize});
        std::copy(layer.begin(), layer.end(), picture.pixel(32, 32));
        layMarks(marks, {kSize, kSize}, {{0, 0}, {kSize, kSize}}, picture);
        const bool under = order == MarkOrder::underLayers;
        EXPECT_FLOAT_EQ(picture.pixel(32, 32)[0], under ? 0.6F : 0.3F);
        EXPECT_FLOAT_EQ(picture.pixel(32, 32)[1], under ? 0.125F : 0.5F);
        EXPECT_FLOAT_EQ(picture.pixel(32, 32)[3], 0.875F);
        EXPECT_FLOAT_EQ(picture.pixel(30, 30)[3], 0.5F);
    }
}

TEST(LayMarks, WhatIsNotFiniteOrOffThePageIsLeftOut) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    Marks marks = paper(kSize);
    MarkGroup& group = marks.groups[0];
    for (const float bad : {kNan, kInfinity, -kInfinity, 1e30F, -1e30F, 500.0F, -500.0F}) {
        group.dots.push_back({{bad, 32}, 0, 1, 1, {0, 0, 0}});
        group.dots.push_back({{32, bad}, 0, 1, 1, {0, 0, 0}});
        addStroke(group, {{{bad, 3}, 1}, {{bad, 30}, 1}});
        addStroke(group, {{{3, bad}, 1}, {{30, bad}, 1}, {{40, bad}, 2}});
    }
    for (const float bad : {kNan, kInfinity, -1.0F, 0.0F}) {
        group.dots.push_back({{32, 32}, 0, bad, 1, {0, 0, 0}});
        addStroke(group, {{{3, 3}, bad}, {{30, 30}, bad}, {{40, 60}, bad}});
    }
    group.dots.push_back({{32, 32}, kNan, 1, 1, {9, 0, 0}});
    group.dots.push_back({{32, 32}, 0, 1, kNan, {0, 0, 0}});
    group.dots.push_back({{32, 32}, 0, 1, 0, {0, 0, 0}});
    group.strokes.push_back({1000, 5, 1, {0, 0, 0}}); // points that are not there
    EXPECT_EQ(area(laid(marks)), 0);
    addStroke(group, {{{3, 3}, 1}, {{3, 3}, 1}, {{3, 3}, 1}}); // no length: a dot
    EXPECT_NEAR(area(laid(marks)), kPi / 4, 0.01);
    layMarks(Marks{}, {kSize, kSize}, {{0, 0}, {0, 0}}, *std::make_unique<Picture>());
}

TEST(LayMarks, OnlyThePartOnThePageIsLaid) {
    Marks marks = paper(kSize);
    marks.groups[0].dots.push_back({{0, 32}, 0, 5, 1, {0, 0, 0}});
    marks.groups[0].dots.push_back({{64, 0}, 0, 1, 1, {0, 0, 0}});
    addStroke(marks.groups[0], {{{-40, 20}, 2}, {{100, 20}, 2}});
    EXPECT_NEAR(area(laid(marks)), kPi * 25 / 2 + kPi / 4 + 64 * 2, 0.3);
}

TEST(LayMarks, ALargePictureOfTheSameMarksShowsTheSameInk) {
    const Marks marks = crowd(500, 60, 1);
    const double small = area(laid(marks, {200, 200})) / (200 * 200);
    const double large = area(laid(marks, {1600, 1600})) / (1600 * 1600);
    EXPECT_NEAR(small / large, 1, 0.01);
}

} // namespace
} // namespace limner
