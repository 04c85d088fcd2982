#include "core/base/error.h"
#include "core/base/task.h"
#include "core/style/extraction/extract.h"
#include "core/style/style_files.h"
#include "support/artworks.h"
#include "support/test_data.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <iostream>

namespace limner {
namespace {

namespace fs = std::filesystem;
using namespace limner::testing;

TEST(ImportMatcap, EveryPictureOfTheTestDataIsABall) {
    const auto folder = testData("matcaps");
    if (!folder) {
        GTEST_SKIP() << "no matcaps: 36 pictures were not imported";
    }
    int count = 0;
    for (const auto& entry : fs::directory_iterator(*folder)) {
        if (entry.path().extension() == ".txt") {
            continue;
        }
        Task task;
        const SpherePtr sphere = importMatcap(entry.path(), task);
        EXPECT_GE(sphere->size(), 200) << entry.path();
        EXPECT_LE(sphere->size(), 1024) << entry.path();
        EXPECT_FALSE(sphere->hasDirectionalOpacity()) << entry.path();
        ++count;
    }
    EXPECT_EQ(count, 36);
}

TEST(ImportMatcap, UpIsUp) {
    const auto folder = testData("matcaps");
    if (!folder) {
        GTEST_SKIP() << "no matcaps: orientation was not checked on a real one";
    }
    Task task;
    const SpherePtr sphere = importMatcap(*folder / "blender_check_normal_plus_y.png", task);
    // A normal map: red is n_x, green n_y, each from -1 to 1.
    double worst = 0;
    for (double y = -0.9; y <= 0.9; y += 0.1) {
        for (double x = -0.9; x <= 0.9; x += 0.1) {
            if (std::hypot(x, y) < 0.9) {
                const Rgba c = sphere->at(x, y);
                worst = std::max({worst, std::abs(2.0 * c.r - 1 - x), std::abs(2.0 * c.g - 1 - y)});
            }
        }
    }
    EXPECT_LT(worst, 0.06);
}

TEST(ImportMatcap, ABallOnAGroundIsCutOut) {
    const LitSphere style = plainStyle();
    const ArtPicture picture = drawn(300, 260, ballForm({{150, 130}, {118, 118}, 0}), style).picture;
    const fs::path file = fs::temp_directory_path() / "limner-matcap-ground.png";
    writeArt(picture, file);
    Task task;
    const SpherePtr sphere = importMatcap(file, task);
    fs::remove(file);
    EXPECT_NEAR(sphere->size(), 236, 4);
    const Mask all{256, 256, std::vector<std::uint8_t>(256 * 256, 255)};
    EXPECT_LT(sphereError(*sphere, style, all), 0.02);
}

TEST(ImportMatcap, AlphaSaysWhereTheBallIs) {
    const LitSphere style = plainStyle();
    const SyntheticArt art = drawn(200, 180, ballForm({{80, 90}, {60, 60}, 0}), style);
    ArtPicture picture = art.picture;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        picture.pixels[i].a = art.form.values[i] != 0 ? 1 : 0;
    }
    const fs::path file = fs::temp_directory_path() / "limner-matcap-alpha.png";
    writeArt(picture, file);
    Task task;
    const SpherePtr sphere = importMatcap(file, task);
    fs::remove(file);
    EXPECT_NEAR(sphere->size(), 120, 2);
    EXPECT_FALSE(sphere->hasDirectionalOpacity());
    const Mask all{256, 256, std::vector<std::uint8_t>(256 * 256, 255)};
    EXPECT_LT(sphereError(*sphere, style, all), 0.02);
}

std::string refusal(const ArtPicture& picture) {
    const fs::path file = fs::temp_directory_path() / "limner-matcap-bad.png";
    writeArt(picture, file);
    std::string said;
    try {
        Task task;
        importMatcap(file, task);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::badInput);
        said = error.what();
    }
    fs::remove(file);
    return said;
}

TEST(ImportMatcap, WhatIsNoBallIsRefused) {
    EXPECT_NE(refusal({1, 1, std::vector<Rgba>(1)}).find("1 x 1 pixels"), std::string::npos);
    EXPECT_NE(refusal({64, 64, std::vector<Rgba>(4096, Rgba{1, 1, 1, 0})}).find("clear all over"), std::string::npos);
}

} // namespace
} // namespace limner
