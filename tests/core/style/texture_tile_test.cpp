#include "core/base/error.h"
#include "core/style/texture_tile.h"

#include <OpenImageIO/imageio.h>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <unistd.h>

namespace limner {
namespace {

namespace fs = std::filesystem;

class TextureFile : public ::testing::Test {
  protected:
    TextureFile() : folder_(fs::temp_directory_path() / ("limner-texture-" + std::to_string(getpid()))) {
        fs::create_directories(folder_);
    }
    ~TextureFile() override { fs::remove_all(folder_); }

    /// A 16-bit picture with the channels that `at(x, y)` gives.
    template <typename At>
    fs::path write(const std::string& name, glm::ivec2 size, At at) {
        const fs::path path = folder_ / name;
        std::vector<float> values;
        int channels = 0;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const std::vector<float> texel = at(x, y);
                channels = static_cast<int>(texel.size());
                values.insert(values.end(), texel.begin(), texel.end());
            }
        }
        OIIO::ImageSpec spec(size.x, size.y, channels, OIIO::TypeDesc::UINT16);
        spec.attribute("oiio:ColorSpace", "sRGB");
        spec.attribute("oiio:UnassociatedAlpha", 1);
        const auto output = OIIO::ImageOutput::create(path.string());
        fs::create_directories(path.parent_path());
        EXPECT_TRUE(output->open(path.string(), spec) && output->write_image(OIIO::TypeDesc::FLOAT, values.data()) &&
                    output->close());
        return path;
    }

    fs::path plain(const std::string& name, glm::ivec2 size) {
        return write(name, size, [](int, int) { return std::vector<float>{0.25F}; });
    }

    static std::string failureOf(const fs::path& file) {
        try {
            loadTextureTile(file);
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::badInput);
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
            return error.what();
        }
        return "read without complaint";
    }

    fs::path folder_;
};

TEST(TextureTile, IsBilinearAndRepeats) {
    std::vector<Rgba> pixels(16);
    for (std::size_t i = 0; i < 16; ++i) {
        pixels[i] = {static_cast<float>(i), 1, 2, 1};
    }
    const TextureTile tile(4, pixels);
    const auto centre = [](int texel) { return (texel + 0.5) / 4; };
    for (const double tiles : {0.0, 1.0, -1.0, 1024.0}) {
        EXPECT_EQ(tile.at(centre(0) + tiles, centre(0)).r, 0);
        EXPECT_EQ(tile.at(centre(2) + tiles, centre(1)).r, 6);
        EXPECT_EQ(tile.at(centre(2), centre(1) - tiles).r, 6);
        EXPECT_EQ(tile.at(centre(3), centre(3) + tiles).r, 15);
        EXPECT_EQ(tile.at(0.5 + tiles, centre(0)).r, 1.5F);
        // Across the seam: between the last column and the first, the last row and the first.
        EXPECT_EQ(tile.at(tiles, centre(1)).r, (7 + 4) / 2.0F);
        EXPECT_EQ(tile.at(centre(1), tiles).r, (13 + 1) / 2.0F);
        EXPECT_EQ(tile.at(tiles, tiles).r, (0 + 3 + 12 + 15) / 4.0F);
        EXPECT_EQ(tile.at(centre(3) + 0.0625 + tiles, centre(0)).r, 3 * 0.75F);
    }
    EXPECT_EQ(tile.at(0.3, 0.7).b, 2);
    for (const double strange : {1e300, -1e-300, std::numeric_limits<double>::infinity(), std::nan("")}) {
        EXPECT_TRUE(std::isfinite(tile.at(strange, strange).r));
    }
}

TEST_F(TextureFile, MidGreyIsOneAndWhiteTwo) {
    const auto tile = loadTextureTile(write("grey.png", {16, 16}, [](int x, int y) {
        return std::vector<float>{y == 0 ? 1.0F : 0.5F, x == 3 ? 0.0F : 0.5F, 0.25F};
    }));
    ASSERT_EQ(tile->size(), 16);
    const double step = 2 / 65535.0; // of 16 bits, doubled
    const Rgba usual = tile->pixels()[16 + 1];
    EXPECT_NEAR(usual.r, 1, step);
    EXPECT_NEAR(usual.g, 1, step);
    EXPECT_NEAR(usual.b, 0.5, step);
    EXPECT_EQ(usual.a, 1);
    EXPECT_EQ(tile->pixels()[0].r, 2);      // the top row comes first
    EXPECT_EQ(tile->pixels()[16 + 3].g, 0); // rows, then columns
    EXPECT_EQ(tile->at(0.5 / 16, 0.5 / 16).r, 2);
}

TEST_F(TextureFile, ClearTexelsLeaveColoursAsTheyAre) {
    const auto tile = loadTextureTile(write("clear.png", {16, 16}, [](int x, int) {
        return std::vector<float>{1, 0, 1, x == 0 ? 0.0F : 1.0F};
    }));
    EXPECT_EQ(tile->pixels()[0], (Rgba{1, 1, 1, 1}));
    EXPECT_EQ(tile->pixels()[1], (Rgba{2, 0, 2, 1}));
}

TEST_F(TextureFile, OtherSizesAreResampledWithoutASeam) {
    const auto wave = [](double x, double y) { return 0.5 + 0.25 * std::sin(2 * M_PI * x) * std::cos(2 * M_PI * y); };
    const auto tile = loadTextureTile(write("odd.png", {48, 48}, [&](int x, int y) {
        return std::vector<float>{static_cast<float>(wave((x + 0.5) / 48, (y + 0.5) / 48))};
    }));
    ASSERT_EQ(tile->size(), 64);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            const double u = (x + 0.5) / 64;
            const double v = (y + 0.5) / 64;
            // Linear interpolation errs by h^2 / 8 times the second derivative, along both axes, doubled as the factor.
            const double bound = 2 * 2 * std::pow(1 / 48.0, 2) / 8 * 0.25 * std::pow(2 * M_PI, 2) + 2 / 65535.0;
            ASSERT_NEAR(tile->at(u, v).r, 2 * wave(u, v), bound) << x << " " << y;
        }
    }
}

TEST_F(TextureFile, WhatIsNoTileIsRefusedInOneLine) {
    EXPECT_NE(failureOf(folder_ / "none.png").find("no such file"), std::string::npos);
    EXPECT_NE(failureOf(plain("wide.png", {32, 16})).find("not square"), std::string::npos);
    EXPECT_NE(failureOf(plain("small.png", {15, 15})).find("out of range"), std::string::npos);
    EXPECT_NE(failureOf(plain("large.png", {2049, 2049})).find("out of range"), std::string::npos);
    std::ofstream(folder_ / "text.png") << "not a picture";
    EXPECT_NE(failureOf(folder_ / "text.png").find("cannot read the texture"), std::string::npos);
    EXPECT_EQ(loadTextureTile(plain("least.png", {16, 16}))->size(), 16);
}

TEST_F(TextureFile, BundledOnesAreFoundByTheirId) {
    // In a process of its own, which has not looked for its resources yet.
    ::testing::GTEST_FLAG(death_test_style) = "threadsafe";
    EXPECT_EXIT(
        {
            setenv("LIMNER_RESOURCES", folder_.c_str(), 1);
            plain("textures/paper.png", {16, 16});
            plain("elsewhere.png", {16, 16});
            std::ofstream(folder_ / "textures/broken.png") << "not a picture";
            std::ofstream(folder_ / "textures/card.json") << "{}";
            const auto tile = findBundledTexture("paper");
            bool right = tile != nullptr && tile->size() == 16 && findBundledTexture("paper") == tile;
            for (const char* id : {"", "marble", "card", "../elsewhere", "paper.png"}) {
                right = right && findBundledTexture(id) == nullptr;
            }
            try {
                findBundledTexture("broken");
                right = false;
            } catch (const Error&) {
            }
            fs::remove_all(folder_); // this process ends without destructors
            std::_Exit(right ? 0 : 1);
        },
        ::testing::ExitedWithCode(0), "");
}

} // namespace
} // namespace limner
