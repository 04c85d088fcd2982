#include "core/base/error.h"
#include "core/base/task.h"
#include "core/style/extraction/find.h"
#include "support/drawn_pictures.h"
#include "support/test_data.h"

#include <gtest/gtest.h>

namespace limner {
namespace {

using testing::LitBall;

/// Share that two ellipses have in common of what either covers.
double overlap(const Ellipse& a, const Ellipse& b) {
    const double reach = std::max({a.semiAxes.x, a.semiAxes.y, b.semiAxes.x, b.semiAxes.y});
    int both = 0;
    int either = 0;
    for (int y = -60; y <= 60; ++y) {
        for (int x = -60; x <= 60; ++x) {
            const glm::dvec2 place = (a.centre + b.centre) * 0.5 + glm::dvec2(x, y) * reach / 30.0;
            const glm::dvec2 onA = testing::onDisk(a, place);
            const glm::dvec2 onB = testing::onDisk(b, place);
            const bool inA = glm::dot(onA, onA) <= 1;
            const bool inB = glm::dot(onB, onB) <= 1;
            both += inA && inB ? 1 : 0;
            either += inA || inB ? 1 : 0;
        }
    }
    return both / static_cast<double>(std::max(1, either));
}

/// The best of the things' overlaps with an ellipse.
double bestOverlap(const std::vector<RoundThing>& things, const Ellipse& ellipse) {
    double best = 0;
    for (const RoundThing& thing : things) {
        best = std::max(best, overlap(thing.ellipse, ellipse));
    }
    return best;
}

TEST(FindRoundThings, FindsBallsAndEggs) {
    ArtCut cut{testing::plainPicture(700, 500, {0.95F, 0.92F, 0.85F}), {0, 0}, 1};
    const Ellipse balls[] = {
        {{150, 150}, {90, 90}, 0}, {{430, 140}, {110, 80}, 30}, {{250, 380}, {60, 60}, 0}, {{560, 370}, {70, 95}, -20}};
    for (const Ellipse& ball : balls) {
        testing::drawBall(cut.picture, ball, LitBall{});
    }
    testing::addNoise(cut.picture, 0.03);
    Task task;
    const auto things = findRoundThings(cut, task);
    ASSERT_GE(things.size(), 4U);
    for (const Ellipse& ball : balls) {
        EXPECT_GT(bestOverlap({things.begin(), things.begin() + 4}, ball), 0.97);
    }
    for (std::size_t i = 0; i < things.size(); ++i) {
        EXPECT_GT(things[i].score, 0);
        EXPECT_LE(things[i].score, 1);
        EXPECT_TRUE(i == 0 || things[i].score <= things[i - 1].score);
    }
    EXPECT_EQ(findRoundThings(cut, task, 2).size(), 2U);
    // The same every time.
    const auto again = findRoundThings(cut, task);
    ASSERT_EQ(again.size(), things.size());
    for (std::size_t i = 0; i < things.size(); ++i) {
        EXPECT_EQ(again[i].ellipse, things[i].ellipse);
    }
}

TEST(FindRoundThings, GivesPlacesOnTheArtwork) {
    ArtCut cut{testing::plainPicture(300, 300, {0.1F, 0.1F, 0.12F}), {2000, 5000}, 7.5};
    const Ellipse inCut{{140, 160}, {80, 80}, 0};
    testing::drawBall(cut.picture, inCut, LitBall{});
    Task task;
    const auto things = findRoundThings(cut, task);
    ASSERT_FALSE(things.empty());
    EXPECT_GT(overlap(things[0].ellipse, {cut.toArtwork(inCut.centre), inCut.semiAxes * 7.5, 0}), 0.97);
}

TEST(FindRoundThings, ProposesNoneWithinAnother) {
    ArtCut cut{testing::plainPicture(400, 400, {1, 1, 1}), {0, 0}, 1};
    testing::drawBall(cut.picture, {{200, 200}, {150, 150}, 0}, LitBall{});
    testing::drawBall(cut.picture, {{180, 180}, {40, 40}, 0},
                      LitBall{{0.5, 0.5, 0.5}, {0.5, 0.6, 0.9}, {0.1, 0.1, 0.3}, 0});
    Task task;
    const auto things = findRoundThings(cut, task);
    ASSERT_FALSE(things.empty());
    for (std::size_t i = 1; i < things.size(); ++i) {
        const glm::dvec2 on = testing::onDisk(things[0].ellipse, things[i].ellipse.centre);
        EXPECT_GT(glm::length(on), 0.5) << i;
    }
}

TEST(FindRoundThings, FindsNothingWhereNothingIs) {
    Task task;
    for (const double noise : {0.0, 0.02, 0.15}) {
        ArtCut cut{testing::plainPicture(500, 400, {0.9F, 0.88F, 0.8F}), {0, 0}, 1};
        testing::addNoise(cut.picture, noise);
        EXPECT_TRUE(findRoundThings(cut, task).empty()) << noise;
    }
    for (const auto& [width, height] : {std::pair(0, 0), std::pair(1, 1), std::pair(3, 200), std::pair(2000, 5)}) {
        ArtCut cut{testing::plainPicture(width, height, {0.5F, 0.5F, 0.5F}), {0, 0}, 1};
        EXPECT_TRUE(findRoundThings(cut, task).empty());
    }
    ArtCut clear{testing::plainPicture(300, 300, {0.2F, 0.9F, 0.1F, 0}), {0, 0}, 1};
    EXPECT_TRUE(findRoundThings(clear, task).empty());
    // Disks without tone: coins, holes.
    ArtCut flat{testing::plainPicture(300, 300, {1, 1, 1}), {0, 0}, 1};
    testing::drawBall(flat.picture, {{150, 150}, {80, 80}, 0}, [](glm::dvec2) { return glm::dvec3(0.5); });
    for (const RoundThing& thing : findRoundThings(flat, task)) {
        EXPECT_LT(thing.score, 0.3);
    }
}

TEST(FindRoundThings, CanBeCancelled) {
    ArtCut cut{testing::plainPicture(300, 300, {1, 1, 1}), {0, 0}, 1};
    testing::drawBall(cut.picture, {{150, 150}, {80, 80}, 0}, LitBall{});
    Task task;
    task.cancel();
    EXPECT_THROW(findRoundThings(cut, task), Error);
}

/// What a person would outline on the plates: one of the first few proposals is it.
TEST(FindRoundThings, ProposesWhatAPersonSeesOnThePlates) {
    struct Seen {
        const char* file;
        std::vector<Ellipse> forms; ///< any of them
        double least;
    };
    const Seen plates[] = {
        {"arcimboldo_spring_oil.png", {{{221, 345}, {38, 48}, 0}, {{137, 242}, {22, 20}, 0}}, 0.5},
        {"durer_lion_gouache.png",
         {{{382, 240}, {70, 70}, 0}, {{545, 130}, {85, 85}, 0}, {{310, 85}, {75, 75}, 0}},
         0.6},
        {"gray_back_muscles.jpg", {{{275, 690}, {85, 95}, 0}, {{295, 835}, {75, 110}, 0}}, 0.5},
        {"gray_brain_sagittal.jpg", {{{270, 360}, {35, 55}, 0}, {{385, 430}, {45, 55}, 0}}, 0.4},
        {"gray_cecum.jpg", {{{243, 262}, {58, 66}, 0}, {{134, 129}, {65, 65}, 0}}, 0.6},
        {"gray_heart_and_lungs.jpg",
         {{{252, 240}, {40, 45}, 0}, {{505, 520}, {60, 60}, 0}, {{440, 240}, {65, 65}, 0}},
         0.5},
        {"gray_hip_joint.jpg", {{{354, 259}, {76, 78}, 0}, {{235, 200}, {45, 45}, 0}}, 0.6},
        {"gray_pelvis.jpg", {{{158, 170}, {145, 150}, 0}}, 0.6},
        {"gray_stomach.jpg", {{{80, 315}, {45, 42}, 0}, {{300, 185}, {75, 75}, 0}}, 0.5},
        {"hiroshige_horse_mackerel_woodblock.png", {{{410, 420}, {60, 45}, 0}, {{134, 130}, {45, 50}, 0}}, 0.45},
        {"renoir_girls_at_piano_oil.png", {{{110, 320}, {50, 50}, 0}, {{180, 390}, {55, 50}, 0}}, 0.45},
    };
    for (const Seen& plate : plates) {
        const auto file = testing::testData(std::string("art/") + plate.file);
        if (!file) {
            continue;
        }
        Task task;
        const Artwork artwork(*file, task);
        auto things = findRoundThings(artwork.reduced(), task);
        things.resize(std::min<std::size_t>(things.size(), 6));
        double best = 0;
        for (const Ellipse& form : plate.forms) {
            best = std::max(best, bestOverlap(things, form));
        }
        EXPECT_GT(best, plate.least) << plate.file;
    }
}

TEST(FindRoundThings, FindsTheDisksAndEggsOfHaeckelsPlate) {
    const auto file = testing::testData("art/haeckel_plate85_ascidiae.jpg");
    if (!file) {
        return;
    }
    Task task;
    const Artwork artwork(*file, task);
    const auto things = findRoundThings(artwork.reduced(), task);
    const Ellipse forms[] = {{{194, 894}, {154, 154}, 0},  {{1049, 888}, {154, 154}, 0},
                             {{170, 1189}, {127, 127}, 0}, {{1070, 1191}, {127, 127}, 0},
                             {{204, 1535}, {151, 198}, 0}, {{1034, 1540}, {163, 194}, 0}};
    int found = 0;
    for (const Ellipse& form : forms) {
        found += bestOverlap(things, form) > 0.93 ? 1 : 0;
    }
    EXPECT_GE(found, 6);
}

} // namespace
} // namespace limner
