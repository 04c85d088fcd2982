#include "widgets/style_pictures.h"

#include "widgets/test_figure.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace limner {
namespace {

/// How far the picture's most colourful pixel is from grey.
int mostColour(const QImage& image) {
    int most = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const QColor c = image.pixelColor(x, y);
            most = std::max(most, std::max({c.red(), c.green(), c.blue()}) - std::min({c.red(), c.green(), c.blue()}));
        }
    return most;
}

/// Darkest and lightest pixel.
std::pair<int, int> tones(const QImage& image) {
    std::pair<int, int> range(255, 0);
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const int tone = image.pixelColor(x, y).lightness();
            range = {std::min(range.first, tone), std::max(range.second, tone)};
        }
    return range;
}

TEST(StylePictures, AnInkedFigureIsShownInInk) {
    Planner planner;
    Task task;
    PlanRequest request;
    request.size = {64, 64};
    const Figure figure = testing::smallFigure();
    const auto plan = planner.plan(figure, request, task);
    StylePictures pictures;
    const QImage shaded = pictures.figure(*plan, figure, 96, task);
    EXPECT_GT(mostColour(shaded), 30) << "ivory";
    Figure inked = figure;
    inked.stipple = Stipple{};
    inked.stipple->layerOpacity = "alone";
    inked.stipple->sizeMm = 2;
    const QImage ink = pictures.figure(*plan, inked, 96, task);
    EXPECT_LT(mostColour(ink), 8) << "black dots on white paper";
    EXPECT_LT(tones(ink).first, 128);
    EXPECT_GT(tones(ink).second, 250);
}

} // namespace
} // namespace limner
