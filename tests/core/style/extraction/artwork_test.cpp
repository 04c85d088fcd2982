#include "core/style/extraction/artwork.h"

#include "core/base/error.h"
#include "core/base/task.h"
#include "core/project/archive.h"
#include "support/hand_written_pictures.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>

namespace limner {
namespace {

namespace fs = std::filesystem;

using Colour = std::function<Rgba(int x, int y)>;

constexpr double kWord = 1.0 / 65535;

/// Some colour that differs everywhere, a third of it half clear.
Rgba motley(int x, int y) {
    const auto wave = [](double a) { return static_cast<float>(0.5 + 0.5 * std::sin(a)); };
    return {wave(0.9 * x + 0.2 * y), wave(1.7 * y), wave(0.5 * x * y), x % 3 == 0 ? 0.5F : 1.0F};
}

/// Changes slowly: of a picture that is too large to be looked at pixel by pixel.
Rgba broad(int x, int y) {
    const auto slope = [](int at, int length) {
        return static_cast<float>(std::abs(at % (2 * length) - length)) / static_cast<float>(length);
    };
    return {slope(x, 290), slope(y, 230), slope(x + y, 630)};
}

ArtPicture pictureOf(int width, int height, const Colour& colour) {
    ArtPicture picture{width, height, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            picture.pixels.push_back(colour(x, y));
        }
    }
    return picture;
}

struct FileForm {
    OIIO::TypeDesc type = OIIO::TypeDesc::UINT16;
    int channels = 4;
    int tile = 0;
    const char* compression = "none";
};

fs::path write(const fs::path& path, const ArtPicture& picture, const FileForm& form = {}) {
    OIIO::ImageSpec spec(picture.width, picture.height, form.channels, form.type);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    spec.attribute("compression", form.compression);
    spec.tile_width = spec.tile_height = form.tile;
    const auto output = OIIO::ImageOutput::create(path.string());
    EXPECT_TRUE(output && output->open(path.string(), spec) &&
                output->write_image(OIIO::TypeDesc::FLOAT, picture.pixels.data(), sizeof(Rgba)) && output->close());
    return path;
}

/// An 8-bit TIFF, written row by row.
fs::path writeRows(const fs::path& path, glm::ivec2 size, const Colour& colour) {
    OIIO::ImageSpec spec(size.x, size.y, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("compression", "lzw");
    const auto output = OIIO::ImageOutput::create(path.string());
    EXPECT_TRUE(output && output->open(path.string(), spec));
    std::vector<Rgba> row(static_cast<std::size_t>(size.x));
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            row[static_cast<std::size_t>(x)] = colour(x, y);
        }
        EXPECT_TRUE(output->write_scanline(y, 0, OIIO::TypeDesc::FLOAT, row.data(), sizeof(Rgba)));
    }
    EXPECT_TRUE(output->close());
    return path;
}

/// Mean over a rectangle of places, colours weighted with alpha.
Rgba areaMean(const Colour& colour, glm::dvec2 low, glm::dvec2 high) {
    double sum[4] = {0, 0, 0, 0};
    double weight = 0;
    for (int y = static_cast<int>(std::floor(low.y)); y < high.y; ++y) {
        for (int x = static_cast<int>(std::floor(low.x)); x < high.x; ++x) {
            const double width = std::min(x + 1.0, high.x) - std::max<double>(x, low.x);
            const double height = std::min(y + 1.0, high.y) - std::max<double>(y, low.y);
            const double share = std::max(width, 0.0) * std::max(height, 0.0);
            const Rgba c = colour(x, y);
            sum[0] += share * c.a * c.r;
            sum[1] += share * c.a * c.g;
            sum[2] += share * c.a * c.b;
            sum[3] += share * c.a;
            weight += share;
        }
    }
    const auto mean = [&](int c) { return static_cast<float>(sum[c] / sum[3]); };
    return {mean(0), mean(1), mean(2), static_cast<float>(sum[3] / weight)};
}

double difference(const Rgba& a, const Rgba& b) {
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b), std::abs(a.a - b.a)});
}

void expectMeans(const ArtCut& cut, glm::ivec2 whole, const Colour& colour, double most) {
    for (int y = 0; y < cut.picture.height; ++y) {
        for (int x = 0; x < cut.picture.width; ++x) {
            const glm::dvec2 low = cut.toArtwork({x, y});
            const glm::dvec2 high = glm::dvec2(std::min<double>(cut.toArtwork({x + 1, y + 1}).x, whole.x),
                                               std::min<double>(cut.toArtwork({x + 1, y + 1}).y, whole.y));
            ASSERT_LT(difference(cut.picture.at(x, y), areaMean(colour, low, high)), most) << x << " " << y;
        }
    }
}

std::string refusal(const std::function<void()>& work, ErrorKind kind = ErrorKind::badInput) {
    try {
        work();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), kind) << error.what();
        const std::string line = error.what();
        EXPECT_EQ(line.find('\n'), std::string::npos) << line;
        return line;
    }
    ADD_FAILURE() << "was taken";
    return {};
}

class Artworks : public ::testing::Test {
  protected:
    [[nodiscard]] fs::path path(const std::string& name) const { return folder_.path() / name; }
    TemporaryFolder folder_;
    Task task_;
};

TEST_F(Artworks, ReducedCopyIsTheMeanOfAreas) {
    const fs::path file = write(path("a.tif"), pictureOf(2500, 61, motley));
    const Artwork artwork(file, task_);
    EXPECT_EQ(artwork.width(), 2500);
    EXPECT_EQ(artwork.height(), 61);
    EXPECT_EQ(artwork.file(), file);
    EXPECT_EQ(artwork.reduced().picture.width, Artwork::kReducedSide);
    EXPECT_EQ(artwork.reduced().picture.height, 50); // 49.97: the last row shows less than a whole one
    EXPECT_DOUBLE_EQ(artwork.reduced().scale, 2500.0 / 2048);
    expectMeans(artwork.reduced(), {2500, 61}, motley, 1e-4);
}

TEST_F(Artworks, SmallOnesAreNotReduced) {
    const Artwork artwork(write(path("a.png"), pictureOf(37, 23, motley)), task_);
    EXPECT_EQ(artwork.reduced().scale, 1);
    ASSERT_EQ(artwork.reduced().picture.width, 37);
    expectMeans(artwork.reduced(), {37, 23}, motley, kWord);
    const Artwork dot(write(path("dot.png"), pictureOf(1, 1, motley)), task_);
    EXPECT_EQ(dot.cut({0, 0, 1, 1}, 100, task_).picture.pixels.size(), 1U);
}

TEST_F(Artworks, CutsAreTheMeanOfAreas) {
    const Artwork file(write(path("a.tif"), pictureOf(301, 200, motley)), task_);
    const Artwork pasted(pictureOf(301, 200, motley), "pasted");
    for (const Artwork* artwork : {&file, &pasted}) {
        for (const ArtRect& rect : {ArtRect{0, 0, 301, 200}, ArtRect{17, 30, 200, 101}, ArtRect{300, 199, 1, 1}}) {
            for (const int longest : {1000, 100, 61, 7, 1}) {
                const ArtCut cut = artwork->cut(rect, longest, task_);
                const int side = std::max(rect.width, rect.height);
                EXPECT_EQ(std::max(cut.picture.width, cut.picture.height), std::min(side, longest));
                EXPECT_EQ(cut.origin, glm::dvec2(rect.x, rect.y));
                expectMeans(cut, {rect.x + rect.width, rect.y + rect.height}, motley, 1e-4);
            }
        }
    }
}

TEST_F(Artworks, CutsAreClippedToTheArtwork) {
    const Artwork artwork(pictureOf(50, 40, motley), "pasted");
    const ArtCut cut = artwork.cut({-20, 30, 30, 2000}, 100, task_);
    EXPECT_EQ(cut.origin, glm::dvec2(0, 30));
    EXPECT_EQ(cut.picture.width, 10);
    EXPECT_EQ(cut.picture.height, 10);
    constexpr int kMost = 2147483647;
    for (const ArtRect& rect : {ArtRect{50, 0, 10, 10}, ArtRect{-10, 0, 10, 10}, ArtRect{0, 0, 0, 5},
                                ArtRect{5, 5, -3, 4}, ArtRect{kMost, kMost, kMost, kMost}}) {
        EXPECT_TRUE(artwork.cut(rect, 100, task_).picture.empty());
    }
    EXPECT_EQ(artwork.cut({-kMost, -1, kMost, kMost}, 100, task_).picture.width, 0);
    EXPECT_EQ(artwork.cut({-1, -1, kMost, kMost}, 100, task_).picture.width, 50);
    EXPECT_EQ(artwork.cut({0, 0, 50, 40}, 0, task_).picture.width, 1);
    EXPECT_TRUE(Artwork(ArtPicture{}, "nothing").cut({0, 0, 9, 9}, 9, task_).picture.empty());
}

TEST_F(Artworks, OpaqueStaysOpaque) {
    const Artwork artwork(pictureOf(997, 613, broad), "pasted");
    for (const int longest : {500, 333, 100, 1}) {
        const ArtCut cut = artwork.cut({3, 5, 900, 600}, longest, task_);
        EXPECT_TRUE(
            std::all_of(cut.picture.pixels.begin(), cut.picture.pixels.end(), [](const Rgba& p) { return p.a == 1; }));
    }
}

TEST_F(Artworks, ClearPixelsLendNoColour) {
    const Colour half = [](int x, int) { return x % 2 == 0 ? Rgba{1, 0, 0, 0} : Rgba{0, 0.5F, 1, 1}; };
    const Artwork artwork(write(path("a.png"), pictureOf(64, 64, half)), task_);
    const Rgba mean = artwork.cut({0, 0, 64, 64}, 8, task_).picture.at(3, 3);
    EXPECT_LT(difference(mean, {0, 0.5F, 1, 0.5F}), 2e-5);
}

/// More pixels than are kept: cuts come from the file.
TEST_F(Artworks, CutsOfLargeOnesAreReadAgain) {
    const glm::ivec2 size(8300, 3900);
    static_assert(8300 * 3900 > Artwork::kKeptPixels);
    const fs::path file = writeRows(path("large.tif"), size, broad);
    const Artwork artwork(file, task_);
    constexpr double kByte = 0.6 / 255;
    for (const ArtRect& rect :
         {ArtRect{8200, 3800, 100, 100}, ArtRect{1000, 2000, 60, 40}, ArtRect{3, 100, 300, 300}}) {
        expectMeans(artwork.cut(rect, 60, task_), size, broad, kByte);
        expectMeans(artwork.cut(rect, 1000, task_), size, broad, kByte);
    }
    // Coarser than the reduced copy: the same, whichever it comes from.
    const ArtCut coarse = artwork.cut({100, 200, 8000, 3000}, 500, task_);
    EXPECT_EQ(coarse.picture.width, 500);
    for (const glm::ivec2 at : {glm::ivec2(0, 0), glm::ivec2(250, 99), glm::ivec2(499, 187)}) {
        const glm::dvec2 low = coarse.toArtwork(at);
        EXPECT_LT(difference(coarse.picture.at(at.x, at.y),
                             areaMean(broad, low, {std::min(low.x + 16, 8100.0), std::min(low.y + 16, 3200.0)})),
                  0.01);
    }
    fs::resize_file(file, fs::file_size(file) / 2);
    EXPECT_NE(refusal([&] {
                  static_cast<void>(artwork.cut({0, 3000, 100, 100}, 100, task_));
              }).find("large.tif"),
              std::string::npos);
    write(file, pictureOf(10, 10, broad));
    EXPECT_NE(refusal([&] {
                  static_cast<void>(artwork.cut({0, 0, 9, 9}, 9, task_));
              }).find("another picture"),
              std::string::npos);
}

TEST_F(Artworks, CanBeCancelled) {
    const fs::path file = write(path("a.tif"), pictureOf(50, 40, motley));
    const Artwork artwork(file, task_);
    Task cancelled;
    cancelled.cancel();
    refusal([&] { const Artwork never(file, cancelled); }, ErrorKind::cancelled);
    refusal([&] { static_cast<void>(artwork.cut({0, 0, 50, 40}, 10, cancelled)); }, ErrorKind::cancelled);
}

TEST_F(Artworks, BadFilesAreRefusedInOneLine) {
    const auto open = [&](const fs::path& file) { return refusal([&] { const Artwork artwork(file, task_); }); };
    EXPECT_NE(open(path("none.tif")).find("none.tif"), std::string::npos);
    EXPECT_NE(open(folder_.path()).find("cannot read the artwork"), std::string::npos);
    EXPECT_NE(open(testing::writeBytes(path("text.png"), "no picture")).find("text.png"), std::string::npos);
    EXPECT_NE(open(testing::writeBytes(path("empty.tif"), "")).find("empty.tif"), std::string::npos);
    for (const char* name : {"cut.png", "cut.jpg", "cut.tif", "zip.tif", "none.tif", "tile.tif", "ziptile.tif"}) {
        const std::string kind = name;
        const char* packing = kind[0] == 'z' ? "zip" : (kind[0] == 'n' ? "none" : "lzw");
        const int tile = kind.find("tile") != std::string::npos ? 64 : 0;
        const fs::path file = write(path(name), pictureOf(300, 300, motley), {OIIO::TypeDesc::UINT8, 3, tile, packing});
        fs::resize_file(file, fs::file_size(file) * 2 / 3);
        EXPECT_NE(open(file).find(name), std::string::npos);
    }
    // Damage within: whole tiles or strips of other bytes.
    for (const int tile : {0, 64}) {
        const fs::path file =
            write(path("hit.tif"), pictureOf(300, 300, broad), {OIIO::TypeDesc::UINT8, 3, tile, "zip"});
        std::fstream stream(file, std::ios::binary | std::ios::in | std::ios::out);
        stream.seekp(static_cast<std::streamoff>(fs::file_size(file) / 4));
        stream << std::string(fs::file_size(file) / 2, '\xff');
        stream.close();
        EXPECT_NE(open(file).find("hit.tif"), std::string::npos);
    }
    // Headers that promise what the file does not hold: all of 32-bit numbers, a picture that is merely too large.
    testing::HandWritten picture{100001, 2, 8, 1, {}};
    EXPECT_NE(open(testing::writeBytes(path("wide.tif"), testing::tiffOf(picture, 1))).find("100000"),
              std::string::npos);
    picture.width = picture.height = 90000;
    EXPECT_NE(open(testing::writeBytes(path("promise.tif"), testing::tiffOf(picture, 1))).find("promise.tif"),
              std::string::npos);
    picture.width = picture.height = 2147483647;
    EXPECT_NE(open(testing::writeBytes(path("most.tif"), testing::tiffOf(picture, 1))).find("most.tif"),
              std::string::npos);
}

} // namespace
} // namespace limner
