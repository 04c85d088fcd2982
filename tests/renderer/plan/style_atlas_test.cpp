#include "renderer/plan/style_atlas.h"

#include <gtest/gtest.h>

#include <cmath>

namespace limner {
namespace {

std::shared_ptr<const LitSphere> makeSphere(int size, const std::vector<Rgba>& cycle) {
    std::vector<Rgba> pixels;
    for (int i = 0; i < size * size; ++i) {
        pixels.push_back(cycle[static_cast<std::size_t>(i) % cycle.size()]);
    }
    return std::make_shared<const LitSphere>(size, std::move(pixels));
}

Rgba texel(const StyleAtlas& atlas, std::size_t i) {
    const auto unit = [&](std::size_t channel) { return static_cast<float>(atlas.texels[4 * i + channel]) / 32767; };
    return {unit(0), unit(1), unit(2), unit(3)};
}

constexpr double kHalfStep = 0.5 / 32767 + 1e-7; // of 15 bits; the rest is float's own rounding

std::size_t texelsOf(const StyleAtlas& atlas) {
    return static_cast<std::size_t>(atlas.size) * static_cast<std::size_t>(atlas.size);
}

TEST(StyleAtlas, PackingKeepsEveryToneToItsLastBit) {
    std::vector<Rgba> tones;
    for (int k = 0; k < 4093; ++k) { // prime, so that every row meets other tones
        const float tone = static_cast<float>(k) / 4092;
        tones.push_back({tone, 1 - tone, tone * tone, 1});
    }
    const auto sphere = makeSphere(512, tones);
    const auto atlas = packStyles(std::vector{sphere}, 512);
    ASSERT_EQ(atlas->size, 512);
    ASSERT_EQ(atlas->slots, 1);
    EXPECT_FALSE(atlas->directionalOpacity);
    EXPECT_EQ(atlas->texels.size(), 4 * (texelsOf(*atlas) + 512 + 1));
    for (std::size_t i = 0; i < texelsOf(*atlas); ++i) {
        const Rgba wanted = sphere->pixels()[i];
        const Rgba got = texel(*atlas, i);
        ASSERT_NEAR(got.r, wanted.r, kHalfStep) << i;
        ASSERT_NEAR(got.g, wanted.g, kHalfStep) << i;
        ASSERT_NEAR(got.b, wanted.b, kHalfStep) << i;
        ASSERT_EQ(got.a, 1) << i;
    }
}

TEST(StyleAtlas, BlackAndWhiteAreExact) {
    const auto black = makeSphere(16, {{0, 0, 0, 1}});
    const auto white = makeSphere(16, {{1, 1, 1, 1}});
    const auto atlas = packStyles(std::vector{black, white}, 16);
    ASSERT_EQ(atlas->slots, 2);
    for (std::size_t i = 0; i < texelsOf(*atlas); ++i) {
        ASSERT_EQ(texel(*atlas, i), (Rgba{0, 0, 0, 1}));
        ASSERT_EQ(texel(*atlas, texelsOf(*atlas) + i), (Rgba{1, 1, 1, 1}));
    }
    EXPECT_EQ(atlas->mean[0], black->mean());
    EXPECT_EQ(atlas->mean[1], white->mean());
}

TEST(StyleAtlas, OneClearStyleIsSaid) {
    const auto solid = makeSphere(32, {{0.5F, 0.5F, 0.5F, 1}});
    const auto clear = makeSphere(32, {{0.5F, 0.5F, 0.5F, 0.25F}});
    const auto atlas = packStyles(std::vector{solid, clear}, 32);
    EXPECT_TRUE(atlas->directionalOpacity);
    EXPECT_EQ(texel(*atlas, 17).a, 1);
    EXPECT_NEAR(texel(*atlas, texelsOf(*atlas) + 17).a, 0.25, kHalfStep);
}

TEST(StyleAtlas, SizeIsTheNextPowerOfTwoWithinLimits) {
    const auto sphere = makeSphere(100, {{0.5F, 0.25F, 0.75F, 1}});
    for (const auto& [wished, size] :
         {std::pair(-3, 8), {1, 8}, {8, 8}, {9, 16}, {100, 128}, {512, 512}, {9000, 512}}) {
        const auto atlas = packStyles(std::vector{sphere}, wished);
        EXPECT_EQ(atlas->size, size) << wished;
        // A constant is the same at any size, up or down.
        for (std::size_t i = 0; i < texelsOf(*atlas); ++i) {
            ASSERT_EQ(texel(*atlas, i), texel(*atlas, 0)) << wished;
        }
    }
    EXPECT_EQ(packStyles({}, 64)->slots, 0);
}

TEST(StyleAtlas, CoarserLevelsAreHalvedInsideTheDisk) {
    std::vector<Rgba> stripes;
    for (int i = 0; i < 64 * 64; ++i) {
        stripes.push_back(i % 2 == 0 ? Rgba{1, 0, 0, 1} : Rgba{0, 0, 1, 1});
    }
    const auto sphere = std::make_shared<const LitSphere>(64, stripes);
    const auto atlas = packStyles(std::vector<std::shared_ptr<const LitSphere>>{sphere}, 16);
    const auto level = sphere->half()->half();
    ASSERT_EQ(atlas->size, 16);
    for (std::size_t i = 0; i < texelsOf(*atlas); ++i) {
        ASSERT_NEAR(texel(*atlas, i).r, level->pixels()[i].r, kHalfStep);
    }
    EXPECT_NEAR(texel(*atlas, 8 * 16 + 8).r, 0.5, kHalfStep);
}

TEST(StyleAtlas, AChainHalvesDownToTheMean) {
    std::vector<Rgba> stripes;
    for (int i = 0; i < 64 * 64; ++i) {
        stripes.push_back(i % 64 < 20 ? Rgba{1, 0, 0, 1} : Rgba{0, 0, 1, 1});
    }
    const auto sphere = std::make_shared<const LitSphere>(64, stripes);
    const auto plain = makeSphere(8, {{0.5F, 0.25F, 0.75F, 1}});
    const auto atlas = packStyles(std::vector<std::shared_ptr<const LitSphere>>{plain, sphere}, 32, AtlasLevels::all);
    ASSERT_EQ(atlas->levelStart.size(), 6U); // 32, 16, 8, 4, 2, 1
    ASSERT_EQ(atlas->pictures.size(), 6U);
    auto expected = sphere->half();
    std::size_t first = 0;
    for (std::size_t level = 0; level < 6; ++level) {
        const std::size_t side = std::size_t{32} >> level;
        ASSERT_EQ(static_cast<std::size_t>(atlas->levelStart[level]), first);
        EXPECT_EQ(atlas->pictures[level][1]->size(), static_cast<int>(side));
        for (std::size_t i = 0; i < side * side; ++i) {
            ASSERT_NEAR(texel(*atlas, first + i).g, 0.25, kHalfStep) << level;
            ASSERT_NEAR(texel(*atlas, first + side * side + i).r, expected->pixels()[i].r, kHalfStep) << level;
        }
        first += 2 * side * side;
        expected = expected->half();
    }
    EXPECT_NEAR(texel(*atlas, first - 1).r, sphere->mean().r, 0.02); // of means, each over its part of the disk
    EXPECT_EQ(atlas->texels.size(), 4 * (first + 2));
}

} // namespace
} // namespace limner
