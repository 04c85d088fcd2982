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

Rgba unpack(std::uint32_t texel) {
    return {static_cast<float>(texel & 2047U) / 2047, static_cast<float>((texel >> 11U) & 2047U) / 2047,
            static_cast<float>(texel >> 22U) / 1023, 1};
}

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
    EXPECT_TRUE(atlas->alpha.empty());
    EXPECT_EQ(atlas->rgb.size(), texelsOf(*atlas) + 512 + 1);
    for (std::size_t i = 0; i < texelsOf(*atlas); ++i) {
        const Rgba wanted = sphere->pixels()[i];
        const Rgba got = unpack(atlas->rgb[i]);
        // Half a step of 11 bits, and of 10 for blue; the rest is float's own rounding.
        ASSERT_NEAR(got.r, wanted.r, 0.5 / 2047 + 1e-7) << i;
        ASSERT_NEAR(got.g, wanted.g, 0.5 / 2047 + 1e-7) << i;
        ASSERT_NEAR(got.b, wanted.b, 0.5 / 1023 + 1e-7) << i;
    }
}

TEST(StyleAtlas, BlackAndWhiteAreExact) {
    const auto black = makeSphere(16, {{0, 0, 0, 1}});
    const auto white = makeSphere(16, {{1, 1, 1, 1}});
    const auto atlas = packStyles(std::vector{black, white}, 16);
    ASSERT_EQ(atlas->slots, 2);
    for (std::size_t i = 0; i < texelsOf(*atlas); ++i) {
        ASSERT_EQ(atlas->rgb[i], 0U);
        ASSERT_EQ(atlas->rgb[texelsOf(*atlas) + i], 0xffffffffU);
    }
    EXPECT_EQ(atlas->mean[0], black->mean());
    EXPECT_EQ(atlas->mean[1], white->mean());
}

TEST(StyleAtlas, AlphaIsThereForAllAsSoonAsOneStyleIsClear) {
    const auto solid = makeSphere(32, {{0.5F, 0.5F, 0.5F, 1}});
    const auto clear = makeSphere(32, {{0.5F, 0.5F, 0.5F, 0.25F}});
    const auto atlas = packStyles(std::vector{solid, clear}, 32);
    ASSERT_EQ(atlas->alpha.size(), atlas->rgb.size());
    EXPECT_EQ(atlas->alpha[17], 65535);
    EXPECT_EQ(atlas->alpha[texelsOf(*atlas) + 17], 16384); // round(0.25 * 65535)
}

TEST(StyleAtlas, SizeIsTheNextPowerOfTwoWithinLimits) {
    const auto sphere = makeSphere(100, {{0.5F, 0.25F, 0.75F, 1}});
    for (const auto& [wished, size] :
         {std::pair(-3, 8), {1, 8}, {8, 8}, {9, 16}, {100, 128}, {512, 512}, {9000, 512}}) {
        const auto atlas = packStyles(std::vector{sphere}, wished);
        EXPECT_EQ(atlas->size, size) << wished;
        // A constant is the same at any size, up or down.
        for (std::size_t i = 0; i < texelsOf(*atlas); ++i) {
            ASSERT_EQ(atlas->rgb[i], atlas->rgb[0]) << wished;
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
        ASSERT_NEAR(unpack(atlas->rgb[i]).r, level->pixels()[i].r, 0.5 / 2047 + 1e-7);
    }
    EXPECT_NEAR(unpack(atlas->rgb[8 * 16 + 8]).r, 0.5, 0.5 / 2047 + 1e-7);
}

} // namespace
} // namespace limner
