#include "core/style/png_writing.h"

#include "core/style/ball_picture.h"
#include "core/style/texture_tile.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>

#include <unistd.h>

namespace limner {
namespace {

namespace fs = std::filesystem;

class PngWriting : public ::testing::Test {
  protected:
    PngWriting() : folder_(fs::temp_directory_path() / ("limner-png-" + std::to_string(::getpid()))) {
        fs::create_directories(folder_);
    }
    ~PngWriting() override { fs::remove_all(folder_); }

    fs::path folder_;
};

Rgba fromSixteen(std::mt19937& random) {
    const auto value = [&] { return static_cast<float>(random() % 65536) / 65535; };
    return {value(), value(), value(), value()};
}

TEST_F(PngWriting, SixteenBitsComeBackBitForBitEvenWhereAllIsClear) {
    std::mt19937 random(3);
    std::vector<Rgba> pixels(37 * 37);
    for (Rgba& pixel : pixels) {
        pixel = fromSixteen(random);
    }
    for (std::size_t i = 0; i < pixels.size(); i += 7) {
        pixels[i].a = 0;
    }
    writeWholeFile(folder_ / "a.png", pngBytes({37, 37}, pixels));
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    const auto in = OIIO::ImageInput::open((folder_ / "a.png").string(), &config);
    ASSERT_NE(in, nullptr);
    EXPECT_EQ(in->spec().format, OIIO::TypeDesc::UINT16);
    std::vector<std::uint16_t> stored(pixels.size() * 4);
    ASSERT_TRUE(in->read_image(0, 0, 0, 4, OIIO::TypeDesc::UINT16, stored.data()));
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        EXPECT_EQ(stored[4 * i], std::lround(pixels[i].r * 65535));
        EXPECT_EQ(stored[4 * i + 3], std::lround(pixels[i].a * 65535));
    }
}

TEST_F(PngWriting, ASphereThatWasWrittenIsTheSameAgain) {
    std::mt19937 random(4);
    std::vector<Rgba> pixels(65 * 65);
    for (Rgba& pixel : pixels) {
        pixel = fromSixteen(random);
    }
    const LitSphere sphere(65, pixels);
    writeWholeFile(folder_ / "s.png", pngBytes(sphere));
    const Style again = loadStyle(folder_ / "s.png");
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        EXPECT_NEAR(again.sphere->pixels()[i].r, sphere.pixels()[i].r, 1e-6);
        EXPECT_NEAR(again.sphere->pixels()[i].a, sphere.pixels()[i].a, 1e-6);
    }
    EXPECT_EQ(pngBytes(*again.sphere), pngBytes(sphere)) << "saving again must not look like a change";
    writeWholeFile(folder_ / "t.png", pngBytes(*again.sphere));
    const Style third = loadStyle(folder_ / "t.png");
    EXPECT_TRUE(std::equal(third.sphere->pixels().begin(), third.sphere->pixels().end(), again.sphere->pixels().begin(),
                           again.sphere->pixels().end()));
    EXPECT_TRUE(fs::path(again.file).is_absolute());
}

TEST_F(PngWriting, ATileComesBack) {
    std::mt19937 random(5);
    std::vector<Rgba> factors(32 * 32);
    for (Rgba& factor : factors) {
        factor = fromSixteen(random);
        factor = {2 * factor.r, 2 * factor.g, 2 * factor.b, 1};
    }
    const TextureTile tile(32, factors);
    writeWholeFile(folder_ / "t.png", pngBytes(tile));
    const auto again = loadTextureTile(folder_ / "t.png");
    ASSERT_EQ(again->size(), 32);
    for (std::size_t i = 0; i < factors.size(); ++i) {
        EXPECT_NEAR(again->pixels()[i].r, factors[i].r, 1e-6);
        EXPECT_NEAR(again->pixels()[i].b, factors[i].b, 1e-6);
    }
    EXPECT_EQ(pngBytes(*again), pngBytes(tile));
}

TEST(BallPicture, IsOpaqueOnAClearGround) {
    const LitSphere red(64, std::vector<Rgba>(64 * 64, Rgba{1, 0, 0, 1}));
    constexpr int kSize = 50;
    const std::vector<Rgba> ball = ballPicture(red, kSize);
    ASSERT_EQ(ball.size(), std::size_t{kSize * kSize});
    double area = 0;
    for (const Rgba& pixel : ball) {
        area += pixel.a;
        EXPECT_EQ(pixel.a > 0 ? pixel.r : 0, pixel.a > 0 ? 1 : 0);
    }
    EXPECT_NEAR(area, 3.14159265 * kSize * kSize / 4, 0.002 * kSize * kSize);
    EXPECT_EQ(ball.front().a, 0);
    EXPECT_EQ(ball[kSize * kSize / 2 + kSize / 2].a, 1);
}

TEST(BallPicture, WhatIsClearShowsThePaper) {
    const LitSphere glass(64, std::vector<Rgba>(64 * 64, Rgba{0, 0, 1, 0.25F}));
    const Rgba middle = ballPicture(glass, 33)[33 * 16 + 16];
    EXPECT_NEAR(middle.r, 0.75, 1e-6);
    EXPECT_NEAR(middle.b, 1, 1e-6);
    EXPECT_EQ(middle.a, 1);
}

TEST(BallPicture, UpIsUp) {
    std::vector<Rgba> pixels(64 * 64, Rgba{0, 0, 0, 1});
    std::fill(pixels.begin(), pixels.begin() + 64 * 32, Rgba{1, 1, 1, 1});
    const std::vector<Rgba> ball = ballPicture(LitSphere(64, pixels), 20);
    EXPECT_GT(ball[20 * 4 + 10].r, 0.99);
    EXPECT_LT(ball[20 * 15 + 10].r, 0.01);
}

} // namespace
} // namespace limner
