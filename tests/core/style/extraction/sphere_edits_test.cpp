#include "core/style/extraction/sphere_edits.h"

#include "support/artworks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace limner {
namespace {

using namespace limner::testing;

SpherePtr plain() { return std::make_shared<const LitSphere>(plainStyle(128)); }

TEST(SphereEdits, NothingToDoGivesTheSameSphere) {
    const SpherePtr sphere = plain();
    EXPECT_EQ(edited(sphere, {}), sphere);
    EXPECT_EQ(withLightTurned(sphere, 360), sphere);
}

TEST(SphereEdits, TheLightTurnsCounterClockwise) {
    const SpherePtr sphere = plain();
    const double before = lightDirection(*sphere);
    EXPECT_NEAR(before, 180 - std::atan2(0.6, 0.5) * 180 / 3.14159265, 2);
    const SpherePtr turned = withLightTurned(sphere, 90);
    EXPECT_NEAR(lightDirection(*turned), before + 90 > 180 ? before + 90 - 360 : before + 90, 2);
    // What was to the right is now above.
    EXPECT_NEAR(turned->at(0, 0.6).r, sphere->at(0.6, 0).r, 0.01);
}

TEST(SphereEdits, ASphereLitFromTheFrontCountsAsLitFromAbove) {
    const LitSphere grey(32, std::vector<Rgba>(32 * 32, Rgba{0.5F, 0.5F, 0.5F, 1}));
    EXPECT_EQ(lightDirection(grey), 90);
}

TEST(SphereEdits, SymmetryMirrorsAboutTheLight) {
    const SpherePtr original = plain();
    std::vector<Rgba> pixels(original->pixels().begin(), original->pixels().end());
    pixels[128 * 40 + 100] = {1, 0, 0, 1};
    const SpherePtr sphere = std::make_shared<const LitSphere>(128, pixels);
    const SpherePtr even = withSymmetry(sphere);
    const double angle = lightDirection(*sphere) * 3.14159265358979 / 180;
    for (double across : {0.2, 0.5}) {
        const double x = 0.3 * std::cos(angle) - across * std::sin(angle);
        const double y = 0.3 * std::sin(angle) + across * std::cos(angle);
        const double mx = 0.3 * std::cos(angle) + across * std::sin(angle);
        const double my = 0.3 * std::sin(angle) - across * std::cos(angle);
        EXPECT_NEAR(even->at(x, y).g, even->at(mx, my).g, 0.01);
    }
}

TEST(SphereEdits, SmoothingTakesGrainAndLeavesSteps) {
    std::mt19937 random(3);
    std::normal_distribution<float> grain(0, 0.02F);
    std::vector<Rgba> pixels;
    for (int i = 0; i < 256 * 256; ++i) {
        const float base = i % 256 < 128 ? 0.2F : 0.8F;
        const float value = base + grain(random);
        pixels.push_back({value, value, value, 1});
    }
    const SpherePtr sphere = std::make_shared<const LitSphere>(256, pixels);
    const SpherePtr smooth = withSmoothing(sphere, 0.5);
    double before = 0;
    double after = 0;
    for (double x = -0.6; x < -0.2; x += 0.01) {
        before += std::pow(sphere->at(x, 0.1).r - 0.2, 2);
        after += std::pow(smooth->at(x, 0.1).r - 0.2, 2);
    }
    EXPECT_LT(after, 0.1 * before);
    EXPECT_NEAR(smooth->at(-0.03, 0).r, 0.2, 0.06);
    EXPECT_NEAR(smooth->at(0.03, 0).r, 0.8, 0.06);
}

TEST(SphereEdits, PaperTurnsWhite) {
    const Rgba paper{0.9F, 0.85F, 0.7F, 1};
    const Rgba white = withoutCast(paper, paper);
    EXPECT_NEAR(white.r, 1, 1e-5);
    EXPECT_NEAR(white.b, 1, 1e-5);
    const Rgba black = withoutCast({0, 0, 0, 1}, paper);
    EXPECT_EQ(black.r, 0);
    EXPECT_EQ(withoutCast({0.5F, 0.5F, 0.5F, 0.25F}, {0, 0, 0, 1}).a, 0.25F);
}

TEST(SphereEdits, AlphaFollowsTheAngleToTheViewer) {
    const SpherePtr sphere = withAlpha(plain(), {{0.2, 0.25}, {0.8, 0.75}});
    EXPECT_NEAR(sphere->at(0, 0).a, 0.25, 1e-6);
    EXPECT_NEAR(sphere->at(0.5, 0).a, 0.5, 0.01);
    EXPECT_NEAR(sphere->at(0, -0.95).a, 0.75, 1e-6);
    EXPECT_TRUE(sphere->hasDirectionalOpacity());
}

TEST(Swatches, EachColourStandsWhereItBelongs) {
    Swatches swatches;
    swatches.light = {0.9F, 0.8F, 0.7F, 1};
    swatches.mid = Rgba{0.5F, 0.3F, 0.4F, 1};
    swatches.shadow = {0.1F, 0.1F, 0.3F, 1};
    swatches.towardsLight = {-0.6, 0.6};
    SpherePtr sphere = sphereOfSwatches(swatches, 256);
    EXPECT_NEAR(sphere->at(-0.6, 0.6).r, 0.9, 0.01);
    EXPECT_NEAR(sphere->at(0.7, -0.7).b, 0.3, 0.01);
    EXPECT_NEAR(lightDirection(*sphere), 135, 2);
    swatches.rim = Rgba{1, 1, 1, 1};
    swatches.highlight = Rgba{0, 1, 0, 1};
    sphere = sphereOfSwatches(swatches, 256);
    EXPECT_GT(sphere->at(0.985, 0).b, 0.6);
    // Half way between the light and the viewer.
    EXPECT_GT(sphere->at(-0.33, 0.33).g, 0.95);
}

} // namespace
} // namespace limner
