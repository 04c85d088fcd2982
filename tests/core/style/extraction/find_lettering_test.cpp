#include "core/base/task.h"
#include "core/style/extraction/find.h"
#include "support/drawn_pictures.h"
#include "support/test_data.h"

#include <gtest/gtest.h>

#include <functional>

namespace limner {
namespace {

using testing::LitBall;

constexpr Rgba kPaper{0.95F, 0.93F, 0.87F};
constexpr Rgba kInk{0.05F, 0.05F, 0.06F};
const Ellipse kBall{{300, 260}, {170, 170}, 0};

ArtCut ballOnPaper(int width = 600, int height = 520) {
    ArtCut cut{testing::plainPicture(width, height, kPaper), {0, 0}, 1};
    testing::drawBall(cut.picture, kBall, LitBall{});
    testing::addNoise(cut.picture, 0.01);
    return cut;
}

bool inBall(int x, int y) {
    const glm::dvec2 on = testing::onDisk(kBall, {x + 0.5, y + 0.5});
    return glm::dot(on, on) <= 1;
}

struct Shares {
    double found = 0; ///< of the ink that was drawn
    double wrong = 0; ///< of all else
};

/// What of the strokes that `draw` adds is marked, and what else. What lies right beside a stroke counts as neither.
Shares sharesOf(const ArtCut& bare, const std::function<void(ArtPicture&)>& draw) {
    ArtCut cut = bare;
    draw(cut.picture);
    const Mask mask = findLettering(cut);
    EXPECT_EQ(mask.width, cut.picture.width);
    EXPECT_EQ(mask.values.size(), cut.picture.pixels.size());
    const auto changed = [&](int x, int y) {
        const Rgba& a = cut.picture.at(x, y);
        const Rgba& b = bare.picture.at(x, y);
        return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b);
    };
    int ink = 0;
    int found = 0;
    int rest = 0;
    int wrong = 0;
    for (int y = 3; y + 3 < cut.picture.height; ++y) {
        for (int x = 3; x + 3 < cut.picture.width; ++x) {
            if (changed(x, y) > 0.45F) {
                ++ink;
                found += mask.has(x, y) ? 1 : 0;
                continue;
            }
            bool beside = false;
            for (int k = 0; k < 49; ++k) {
                beside = beside || changed(x + k % 7 - 3, y + k / 7 - 3) > 0.02F;
            }
            if (!beside) {
                ++rest;
                wrong += mask.has(x, y) ? 1 : 0;
            }
        }
    }
    return {found / std::max(1.0, static_cast<double>(ink)), wrong / static_cast<double>(std::max(1, rest))};
}

TEST(FindLettering, FindsTextOverABallAndBesideIt) {
    const Shares shares = sharesOf(ballOnPaper(), [](ArtPicture& picture) {
        testing::drawText(picture, "FIXATINE", {215, 250}, 15, {1, 0}, kInk);
        testing::drawText(picture, "HALVA LEAF", {240, 330}, 15, glm::normalize(glm::dvec2(1, -0.4)), kInk);
        testing::drawText(picture, "TALE AFTM", {20, 60}, 16, {1, 0}, kInk);
        testing::drawText(picture, "VINE LINE", {580, 480}, 16, {0, -1}, kInk);
    });
    EXPECT_GT(shares.found, 0.95);
    EXPECT_LT(shares.wrong, 0.001);
}

TEST(FindLettering, FindsLeaderLinesIntoTheBall) {
    const Shares shares = sharesOf(ballOnPaper(), [](ArtPicture& picture) {
        testing::drawText(picture, "MANTLE", {15, 40}, 15, {1, 0}, kInk);
        testing::drawStroke(picture, {106, 36}, {260, 180}, 1.6, kInk);
        testing::drawText(picture, "FILAMENT", {450, 500}, 15, {1, 0}, kInk);
        testing::drawStroke(picture, {470, 480}, {400, 330}, 1.6, kInk);
    });
    EXPECT_GT(shares.found, 0.9);
    EXPECT_LT(shares.wrong, 0.001);
}

TEST(FindLettering, FindsLightTextOnADarkForm) {
    ArtCut cut{testing::plainPicture(500, 400, {0.12F, 0.1F, 0.1F}), {0, 0}, 1};
    testing::addNoise(cut.picture, 0.01);
    const Shares shares = sharesOf(cut, [](ArtPicture& picture) {
        testing::drawText(picture, "FINAL HELM", {120, 200}, 16, {1, 0}, {0.95F, 0.95F, 0.95F});
    });
    EXPECT_GT(shares.found, 0.95);
    EXPECT_LT(shares.wrong, 0.001);
}

/// Strokes along the ball's meridians, closer and thicker in the shade, broken here and there.
void drawHatching(ArtPicture& picture) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int line = 0; line < 56; ++line) {
        const double x = -0.97 + 1.94 * line / 55.0;
        for (double y = -0.95; y < 0.95; y += 0.03) {
            const double z2 = 1 - y * y;
            const glm::dvec2 from(x * std::sqrt(std::max(0.0, z2)), y);
            const glm::dvec2 to(x * std::sqrt(std::max(0.0, 1 - (y + 0.028) * (y + 0.028))), y + 0.028);
            const double dark =
                1 - std::max(0.0,
                             glm::dot(glm::normalize(glm::dvec3(-0.4, 0.5, 0.8)),
                                      glm::dvec3(from.x, -from.y, std::sqrt(std::max(0.0, 1 - glm::dot(from, from))))));
            if (unit(random) < 0.2 + 1.2 * dark) {
                testing::drawStroke(picture, kBall.centre + from * kBall.semiAxes, kBall.centre + to * kBall.semiAxes,
                                    0.7 + 1.6 * dark, kInk);
            }
        }
    }
}

TEST(FindLettering, HatchingStays) {
    ArtCut cut{testing::plainPicture(600, 520, kPaper), {0, 0}, 1};
    drawHatching(cut.picture);
    const Mask mask = findLettering(cut);
    int marked = 0;
    int all = 0;
    for (int y = 0; y < mask.height; ++y) {
        for (int x = 0; x < mask.width; ++x) {
            all += inBall(x, y) ? 1 : 0;
            marked += inBall(x, y) && mask.has(x, y) ? 1 : 0;
        }
    }
    EXPECT_LT(marked, 0.003 * all);
    // Letters in a clearing among it, as engravers set them.
    const Shares shares = sharesOf(cut, [](ArtPicture& picture) {
        testing::drawStroke(picture, {205, 285}, {385, 285}, 26, kPaper);
        testing::drawText(picture, "LAMINATE", {215, 293}, 16, {1, 0}, kInk);
    });
    EXPECT_LT(shares.wrong, 0.003);
    ArtCut lettered = cut;
    testing::drawStroke(lettered.picture, {205, 285}, {385, 285}, 26, kPaper);
    const ArtCut cleared = lettered;
    const Shares letters = sharesOf(cleared, [](ArtPicture& picture) {
        testing::drawText(picture, "LAMINATE", {215, 293}, 16, {1, 0}, kInk);
    });
    EXPECT_GT(letters.found, 0.9);
}

TEST(FindLettering, MarksNothingWhereNothingIsWritten) {
    const auto markedIn = [](const ArtCut& cut) {
        const Mask mask = findLettering(cut);
        return std::count_if(mask.values.begin(), mask.values.end(), [](std::uint8_t value) { return value >= 128; });
    };
    EXPECT_EQ(markedIn(ballOnPaper()), 0);
    for (const double noise : {0.0, 0.03, 0.2}) {
        ArtCut cut{testing::plainPicture(400, 300, kPaper), {0, 0}, 1};
        testing::addNoise(cut.picture, noise);
        EXPECT_LT(markedIn(cut), 120) << noise; // a thousandth
    }
    for (const auto& [width, height] : {std::pair(0, 0), std::pair(1, 1), std::pair(5, 400), std::pair(1500, 12)}) {
        ArtCut cut{testing::plainPicture(width, height, kPaper), {0, 0}, 1};
        EXPECT_EQ(markedIn(cut), 0);
        EXPECT_EQ(findLettering(cut).values.size(), cut.picture.pixels.size());
    }
    EXPECT_EQ(markedIn({testing::plainPicture(300, 300, {0, 0, 0, 0}), {0, 0}, 1}), 0);
}

/// Boxes on the plates of Gray's Anatomy: a label, or hatching without one.
struct Box {
    const char* file;
    int x;
    int y;
    int width;
    int height;
};

/// Share of a box's dark pixels that are marked; and of all its pixels.
std::pair<double, double> markedIn(const Artwork& artwork, const Mask& mask, const Box& box) {
    int dark = 0;
    int both = 0;
    int marked = 0;
    for (int y = box.y; y < box.y + box.height; ++y) {
        for (int x = box.x; x < box.x + box.width; ++x) {
            const Rgba& p = artwork.reduced().picture.at(x, y);
            const bool ink = std::max({p.r, p.g, p.b}) < 0.5F;
            dark += ink ? 1 : 0;
            both += ink && mask.has(x, y) ? 1 : 0;
            marked += mask.has(x, y) ? 1 : 0;
        }
    }
    return {both / std::max(1.0, static_cast<double>(dark)), marked / static_cast<double>(box.width * box.height)};
}

/// Calls `take(artwork, mask, box)` for each box whose plate is there, finding each plate's lettering once.
template <typename Take>
void forBoxes(const std::vector<Box>& boxes, const Take& take) {
    std::string open;
    std::optional<Artwork> artwork;
    Mask mask;
    for (const Box& box : boxes) {
        if (open != box.file) {
            open = box.file;
            const auto file = testing::testData("art/gray_" + open + ".jpg");
            artwork.reset();
            if (file) {
                Task task;
                artwork.emplace(*file, task);
                mask = findLettering(artwork->reduced());
            }
        }
        if (artwork) {
            take(*artwork, mask, box);
        }
    }
}

TEST(FindLettering, FindsLabelsOnThePlates) {
    const std::vector<Box> beside{{"hip_joint", 338, 120, 50, 18},       {"hip_joint", 338, 147, 105, 17},
                                  {"hip_joint", 137, 366, 96, 16},       {"hip_joint", 134, 401, 98, 16},
                                  {"hip_joint", 35, 52, 52, 32},         {"hip_joint", 195, 285, 45, 75}, // a line
                                  {"stomach", 60, 77, 68, 18},           {"stomach", 81, 252, 50, 18},
                                  {"heart_and_lungs", 432, 34, 160, 18}, {"heart_and_lungs", 270, 505, 90, 18},
                                  {"brain_sagittal", 252, 510, 88, 16},  {"back_muscles", 42, 867, 118, 20},
                                  {"cecum", 420, 260, 78, 28},           {"cecum", 303, 10, 140, 16},
                                  {"pelvis", 26, 440, 94, 14},           {"pelvis", 46, 530, 118, 16}};
    forBoxes(beside, [](const Artwork& artwork, const Mask& mask, const Box& box) {
        EXPECT_GT(markedIn(artwork, mask, box).first, 0.85) << box.file << " " << box.x << " " << box.y;
    });
    // Over a form the dark pixels are hatching too; of the box's area, letters take about a third.
    const std::vector<Box> over{{"hip_joint", 190, 13, 42, 14},        {"stomach", 243, 140, 48, 95},
                                {"heart_and_lungs", 285, 262, 62, 30}, {"heart_and_lungs", 272, 50, 56, 16},
                                {"back_muscles", 185, 462, 62, 34},    {"back_muscles", 428, 670, 85, 55}};
    forBoxes(over, [](const Artwork& artwork, const Mask& mask, const Box& box) {
        EXPECT_GT(markedIn(artwork, mask, box).second, 0.1) << box.file << " " << box.x << " " << box.y;
    });
}

TEST(FindLettering, LeavesThePlatesHatching) {
    const std::vector<Box> hatched{{"hip_joint", 340, 330, 60, 150},
                                   {"hip_joint", 190, 60, 80, 90},
                                   {"hip_joint", 190, 150, 100, 110},
                                   {"stomach", 300, 60, 80, 60},
                                   {"stomach", 60, 310, 90, 80},
                                   {"stomach", 320, 200, 60, 120},
                                   {"heart_and_lungs", 60, 360, 110, 160},
                                   {"heart_and_lungs", 450, 330, 90, 120},
                                   {"brain_sagittal", 40, 170, 90, 80},
                                   {"brain_sagittal", 430, 120, 120, 120},
                                   {"back_muscles", 230, 330, 120, 60},
                                   {"back_muscles", 560, 380, 100, 80},
                                   {"cecum", 30, 180, 60, 150},
                                   {"cecum", 120, 330, 100, 50},
                                   {"pelvis", 60, 60, 120, 150}};
    double marked = 0;
    double all = 0;
    forBoxes(hatched, [&](const Artwork& artwork, const Mask& mask, const Box& box) {
        const double share = markedIn(artwork, mask, box).second;
        EXPECT_LT(share, 0.04) << box.file << " " << box.x << " " << box.y;
        marked += share * box.width * box.height;
        all += box.width * box.height;
    });
    EXPECT_LE(marked, 0.005 * all);
}

} // namespace
} // namespace limner
