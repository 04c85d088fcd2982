#include "core/figure/output_size.h"

#include "core/base/error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace limner {
namespace {

TEST(OutputSize, PixelsComeBackAsTheyWere) {
    for (const double dpi : {72.0, 299.9, 300.0, 1200.0}) {
        for (const glm::ivec2 pixels : {glm::ivec2(1, 1), glm::ivec2(2126, 1417), glm::ivec2(16384, 999'999)}) {
            EXPECT_EQ(resized({}, {pixels, {}, {}, dpi}).sizePixels(), pixels);
        }
    }
}

TEST(OutputSize, OneLengthKeepsTheShapeAndDpiKeepsTheLengths) {
    Output wide;
    wide.widthMm = 200;
    wide.heightMm = 100;
    EXPECT_DOUBLE_EQ(resized(wide, {{}, 50.0, {}, {}}).heightMm, 25);
    EXPECT_DOUBLE_EQ(resized(wide, {{}, {}, 50.0, {}}).widthMm, 100);
    const Output fine = resized(wide, {{}, {}, {}, 600.0});
    EXPECT_EQ(fine.widthMm, 200);
    EXPECT_EQ(fine.dpi, 600);
    EXPECT_EQ(resized(wide, {}), wide);
}

TEST(OutputSize, RefusesWhatMakesNoSense) {
    const double nan = std::nan("");
    const double infinite = std::numeric_limits<double>::infinity();
    const SizeRequest bad[] = {
        {glm::ivec2(0, 5), {}, {}, {}},
        {glm::ivec2(5, -1), {}, {}, {}},
        {glm::ivec2(1'000'001, 5), {}, {}, {}},
        {{}, 0.0, {}, {}},
        {{}, -3.0, {}, {}},
        {{}, nan, {}, {}},
        {{}, infinite, {}, {}},
        {{}, 1e9, {}, {}},
        {{}, {}, nan, {}},
        {{}, {}, {}, 0.0},
        {{}, {}, {}, nan},
        {{}, {}, {}, 1e9},
        {glm::ivec2(5, 5), 10.0, {}, {}},
    };
    for (const SizeRequest& request : bad) {
        EXPECT_THROW(resized({}, request), Error);
    }
}

TEST(OutputSize, ATallPictureSeesMoreSoThatNothingIsCutOff) {
    Output tall;
    tall.widthMm = 100;
    tall.heightMm = 250;
    Camera camera;
    camera.heightMm = 200;
    EXPECT_DOUBLE_EQ(fittedTo(tall, camera).heightMm, 500);
    std::swap(tall.widthMm, tall.heightMm);
    EXPECT_DOUBLE_EQ(fittedTo(tall, camera).heightMm, 200);
}

} // namespace
} // namespace limner
