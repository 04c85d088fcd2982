#include "core/figure/figure_json.h"
#include "core/volume/phantom.h"
#include "renderer/backend.h"
#include "renderer/plan/planner.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace limner {
namespace {

namespace fs = std::filesystem;

constexpr int kPixels = 256; // big enough for teeth and vessels, small enough to keep beside the code
constexpr int kVoxels = 128;

std::string textOf(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

/// The figure of a case with the built-in head and the bundled styles in place.
Figure loadCase(const fs::path& folder) {
    Figure figure = readFigure(textOf(folder / "figure.json"), (folder / "figure.json").string());
    EXPECT_EQ(figure.volume->path, "builtin:head");
    static const auto head = makeHeadPhantom(kVoxels);
    figure.volume->data = head;
    for (StyleEntry& style : figure.styles) {
        const std::string id = style.file.substr(style.file.find(':') + 1);
        style.sphere = findBundledStyle(id)->sphere;
    }
    return figure;
}

/// The picture on white, 0..1, three numbers a pixel.
std::vector<float> draw(const Figure& figure) {
    Planner planner;
    Task task;
    PlanRequest request;
    request.size = {kPixels, kPixels};
    const auto plan = planner.plan(figure, request, task);
    const Picture picture = makeCpuBackend()->render(*plan, {{0, 0}, request.size}, task).picture;
    std::vector<float> rgb;
    for (std::size_t i = 0; i < picture.rgba().size(); i += 4) {
        for (std::size_t c = 0; c < 3; ++c) {
            rgb.push_back(picture.rgba()[i + c] + 1 - picture.rgba()[i + 3]);
        }
    }
    return rgb;
}

std::vector<float> readPng(const fs::path& path) {
    const auto file = OIIO::ImageInput::open(path.string());
    if (!file || file->spec().width != kPixels || file->spec().height != kPixels || file->spec().nchannels != 3) {
        return {};
    }
    std::vector<float> rgb(static_cast<std::size_t>(kPixels) * kPixels * 3);
    file->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, rgb.data());
    return rgb;
}

void writePng(const fs::path& path, const std::vector<float>& rgb) {
    const auto file = OIIO::ImageOutput::create(path.string());
    file->open(path.string(), OIIO::ImageSpec(kPixels, kPixels, 3, OIIO::TypeDesc::UINT8));
    file->write_image(OIIO::TypeDesc::FLOAT, rgb.data());
    file->close();
}

class Golden : public ::testing::TestWithParam<std::string> {};

TEST_P(Golden, LooksAsExpected) {
    const fs::path folder = fs::path(LIMNER_SOURCE_DIR) / "tests/golden" / GetParam();
    const auto tolerance = nlohmann::json::parse(textOf(folder / "tolerance.json"));
    ASSERT_FALSE(tolerance.at("reason").get<std::string>().empty());
    const std::vector<float> drawn = draw(loadCase(folder));
    if (std::getenv("LIMNER_UPDATE_GOLDEN") != nullptr) {
        writePng(folder / "expected.png", drawn);
        GTEST_SKIP() << "written anew: look at it before it is kept";
    }
    const std::vector<float> expected = readPng(folder / "expected.png");
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
        const fs::path seen = fs::temp_directory_path() / ("limner-golden-" + GetParam() + ".png");
        writePng(seen, drawn);
        std::cout << "what was drawn: " << seen << '\n';
    }
}

std::vector<std::string> cases() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(fs::path(LIMNER_SOURCE_DIR) / "tests/golden")) {
        if (fs::exists(entry.path() / "figure.json")) {
            names.push_back(entry.path().filename().string());
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

INSTANTIATE_TEST_SUITE_P(Figures, Golden, ::testing::ValuesIn(cases()), [](const auto& test) {
    std::string name = test.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

} // namespace
} // namespace limner
