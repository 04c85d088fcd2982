#include "renderer/accuracy/perceived_error.h"
#include "renderer/accuracy/picture_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

// What a reader sees of a difference: S-CIELAB (accuracy.md 1.3, the perceptual map).

namespace limner::accuracy {
namespace {

constexpr int kSize = 128;
const glm::dvec3 kPaper{1, 1, 1};

Picture greys(const std::function<double(int, int)>& grey) {
    Picture picture(glm::ivec2{kSize, kSize});
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            float* pixel = picture.pixel(x, y);
            pixel[0] = pixel[1] = pixel[2] = static_cast<float>(grey(x, y));
            pixel[3] = 1;
        }
    }
    return picture;
}

const Picture& plain() {
    static const Picture picture = greys([](int, int) { return 0.5; });
    return picture;
}

/// Squares of `edge` pixels, by turns brighter and darker: as much light as the plain grey in the mean.
Picture squares(int edge) {
    const double light = std::pow((0.5 + 0.055) / 1.055, 2.4);
    const auto encoded = [](double v) { return 1.055 * std::pow(v, 1 / 2.4) - 0.055; };
    return greys([&](int x, int y) { return encoded(light * ((x / edge + y / edge) % 2 == 0 ? 0.8 : 1.2)); });
}

double meanSeen(const Picture& picture, double perDegree) {
    return summaryOf(perceivedDifferences(picture, plain(), kPaper, perDegree)).mean;
}

TEST(PerceivedError, IsNothingBetweenEqualPictures) { EXPECT_EQ(meanSeen(plain(), 60), 0); }

TEST(PerceivedError, OfABroadDifferenceIsTheColourDifference) {
    const Picture brighter = greys([](int, int) { return 0.55; });
    const double asIs = measureError(brighter, plain(), kPaper).meanColour;
    ASSERT_GT(asIs, 3);
    EXPECT_NEAR(meanSeen(brighter, 60), asIs, 1e-3 * asIs);
}

TEST(PerceivedError, OfAPatternFallsWithItsFineness) {
    constexpr double print = 61.84; // 300 dpi at 300 mm
    EXPECT_NEAR(pixelsPerDegree(300 / 25.4), print, 0.01);
    const double coarse = meanSeen(squares(32), print);
    const double fine = meanSeen(squares(2), print);
    const double finest = meanSeen(squares(1), print);
    EXPECT_GT(coarse, 4 * fine);
    EXPECT_GT(fine, finest);
    EXPECT_LT(finest, 0.25 * measureError(squares(1), plain(), kPaper).meanColour);
}

TEST(PerceivedError, IsThePlainOneWherePixelsAreCoarserThanTheEye) {
    // A pixel is a third of a degree. The wide negative part of light and dark lifts contrasts by an eighth, that of
    // the two other channels not: greys get a tint, which CIEDE2000 weighs more than lightness.
    const double ratio = meanSeen(squares(1), 3) / measureError(squares(1), plain(), kPaper).meanColour;
    EXPECT_GT(ratio, 0.9);
    EXPECT_LT(ratio, 1.3);
}

TEST(PerceivedError, CountsAPixelThatIsNoNumber) {
    Picture broken = greys([](int, int) { return 0.0; });
    const Picture black = broken;
    broken.pixel(5, 5)[1] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_GT(summaryOf(perceivedDifferences(broken, black, kPaper, 1)).largest, 50);
}

} // namespace
} // namespace limner::accuracy
