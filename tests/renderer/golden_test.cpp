#include "core/project/sample_figures.h"
#include "renderer/backend.h"
#include "renderer/export/picture_file.h"
#include "renderer/marks/marked_picture.h"
#include "renderer/plan/planner.h"
#include "support/golden_cases.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace limner {
namespace {

namespace fs = std::filesystem;

constexpr int kPixels = 256; // big enough for teeth and vessels, small enough to keep beside the code

/// The picture before its background, 0..1, three numbers a pixel.
std::vector<float> draw(const Figure& figure) {
    Planner planner;
    Task task;
    PlanRequest request;
    request.size = {kPixels, kPixels};
    const auto plan = planner.plan(figure, request, task);
    const auto backend = makeCpuBackend();
    const PictureOptions options = pictureOptions(figure);
    Picture picture = MarkedPicture(*plan, *backend, task).render({{0, 0}, request.size}, task).picture;
    layAnnotations(annotationsOf(*plan, options), request.size, {{0, 0}, request.size}, picture);
    std::vector<float> rgb;
    const std::vector<std::uint8_t> rgba = toRgba8(picture, options);
    for (std::size_t i = 0; i < rgba.size(); ++i) {
        if (i % 4 != 3) {
            rgb.push_back(static_cast<float>(rgba[i]) / 255.0F);
        }
    }
    return rgb;
}

struct KeptPicture {
    int pixels = 0; ///< edge
    std::vector<float> rgb;
};

/// A square picture whose edge divides kPixels, else nothing in it.
KeptPicture readPng(const fs::path& path) {
    const auto file = OIIO::ImageInput::open(path.string());
    if (!file || file->spec().width != file->spec().height || kPixels % file->spec().width != 0 ||
        file->spec().nchannels != 3) {
        return {};
    }
    KeptPicture kept{file->spec().width, {}};
    kept.rgb.resize(static_cast<std::size_t>(kept.pixels) * static_cast<std::size_t>(kept.pixels) * 3);
    file->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, kept.rgb.data());
    return kept;
}

void writePng(const fs::path& path, const KeptPicture& picture) {
    const auto file = OIIO::ImageOutput::create(path.string());
    file->open(path.string(), OIIO::ImageSpec(picture.pixels, picture.pixels, 3, OIIO::TypeDesc::UINT8));
    file->write_image(OIIO::TypeDesc::FLOAT, picture.rgb.data());
    file->close();
}

/// Means over blocks: what was drawn at the size of what is kept.
KeptPicture reduced(const std::vector<float>& drawn, int pixels) {
    const int block = kPixels / pixels;
    KeptPicture mean{pixels, std::vector<float>(static_cast<std::size_t>(pixels * pixels) * 3)};
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        const int pixel = static_cast<int>(i / 3);
        const int at = pixel / kPixels / block * pixels + pixel % kPixels / block;
        mean.rgb[static_cast<std::size_t>(at) * 3 + i % 3] += drawn[i] / static_cast<float>(block * block);
    }
    return mean;
}

class Golden : public ::testing::TestWithParam<std::string> {};

TEST_P(Golden, LooksAsExpected) {
    const fs::path folder = testing::goldenFolder(GetParam());
    const auto tolerance = nlohmann::json::parse(std::ifstream(folder / "tolerance.json"));
    ASSERT_FALSE(tolerance.at("reason").get<std::string>().empty());
    const auto figure = testing::loadGolden(GetParam());
    if (!figure) {
        GTEST_SKIP() << "its scan is not here";
    }
    const KeptPicture seen = reduced(draw(*figure), tolerance.value("pixels", kPixels));
    if (std::getenv("LIMNER_UPDATE_GOLDEN") != nullptr) {
        writePng(folder / "expected.png", seen);
        GTEST_SKIP() << "written anew: look at it before it is kept";
    }
    const std::vector<float>& drawn = seen.rgb;
    const std::vector<float> expected = readPng(folder / "expected.png").rgb;
    ASSERT_EQ(drawn.size(), expected.size());
    double sum = 0;
    double largest = 0;
    std::size_t drawnOn = 0;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        const double d = std::abs(static_cast<double>(drawn[i]) - static_cast<double>(expected[i]));
        sum += d * d;
        largest = std::max(largest, d);
        drawnOn += drawn[i] < 0.9F ? 1 : 0;
    }
    EXPECT_GT(drawnOn, drawn.size() / 20) << "the picture is all but empty";
    const double rmse = std::sqrt(sum / static_cast<double>(drawn.size()));
    EXPECT_LE(rmse, tolerance.at("rmse").get<double>());
    EXPECT_LE(largest, tolerance.at("max").get<double>());
    if (HasFailure()) {
        const fs::path path = fs::temp_directory_path() / ("limner-golden-" + GetParam() + ".png");
        writePng(path, seen);
        std::cout << "what was drawn: " << path << '\n';
    }
}

TEST(GoldenCases, EverySampleFigureIsOne) {
    for (const SampleFigure& figure : sampleFigures()) {
        EXPECT_TRUE(fs::exists(testing::goldenFolder(figure.id) / "tolerance.json")) << figure.id;
    }
}

INSTANTIATE_TEST_SUITE_P(Figures, Golden, ::testing::ValuesIn(testing::goldenCases()), [](const auto& test) {
    std::string name = test.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

} // namespace
} // namespace limner
