#include "core/style/lit_sphere.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace limner {
namespace {

constexpr Rgba kForeign{1, 0, 1, 1};

/// A picture whose texels are `colourAt(x, y)` where the texel's centre lies inside the disk, foreign outside.
template <typename ColourAt>
std::vector<Rgba> ballPicture(int size, ColourAt colourAt) {
    std::vector<Rgba> pixels;
    for (int row = 0; row < size; ++row) {
        for (int column = 0; column < size; ++column) {
            const double x = (2.0 * column + 1) / size - 1;
            const double y = 1 - (2.0 * row + 1) / size;
            pixels.push_back(x * x + y * y <= 1 ? colourAt(x, y) : kForeign);
        }
    }
    return pixels;
}

template <typename ColourAt>
LitSphere makeBall(int size, ColourAt colourAt) {
    return {size, ballPicture(size, colourAt)};
}

TEST(LitSphere, TopRowIsUpwardNormal) {
    const LitSphere ball = makeBall(64, [](double x, double y) {
        return Rgba{static_cast<float>(0.5 + 0.5 * x), static_cast<float>(0.5 + 0.5 * y), 0, 1};
    });
    for (const auto& [x, y] : {std::pair(0.0, 0.9), {0.9, 0.0}, {-0.3, -0.6}, {0.0, 0.0}}) {
        EXPECT_NEAR(ball.at(x, y).r, 0.5 + 0.5 * x, 1e-6) << x << ' ' << y; // bilinear is exact on a plane
        EXPECT_NEAR(ball.at(x, y).g, 0.5 + 0.5 * y, 1e-6) << x << ' ' << y;
    }
}

TEST(LitSphere, LookupClampsToTheDisk) {
    const LitSphere ball = makeBall(64, [](double x, double y) {
        return Rgba{static_cast<float>(x * x + y * y) / 2, 0.25F, 0, 1};
    });
    for (int k = 0; k < 32; ++k) {
        const double angle = 2 * std::numbers::pi * k / 32;
        const Rgba rim = ball.at(std::cos(angle), std::sin(angle));
        const Rgba beyond = ball.at(3 * std::cos(angle), 3 * std::sin(angle));
        EXPECT_NEAR(rim.r, beyond.r, 1e-6);
        // The outermost trusted texel lies up to two texels (1/32 of the radius each) inside the rim; slope is 1.
        EXPECT_NEAR(rim.r, 0.5, 2.0 / 32);
        EXPECT_EQ(rim.g, 0.25F);
    }
}

TEST(LitSphere, ForeignColourAroundTheDiskIsNeverSeen) {
    constexpr Rgba kInside{0.2F, 0.4F, 0.6F, 1};
    for (const int size : {4, 5, 7, 8, 13, 64, 255, 512}) {
        // Only whole texels keep their colour in pictures cut out by hand: rim texels are foreign here as well.
        const LitSphere ball(size, ballPicture(size, [&](double x, double y) {
                                 const double reach = std::hypot(std::abs(x) + 1.0 / size, std::abs(y) + 1.0 / size);
                                 return size < 8 || reach <= 1 ? kInside : kForeign;
                             }));
        for (const Rgba& texel : ball.pixels()) {
            ASSERT_EQ(texel, kInside) << size;
        }
        EXPECT_EQ(ball.mean(), kInside) << size;
        EXPECT_FALSE(ball.hasDirectionalOpacity());
    }
}

TEST(LitSphere, MipsOfAConstantStayExactlyConstant) {
    constexpr Rgba kColour{0.3F, 0.7F, 0.1F, 0.37F};
    for (const int size : {512, 100, 37}) {
        std::shared_ptr<const LitSphere> level =
            std::make_shared<const LitSphere>(makeBall(size, [&](double, double) { return kColour; }));
        int expected = size;
        while (level != nullptr) {
            ASSERT_EQ(level->size(), expected);
            for (const Rgba& texel : level->pixels()) {
                ASSERT_EQ(texel, kColour) << size << " at " << level->size();
            }
            EXPECT_TRUE(level->hasDirectionalOpacity());
            level = level->half();
            expected /= 2;
        }
        EXPECT_EQ(expected, 0);
    }
}

TEST(LitSphere, HalvingAveragesFourTexelsAndWeightsColourWithAlpha) {
    const LitSphere ball = makeBall(16, [](double x, double) {
        // Columns in turn opaque red and nearly clear blue.
        const bool even = static_cast<int>(std::lround((x + 1) * 8 - 0.5)) % 2 == 0;
        return even ? Rgba{1, 0, 0, 0.75F} : Rgba{0, 0, 1, 0.25F};
    });
    const auto half = ball.half();
    ASSERT_EQ(half->size(), 8);
    const Rgba centre = half->pixels()[4 * 8 + 4];
    EXPECT_EQ(centre, (Rgba{0.75F, 0, 0.25F, 0.5F})); // (1 * 0.75 + 0 * 0.25) / (0.75 + 0.25)
}

TEST(LitSphere, ColourOfClearTexelsDoesNotBleed) {
    const LitSphere ball = makeBall(64, [](double x, double) { return x < 0 ? Rgba{1, 1, 0, 1} : Rgba{0, 0, 1, 0}; });
    std::shared_ptr<const LitSphere> level = ball.half();
    for (; level->size() > 1; level = level->half()) {
        for (const Rgba& texel : level->pixels()) {
            ASSERT_TRUE(texel.a == 0 || (texel.b == 0 && texel.r == 1)) << level->size();
        }
    }
    EXPECT_EQ(ball.mean().r, 1);
    EXPECT_EQ(ball.mean().b, 0);
    EXPECT_NEAR(ball.mean().a, 0.5, 1e-6); // by symmetry
}

TEST(LitSphere, MeanIsTheMeanOverTheDisk) {
    // Mean of r^2 over the unit disk is 1/2; the continued rim costs a little of it.
    const LitSphere ball = makeBall(256, [](double x, double y) {
        return Rgba{static_cast<float>(x * x + y * y), 0, 0, 1};
    });
    EXPECT_NEAR(ball.mean().r, 0.5, 2e-4); // rim of 1.5 texels of 128 moved inward: about 4 * (1.5/128)^2 / 2
    // Every level has the same mean: the filter neither loses nor finds anything at the rim.
    std::shared_ptr<const LitSphere> level = ball.half();
    for (; level->size() >= 8; level = level->half()) {
        // Weights of the rim texels are counted on 16 x 16 points per texel, afresh on each level.
        EXPECT_NEAR(level->mean().r, ball.mean().r, 0.04 / level->size()) << level->size();
    }
}

} // namespace
} // namespace limner
