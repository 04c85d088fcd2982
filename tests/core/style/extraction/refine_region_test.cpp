#include "core/base/error.h"
#include "core/base/task.h"
#include "core/style/extraction/find.h"
#include "support/drawn_pictures.h"

#include <gtest/gtest.h>

#include <limits>

namespace limner {
namespace {

using testing::LitBall;

/// A lasso drawn by hand around an ellipse: a wavy line somewhat outside it.
ArtPath lassoAround(const Ellipse& ellipse, double wider) {
    ArtPath lasso;
    for (int i = 0; i < 40; ++i) {
        const double angle = i * 6.2831853 / 40;
        const double wavy = wider * (1 + 0.06 * std::sin(3 * angle + 1));
        lasso.push_back(ellipse.centre + wavy * ellipse.semiAxes * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return lasso;
}

/// Share in common of what a mask and the ellipse (in the cut's pixels) cover.
double overlap(const Mask& mask, const Ellipse& ellipse) {
    int both = 0;
    int either = 0;
    for (int y = 0; y < mask.height; ++y) {
        for (int x = 0; x < mask.width; ++x) {
            const glm::dvec2 on = testing::onDisk(ellipse, {x + 0.5, y + 0.5});
            const bool inside = glm::dot(on, on) <= 1;
            both += inside && mask.has(x, y) ? 1 : 0;
            either += inside || mask.has(x, y) ? 1 : 0;
        }
    }
    return both / static_cast<double>(std::max(1, either));
}

TEST(RefineRegion, FindsTheFormInARoughLasso) {
    const Ellipse form{{310, 240}, {140, 100}, 0};
    Task task;
    for (const Rgba& ground : {Rgba{0.95F, 0.93F, 0.87F}, Rgba{0.1F, 0.12F, 0.2F}}) {
        ArtCut cut{testing::plainPicture(640, 480, ground), {0, 0}, 1};
        testing::drawBall(cut.picture, form, LitBall{});
        testing::addNoise(cut.picture, 0.03);
        const Mask mask = refineRegion(cut, lassoAround(form, 1.2), task);
        ASSERT_EQ(mask.width, 640);
        ASSERT_EQ(mask.values.size(), cut.picture.pixels.size());
        EXPECT_GT(overlap(mask, form), 0.95);
        EXPECT_EQ(refineRegion(cut, lassoAround(form, 1.2), task).values, mask.values) << "the same every time";
    }
}

TEST(RefineRegion, TakesPlacesOnTheArtwork) {
    const Ellipse form{{210, 140}, {80, 90}, 0};
    ArtCut cut{testing::plainPicture(400, 300, {0.9F, 0.9F, 0.9F}), {1000, 700}, 4};
    testing::drawBall(cut.picture, form, LitBall{});
    ArtPath lasso = lassoAround(form, 1.2);
    for (glm::dvec2& place : lasso) {
        place = cut.toArtwork(place);
    }
    Task task;
    EXPECT_GT(overlap(refineRegion(cut, lasso, task), form), 0.95);
}

TEST(RefineRegion, KeepsTheLargestPieceAndStaysWithinTheLasso) {
    const Ellipse large{{200, 200}, {110, 110}, 0};
    ArtCut cut{testing::plainPicture(640, 400, {0.95F, 0.95F, 0.95F}), {0, 0}, 1};
    testing::drawBall(cut.picture, large, LitBall{});
    testing::drawBall(cut.picture, {{365, 200}, {30, 30}, 0}, LitBall{}); // in the lasso too
    testing::drawBall(cut.picture, {{520, 200}, {80, 80}, 0}, LitBall{}); // outside
    const ArtPath lasso{{60, 60}, {420, 60}, {420, 340}, {60, 340}};
    Task task;
    const Mask mask = refineRegion(cut, lasso, task);
    ASSERT_FALSE(mask.empty());
    EXPECT_GT(overlap(mask, large), 0.95);
    for (int y = 0; y < mask.height; ++y) {
        for (int x = 445; x < mask.width; ++x) {
            ASSERT_FALSE(mask.has(x, y));
        }
    }
}

TEST(RefineRegion, IsEmptyWhereNothingStandsOut) {
    Task task;
    for (const double noise : {0.0, 0.02, 0.1}) {
        ArtCut cut{testing::plainPicture(400, 400, {0.9F, 0.87F, 0.8F}), {0, 0}, 1};
        testing::addNoise(cut.picture, noise);
        EXPECT_TRUE(refineRegion(cut, lassoAround({{200, 200}, {100, 100}, 0}, 1), task).empty()) << noise;
    }
}

TEST(RefineRegion, TakesNothingFromNonsense) {
    ArtCut cut{testing::plainPicture(200, 200, {1, 1, 1}), {0, 0}, 1};
    testing::drawBall(cut.picture, {{100, 100}, {60, 60}, 0}, LitBall{});
    Task task;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const ArtPath& lasso :
         {ArtPath{}, ArtPath{{100, 100}}, ArtPath{{50, 50}, {150, 150}}, ArtPath{{100, 100}, {101, 100}, {100, 101}},
          ArtPath{{nan, 10}, {50, 60}, {70, 20}}, ArtPath{{5000, 5000}, {5100, 5000}, {5050, 5100}},
          ArtPath{{-1e300, 0}, {1e300, 0}, {0, 1e300}}}) {
        EXPECT_TRUE(refineRegion(cut, lasso, task).empty());
    }
    EXPECT_TRUE(refineRegion(ArtCut{}, lassoAround({{100, 100}, {60, 60}, 0}, 1.2), task).empty());
    EXPECT_TRUE(
        refineRegion({testing::plainPicture(1, 1, {1, 1, 1}), {0, 0}, 1}, {{0, 0}, {1, 0}, {0, 1}}, task).empty());
    // The lasso may reach beyond the picture.
    const Mask mask = refineRegion(cut, {{-50, -50}, {250, -50}, {250, 250}, {-50, 250}}, task);
    EXPECT_GT(overlap(mask, {{100, 100}, {60, 60}, 0}), 0.9);
}

TEST(RefineRegion, CanBeCancelled) {
    ArtCut cut{testing::plainPicture(300, 300, {1, 1, 1}), {0, 0}, 1};
    testing::drawBall(cut.picture, {{150, 150}, {80, 80}, 0}, LitBall{});
    Task task;
    task.cancel();
    EXPECT_THROW(refineRegion(cut, lassoAround({{150, 150}, {80, 80}, 0}, 1.2), task), Error);
}

} // namespace
} // namespace limner
