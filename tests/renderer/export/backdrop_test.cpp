// A picture behind the figure, in every way a figure leaves the program.
#include "core/base/error.h"
#include "core/project/archive.h"
#include "core/style/background_picture.h"
#include "gradient_backend.h"
#include "renderer/export/picture_file.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace limner {
namespace {

namespace fs = std::filesystem;
using testing::GradientBackend;

using Bytes = std::vector<std::uint8_t>;

/// Three numbers a pixel, or four with alpha.
std::shared_ptr<const BackgroundPicture> pictureOf(const fs::path& path, glm::ivec2 size, const Bytes& bytes) {
    const int channels = static_cast<int>(bytes.size()) / (size.x * size.y);
    OIIO::ImageSpec spec(size.x, size.y, channels, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    const auto output = OIIO::ImageOutput::create(path.string());
    EXPECT_TRUE(output != nullptr && output->open(path.string(), spec) &&
                output->write_image(OIIO::TypeDesc::UINT8, bytes.data()) && output->close());
    return std::make_shared<const BackgroundPicture>(path);
}

Bytes motley(glm::ivec2 size) {
    Bytes bytes;
    for (int i = 0; i < size.x * size.y * 3; ++i) {
        bytes.push_back(static_cast<std::uint8_t>((i * 53 + i / 7) % 256));
    }
    return bytes;
}

class Backdrops : public ::testing::Test {
  protected:
    [[nodiscard]] fs::path path(const std::string& name) const { return folder_.path() / name; }
    TemporaryFolder folder_;
};

TEST_F(Backdrops, ShowWhereTheFigureDoesNotCover) {
    const glm::ivec2 size(20, 12);
    const Bytes behind = motley(size);
    PictureOptions options;
    options.backgroundPicture = pictureOf(path("a.png"), size, behind);
    Task task;
    RenderPlan plan;
    plan.size = size;
    const Picture picture = GradientBackend().render(plan, {{0, 0}, size}, task).picture;
    const Bytes out = toRgba8(picture, options);
    for (int i = 0; i < size.x * size.y; ++i) {
        const float* figure = picture.rgba().data() + 4 * i;
        for (int c = 0; c < 3; ++c) {
            const auto at = static_cast<std::size_t>(3 * i + c);
            const double expected = 255 * figure[c] + (1 - figure[3]) * behind[at];
            ASSERT_NEAR(out[static_cast<std::size_t>(4 * i + c)], expected, 0.51 + 1e-3) << i;
        }
        ASSERT_EQ(out[static_cast<std::size_t>(4 * i + 3)], 255);
    }
}

TEST_F(Backdrops, ColourShowsWhereThePictureIsClear) {
    PictureOptions options;
    options.background = {0.2, 0.4, 0.6, 1};
    options.backgroundPicture = pictureOf(path("a.png"), {1, 1}, {255, 0, 0, 128});
    const Bytes out = toRgba8(Picture({3, 3}), options);
    const double alpha = 128.0 / 255;
    EXPECT_NEAR(out[0], 255 * (alpha + (1 - alpha) * 0.2), 0.51);
    EXPECT_NEAR(out[1], 255 * (1 - alpha) * 0.4, 0.51);
    EXPECT_NEAR(out[2], 255 * (1 - alpha) * 0.6, 0.51);
}

TEST_F(Backdrops, SmallPicturesAreEnlargedBetweenTheirPixels) {
    PictureOptions options;
    options.backgroundPicture = pictureOf(path("a.png"), {2, 2}, {0, 0, 0, 200, 200, 200, 0, 0, 0, 200, 200, 200});
    const Bytes out = toRgba8(Picture({8, 8}), options);
    // Pixel centres lie at (x + 0.5) / 4 - 0.5 texels: 0 left of the first, 200 right of the last, linear between.
    for (int x = 0; x < 8; ++x) {
        const double expected = 200 * std::clamp((x + 0.5) / 4 - 0.5, 0.0, 1.0);
        EXPECT_NEAR(out[static_cast<std::size_t>(4 * x)], expected, 0.51) << x;
    }
}

TEST_F(Backdrops, TransparentPicturesHaveNone) {
    PictureOptions options;
    options.transparent = true;
    options.backgroundPicture = pictureOf(path("a.png"), {2, 1}, {1, 2, 3, 4, 5, 6});
    EXPECT_EQ(toRgba8(Picture({4, 4}), options), Bytes(64, 0));
}

TEST_F(Backdrops, AreTheSameInBandsAndTiles) {
    RenderPlan plan;
    plan.size = {150, 203};
    PictureOptions options;
    options.backgroundPicture = pictureOf(path("a.png"), {311, 240}, motley({311, 240}));
    Task task;
    const GradientBackend backend;
    const Picture whole = backend.render(plan, {{0, 0}, plan.size}, task).picture;
    const Bytes expected = toRgba8(whole, options);
    options.tile = 37;
    exportPicture(plan, backend, path("out.png"), options, task);
    const auto in = OIIO::ImageInput::open(path("out.png").string());
    ASSERT_NE(in, nullptr);
    const int channels = in->spec().nchannels;
    Bytes read(static_cast<std::size_t>(150 * 203 * channels));
    ASSERT_TRUE(in->read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT8, read.data()));
    for (std::size_t i = 0; i < 150U * 203; ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            ASSERT_EQ(read[i * static_cast<std::size_t>(channels) + c], expected[i * 4 + c]) << i;
        }
    }
    // JPEG has no alpha, so it shows the backdrop though the figure asks for none.
    options.transparent = true;
    exportPicture(plan, backend, path("out.jpg"), options, task);
    const auto jpeg = OIIO::ImageInput::open(path("out.jpg").string());
    Bytes pixels(static_cast<std::size_t>(150 * 203 * 3));
    ASSERT_TRUE(jpeg->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, pixels.data()));
    double off = 0;
    for (std::size_t i = 0; i < 150U * 203; ++i) {
        off += std::abs(pixels[i * 3] - expected[i * 4]);
    }
    EXPECT_LT(off / (150 * 203), 12);
}

TEST_F(Backdrops, ADamagedPictureStopsTheExportAndLeavesNothing) {
    PictureOptions options;
    options.backgroundPicture = pictureOf(path("a.png"), {300, 300}, motley({300, 300}));
    fs::resize_file(path("a.png"), fs::file_size(path("a.png")) / 2);
    RenderPlan plan;
    plan.size = {30, 30};
    Task task;
    EXPECT_THROW(exportPicture(plan, GradientBackend(), path("out.png"), options, task), Error);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), {}), 1);
}

TEST(PictureOptionsOfAFigure, TakeThePictureOfAnImageOnly) {
    const TemporaryFolder folder;
    Figure figure;
    figure.background.rgba = {0.1, 0.2, 0.3, 1};
    figure.output.dpi = 77;
    figure.output.transparent = true;
    figure.background.picture = pictureOf(folder.path() / "a.png", {1, 1}, {1, 2, 3});
    EXPECT_EQ(pictureOptions(figure).backgroundPicture, nullptr);
    figure.background.kind = "image";
    EXPECT_EQ(pictureOptions(figure).backgroundPicture, figure.background.picture);
    EXPECT_EQ(pictureOptions(figure).background, figure.background.rgba);
    EXPECT_EQ(pictureOptions(figure).dpi, 77);
    EXPECT_TRUE(pictureOptions(figure).transparent);
}

} // namespace
} // namespace limner
