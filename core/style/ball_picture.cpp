#include "core/style/ball_picture.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace limner {
namespace {

/// Of the square of one pixel around a place that is `distance` pixels inside the rim, the share within it.
double coverage(double distance) { return std::clamp(distance + 0.5, 0.0, 1.0); }

Rgba onPaper(const Rgba& colour) {
    const auto over = [&](float value) { return 1 - colour.a * (1 - value); };
    return {over(colour.r), over(colour.g), over(colour.b), 1};
}

} // namespace

std::vector<Rgba> ballPicture(const LitSphere& sphere, int size) {
    std::vector<Rgba> pixels;
    pixels.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    const double radius = size / 2.0;
    for (int row = 0; row < size; ++row) {
        for (int column = 0; column < size; ++column) {
            const double x = (column + 0.5) / radius - 1;
            const double y = 1 - (row + 0.5) / radius;
            const double inside = radius * (1 - std::hypot(x, y));
            Rgba pixel = onPaper(sphere.at(x, y));
            pixel.a = static_cast<float>(coverage(inside));
            pixels.push_back(pixel.a > 0 ? pixel : Rgba{0, 0, 0, 0});
        }
    }
    return pixels;
}

} // namespace limner
