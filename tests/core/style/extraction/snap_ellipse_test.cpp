#include "core/style/extraction/find.h"
#include "support/drawn_pictures.h"

#include <gtest/gtest.h>

#include <limits>

namespace limner {
namespace {

using testing::LitBall;

constexpr double kPi = 3.14159265358979323846;

/// How far an ellipse's outline is from another's at most, in that one's radii.
double farthest(const Ellipse& got, const Ellipse& expected) {
    double most = 0;
    for (int i = 0; i < 360; ++i) {
        const double angle = i * kPi / 180;
        const double turn = got.degrees * kPi / 180;
        const glm::dvec2 on(got.semiAxes.x * std::cos(angle), got.semiAxes.y * std::sin(angle));
        const glm::dvec2 place = got.centre + glm::dvec2(on.x * std::cos(turn) - on.y * std::sin(turn),
                                                         on.x * std::sin(turn) + on.y * std::cos(turn));
        const glm::dvec2 n = testing::onDisk(expected, place);
        most = std::max(most, std::abs(glm::length(n) - 1));
    }
    return most;
}

/// Balls of a dozen lights and colours on paper, black and grey.
struct Case {
    Ellipse ellipse;
    LitBall ball;
    Rgba ground;
};

std::vector<Case> cases(double tilt) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    const auto next = [&] { return unit(random); };
    std::vector<Case> all;
    for (int i = 0; i < 12; ++i) {
        Case one;
        one.ellipse = {
            {160 + 6 * next(), 160 + 6 * next()}, {100, 100 * std::cos(tilt * kPi / 180)}, 180 * next() - 90};
        one.ball.light = {2 * next() - 1, 2 * next() - 1, 0.4 + next()};
        one.ball.bright = glm::dvec3(0.5 + 0.5 * next(), 0.5 + 0.5 * next(), 0.5 + 0.5 * next());
        one.ball.dark = one.ball.bright * (0.1 + 0.3 * next());
        one.ball.highlight = i % 3 == 0 ? 0.4 : 0;
        const Rgba grounds[] = {{0.95F, 0.93F, 0.86F}, {0.04F, 0.04F, 0.05F}, {0.4F, 0.5F, 0.6F}};
        one.ground = grounds[i % 3];
        all.push_back(one);
    }
    return all;
}

void expectSnapped(double tilt, double noise) {
    int i = 0;
    for (const Case& one : cases(tilt)) {
        ArtCut cut{testing::plainPicture(330, 330, one.ground), {0, 0}, 1};
        testing::drawBall(cut.picture, one.ellipse, one.ball);
        if (noise > 0) {
            testing::addNoise(cut.picture, noise, static_cast<unsigned>(i));
        }
        // A circle drawn by hand: up to a tenth too large or small, and beside the middle.
        const double angle = 2.4 * i;
        const Ellipse rough{one.ellipse.centre + 8.0 * glm::dvec2(std::cos(angle), std::sin(angle)),
                            glm::dvec2(100 * (0.92 + 0.015 * i)), 0};
        const auto snapped = snapEllipse(cut, rough);
        ASSERT_TRUE(snapped.has_value()) << i;
        EXPECT_LT(farthest(*snapped, one.ellipse), 0.005) << i;
        ++i;
    }
}

TEST(SnapEllipse, FollowsABallsEdge) { expectSnapped(0, 0); }
TEST(SnapEllipse, FollowsABallsEdgeInNoise) { expectSnapped(0, 0.05); }
TEST(SnapEllipse, FollowsATiltedDiskFromACircle) { expectSnapped(20, 0); }
TEST(SnapEllipse, FollowsATiltedDiskInNoise) { expectSnapped(20, 0.05); }

TEST(SnapEllipse, GivesPlacesOnTheArtwork) {
    // A cut whose pixels are three of the artwork's, that begins at (300, 600).
    ArtCut cut{testing::plainPicture(300, 260, {1, 1, 1}), {300, 600}, 3};
    const Ellipse inCut{{140.5, 130.25}, {90, 70}, 25};
    testing::drawBall(cut.picture, inCut, LitBall{});
    const Ellipse truth{cut.toArtwork(inCut.centre), inCut.semiAxes * 3.0, 25};
    Ellipse rough = truth;
    rough.semiAxes *= 1.08;
    rough.centre += glm::dvec2(12, -9);
    for (const double degrees : {25.0, 15.0, 205.0}) {
        rough.degrees = degrees;
        const auto snapped = snapEllipse(cut, rough);
        ASSERT_TRUE(snapped.has_value());
        EXPECT_LT(farthest(*snapped, truth), 0.005);
        EXPECT_NEAR(snapped->degrees, degrees > 100 ? 205 : 25, 1) << "the way to say it nearest to the rough one";
        EXPECT_NEAR(snapped->semiAxes.x, truth.semiAxes.x, 1.5);
    }
    // Asked for with its axes the other way round, it comes so.
    rough.degrees = 115;
    rough.semiAxes = {rough.semiAxes.y, rough.semiAxes.x};
    const auto turned = snapEllipse(cut, rough);
    ASSERT_TRUE(turned.has_value());
    EXPECT_NEAR(turned->degrees, 115, 1);
    EXPECT_NEAR(turned->semiAxes.x, truth.semiAxes.y, 1.5);
}

TEST(SnapEllipse, StaysOnItsBallBesideOthersAndText) {
    ArtCut cut{testing::plainPicture(420, 330, {0.96F, 0.94F, 0.9F}), {0, 0}, 1};
    const Ellipse ball{{160, 160}, {100, 100}, 0};
    testing::drawBall(cut.picture, {{340, 120}, {70, 70}, 0}, LitBall{{0.5, 0.2, 0.6}});
    testing::drawBall(cut.picture, ball, LitBall{});
    testing::drawText(cut.picture, "LITTLE", {60, 60}, 24, {1, 0}, {0, 0, 0});
    testing::drawStroke(cut.picture, {200, 320}, {150, 150}, 2, {0, 0, 0});
    const auto snapped = snapEllipse(cut, {{166, 155}, {106, 106}, 0});
    ASSERT_TRUE(snapped.has_value());
    EXPECT_LT(farthest(*snapped, ball), 0.01);
}

TEST(SnapEllipse, IsAbsentWhereThereIsNoEdge) {
    for (const double noise : {0.0, 0.01, 0.05, 0.2}) {
        ArtCut cut{testing::plainPicture(300, 300, {0.9F, 0.88F, 0.8F}), {0, 0}, 1};
        testing::addNoise(cut.picture, noise);
        EXPECT_FALSE(snapEllipse(cut, {{150, 150}, {80, 70}, 20}).has_value()) << noise;
    }
    ArtCut ramp{testing::plainPicture(300, 300, {}), {0, 0}, 1};
    for (int y = 0; y < 300; ++y) {
        for (int x = 0; x < 300; ++x) {
            ramp.picture.at(x, y) = {static_cast<float>(x) / 300, static_cast<float>(x) / 300, 0.5F};
        }
    }
    EXPECT_FALSE(snapEllipse(ramp, {{150, 150}, {80, 70}, 20}).has_value());
}

TEST(SnapEllipse, TakesNothingFromNonsense) {
    ArtCut cut{testing::plainPicture(100, 100, {1, 1, 1}), {0, 0}, 1};
    testing::drawBall(cut.picture, {{50, 50}, {30, 30}, 0}, LitBall{});
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Ellipse& rough :
         {Ellipse{{50, 50}, {0, 0}, 0}, Ellipse{{50, 50}, {30, -30}, 0}, Ellipse{{nan, 50}, {30, 30}, 0},
          Ellipse{{50, 50}, {30, nan}, 0}, Ellipse{{50, 50}, {30, 30}, nan}, Ellipse{{5000, 50}, {30, 30}, 0},
          Ellipse{{50, 50}, {1e12, 1e12}, 0}, Ellipse{{50, 50}, {0.5, 0.5}, 0}, Ellipse{{50, 50}, {40, 0.1}, 0}}) {
        EXPECT_FALSE(snapEllipse(cut, rough).has_value()) << rough.centre.x << " " << rough.semiAxes.x;
    }
    EXPECT_FALSE(snapEllipse(ArtCut{}, {{50, 50}, {30, 30}, 0}).has_value());
    EXPECT_FALSE(snapEllipse({testing::plainPicture(1, 1, {1, 1, 1}), {0, 0}, 1}, {{0.5, 0.5}, {4, 4}, 0}).has_value());
    // Mostly beyond the picture: what is seen of it is less than half.
    ArtCut corner{testing::plainPicture(100, 100, {1, 1, 1}), {0, 0}, 1};
    testing::drawBall(corner.picture, {{0, 0}, {40, 40}, 0}, LitBall{});
    EXPECT_FALSE(snapEllipse(corner, {{0, 0}, {42, 42}, 0}).has_value());
}

} // namespace
} // namespace limner
