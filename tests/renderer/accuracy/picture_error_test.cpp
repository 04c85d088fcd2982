#include "renderer/accuracy/colour_difference.h"
#include "renderer/accuracy/picture_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace limner::accuracy {

namespace {

struct Pair {
    glm::dvec3 first;
    glm::dvec3 second;
    double difference;
};

/// Pairs of Sharma, Wu and Dalal (2005), table 1: each tests another branch (hues across 0, greys, blue, large steps).
TEST(ColourDifference, IsThePublishedOne) {
    const Pair pairs[] = {
        {{50, 2.6772, -79.7751}, {50, 0, -82.7485}, 2.0425},
        {{50, 3.1571, -77.2803}, {50, 0, -82.7485}, 2.8615},
        {{50, 2.8361, -74.0200}, {50, 0, -82.7485}, 3.4412},
        {{50, -1.3802, -84.2814}, {50, 0, -82.7485}, 1.0000},
        {{50, 0, 0}, {50, -1, 2}, 2.3669},
        {{50, 2.5, 0}, {50, 0, -2.5}, 4.3065},
        {{50, 2.5, 0}, {73, 25, -18}, 27.1492},
        {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
        {{2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082},
    };
    for (const Pair& pair : pairs) {
        EXPECT_NEAR(ciede2000(pair.first, pair.second), pair.difference, 5e-5);
        EXPECT_NEAR(ciede2000(pair.second, pair.first), pair.difference, 5e-5);
    }
}

TEST(ColourDifference, KnowsWhiteBlackAndRed) {
    EXPECT_NEAR(labOfSrgb({1, 1, 1}).x, 100, 1e-9);
    EXPECT_NEAR(labOfSrgb({1, 1, 1}).y, 0, 1e-9);
    EXPECT_NEAR(labOfSrgb({0, 0, 0}).x, 0, 1e-9);
    const glm::dvec3 red = labOfSrgb({1, 0, 0});
    EXPECT_NEAR(red.x, 53.24, 0.01);
    EXPECT_NEAR(red.y, 80.09, 0.02);
    EXPECT_NEAR(red.z, 67.20, 0.02);
}

Picture grey(glm::ivec2 size, float value) {
    Picture picture(size);
    for (std::size_t i = 0; i < picture.rgba().size(); ++i) {
        picture.rgba()[i] = i % 4 == 3 ? 1 : value;
    }
    return picture;
}

TEST(PictureError, MeasuresWhatIsKnown) {
    const Picture reference = grey({20, 20}, 0.5F);
    Picture picture = reference;
    EXPECT_EQ(measureError(picture, reference, {1, 1, 1}).rmse, 0);
    EXPECT_TRUE(std::isinf(measureError(picture, reference, {1, 1, 1}).psnr()));
    picture.pixel(3, 4)[0] += 0.25F; // one of 1600 channels
    const PictureError one = measureError(picture, reference, {1, 1, 1});
    EXPECT_NEAR(one.rmse, 0.25 / 40, 1e-9);
    EXPECT_NEAR(one.largest, 0.25, 1e-9);
    EXPECT_EQ(one.p95Colour, 0);
    EXPECT_GT(one.largestColour, 5);
    EXPECT_NEAR(one.meanColour, one.largestColour / 400, 1e-6);
    EXPECT_EQ(one.of(ErrorMetric::largest), one.largest);
    EXPECT_EQ(one.of(ErrorMetric::rootMeanSquare), one.rmse);
    EXPECT_EQ(one.of(ErrorMetric::ciede2000), one.p95Colour);
}

TEST(PictureError, OfAPixelThatIsNoNumberIsTheWorst) {
    const Picture reference = grey({4, 4}, 0.5F);
    Picture picture = reference;
    picture.pixel(0, 0)[1] = std::numeric_limits<float>::quiet_NaN();
    const PictureError error = measureError(picture, reference, {1, 1, 1});
    EXPECT_EQ(error.notFinite, 1U);
    EXPECT_EQ(error.largest, 1);
    EXPECT_EQ(error.largestColour, 100);
}

TEST(PictureError, ClearPixelsDifferByTheirBackground) {
    Picture clear({1, 1});
    Picture white = grey({1, 1}, 1);
    EXPECT_NEAR(measureError(clear, white, {1, 1, 1}).largestColour, 0, 1e-9);
    EXPECT_GT(measureError(clear, white, {0, 0, 0}).largestColour, 90);
}

} // namespace

} // namespace limner::accuracy
