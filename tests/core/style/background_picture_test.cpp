#include "core/style/background_picture.h"

#include "core/base/error.h"
#include "core/project/archive.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>

namespace limner {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPlenty = std::size_t{1} << 30;

using Colour = std::function<glm::dvec4(int x, int y)>; ///< not premultiplied

/// Some colour that differs everywhere.
glm::dvec4 motley(int x, int y) {
    const auto wave = [](double a) { return 0.5 + 0.5 * std::sin(a); };
    return {wave(0.9 * x + 0.2 * y), wave(1.7 * y), wave(0.5 * x * y), 1};
}

/// A 16-bit PNG with alpha, or whatever the ending says. `tile`: edge of its tiles; 0: none.
fs::path write(const fs::path& path, glm::ivec2 size, const Colour& colour, int tile = 0) {
    OIIO::ImageSpec spec(size.x, size.y, 4, OIIO::TypeDesc::UINT16);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    spec.tile_width = spec.tile_height = tile;
    std::vector<float> numbers;
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const glm::dvec4 c = colour(x, y);
            for (int i = 0; i < 4; ++i) {
                numbers.push_back(static_cast<float>(c[i]));
            }
        }
    }
    const auto output = OIIO::ImageOutput::create(path.string());
    EXPECT_TRUE(output != nullptr && output->open(path.string(), spec) &&
                output->write_image(OIIO::TypeDesc::FLOAT, numbers.data()) && output->close());
    return path;
}

double channelOf(const CoveringCopy& copy, glm::ivec2 at, int channel) {
    return copy.rgba[static_cast<std::size_t>((at.y * copy.size.x + at.x) * 4 + channel)] / 65535.0;
}

/// Mean of the premultiplied colour over a rectangle of the source, by its share of every pixel.
glm::dvec4 areaMean(const Colour& colour, glm::dvec2 low, glm::dvec2 high) {
    glm::dvec4 sum(0);
    for (int y = static_cast<int>(std::floor(low.y)); y < high.y; ++y) {
        for (int x = static_cast<int>(std::floor(low.x)); x < high.x; ++x) {
            const double width = std::min(x + 1.0, high.x) - std::max<double>(x, low.x);
            const double height = std::min(y + 1.0, high.y) - std::max<double>(y, low.y);
            glm::dvec4 c = colour(x, y);
            c = {glm::dvec3(c) * c.a, c.a};
            sum += c * std::max(width, 0.0) * std::max(height, 0.0);
        }
    }
    return sum / ((high.x - low.x) * (high.y - low.y));
}

class BackgroundPictures : public ::testing::Test {
  protected:
    [[nodiscard]] fs::path path(const std::string& name) const { return folder_.path() / name; }
    TemporaryFolder folder_;
};

TEST_F(BackgroundPictures, AreReducedByTheMeanOfAreas) {
    const Colour colour = [](int x, int y) {
        glm::dvec4 c = motley(x, y);
        c.a = x % 3 == 0 ? 0.25 : 1;
        return c;
    };
    // Wider than the output and taller than it, whole ratios and broken ones; TIFF in tiles and PNG in rows.
    for (const glm::ivec2 size : {glm::ivec2(64, 32), glm::ivec2(37, 91), glm::ivec2(200, 150)}) {
        for (const char* name : {"a.png", "a.tif"}) {
            const BackgroundPicture picture(write(path(name), size, colour, name[2] == 't' ? 16 : 0));
            EXPECT_EQ(picture.size(), size);
            for (const glm::ivec2 output : {glm::ivec2(16, 16), glm::ivec2(23, 7), glm::ivec2(1, 1)}) {
                const auto copy = picture.covering(output, kPlenty);
                ASSERT_EQ(copy->size, output);
                EXPECT_NEAR(copy->texelsPerPixel, 1, 1e-12);
                EXPECT_NEAR(copy->first.x, 0, 1e-9);
                EXPECT_EQ(copy->rgba.size() * 2, picture.coveringBytes(output, kPlenty));
                // The source's pixels that fall on one of the output's; what does not fit is cut off evenly.
                const double scale =
                    std::min(static_cast<double>(size.x) / output.x, static_cast<double>(size.y) / output.y);
                const glm::dvec2 corner = (glm::dvec2(size) - glm::dvec2(output) * scale) * 0.5;
                for (int y = 0; y < output.y; ++y) {
                    for (int x = 0; x < output.x; ++x) {
                        const glm::dvec2 low = corner + glm::dvec2(x, y) * scale;
                        const glm::dvec4 mean = areaMean(colour, low, low + scale);
                        for (int c = 0; c < 4; ++c) {
                            ASSERT_NEAR(channelOf(*copy, {x, y}, c), mean[c], 4e-5) << name << " " << x << " " << y;
                        }
                    }
                }
            }
        }
    }
}

TEST_F(BackgroundPictures, SmallerThanTheOutputComeAsTheyAre) {
    const BackgroundPicture picture(write(path("a.png"), {8, 5}, motley));
    const auto copy = picture.covering({40, 40}, kPlenty); // 8 pixels of the output to one of the source
    ASSERT_EQ(copy->size, glm::ivec2(6, 5));               // 1.5 cut off on both sides: six are touched
    EXPECT_DOUBLE_EQ(copy->texelsPerPixel, 5.0 / 40);
    EXPECT_DOUBLE_EQ(copy->first.x, 0.5);
    EXPECT_DOUBLE_EQ(copy->first.y, 0);
    for (int y = 0; y < 5; ++y) {
        for (int x = 0; x < 6; ++x) {
            ASSERT_NEAR(channelOf(*copy, {x, y}, 0), motley(x + 1, y).r, 2e-5);
        }
    }
}

TEST_F(BackgroundPictures, KeepWithinTheirBytesAndTheLongestEdge) {
    const BackgroundPicture picture(write(path("a.png"), {300, 200}, motley));
    const auto copy = picture.covering({300, 200}, 8 * 100);
    EXPECT_LE(copy->rgba.size() * 2, 8U * 100);
    EXPECT_GE(copy->rgba.size() * 2, 8U * 80);
    EXPECT_EQ(copy->rgba.size() * 2, picture.coveringBytes({300, 200}, 8 * 100));
    const BackgroundPicture wide(
        write(path("wide.tif"), {20000, 2}, [](int x, int) { return glm::dvec4(x / 20000.0, 0, 0, 1); }));
    const auto strip = wide.covering({30000, 3}, kPlenty);
    EXPECT_EQ(strip->size.x, BackgroundPicture::kLongestCopy);
    EXPECT_NEAR(channelOf(*strip, {4096, 0}, 0), 0.5, 1e-3);
}

TEST_F(BackgroundPictures, DoNotDependOnWhatWasAskedBefore) {
    const fs::path file = write(path("a.png"), {120, 90}, motley);
    const BackgroundPicture used(file);
    for (int edge = 10; edge < 100; edge += 9) {
        static_cast<void>(used.covering({edge, edge}, kPlenty));
    }
    for (const int edge : {91, 10, 55, 10}) {
        EXPECT_EQ(used.covering({edge, edge}, kPlenty)->rgba,
                  BackgroundPicture(file).covering({edge, edge}, kPlenty)->rgba);
    }
    EXPECT_EQ(used.covering({10, 10}, kPlenty), used.covering({10, 10}, kPlenty)) << "read twice";
}

TEST_F(BackgroundPictures, BadOnesAreRefusedInOneLine) {
    const auto refused = [](const std::function<void()>& work, const std::string& word) {
        try {
            work();
            ADD_FAILURE() << word << " was taken";
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::badInput);
            const std::string line = error.what();
            EXPECT_NE(line.find(word), std::string::npos) << line;
            EXPECT_EQ(line.find('\n'), std::string::npos) << line;
        }
    };
    refused([&] { const BackgroundPicture picture(path("none.png")); }, "none.png");
    std::ofstream(path("text.png")) << "not a picture at all";
    refused([&] { const BackgroundPicture picture(path("text.png")); }, "text.png");
    const fs::path file = write(path("cut.png"), {400, 400}, motley);
    fs::resize_file(file, fs::file_size(file) / 2);
    const BackgroundPicture cut(file);
    refused([&] { static_cast<void>(cut.covering({40, 40}, kPlenty)); }, "cut.png");
    const BackgroundPicture gone(write(path("gone.png"), {40, 40}, motley));
    fs::remove(path("gone.png"));
    refused([&] { static_cast<void>(gone.covering({10, 10}, kPlenty)); }, "gone.png");
    write(path("gone.png"), {41, 40}, motley);
    refused([&] { static_cast<void>(gone.covering({10, 10}, kPlenty)); }, "gone.png");
}

} // namespace
} // namespace limner
