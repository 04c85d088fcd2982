#pragma once

#include "widgets/artwork_plate.h"

#include <functional>
#include <memory>

namespace limner::testing {

/// A plate of pixels in memory; `colour` gives the pixel at (x, y).
inline PlatePtr plateOf(int width, int height, const std::function<Rgba(int, int)>& colour) {
    ArtPixels pixels;
    pixels.width = width;
    pixels.height = height;
    pixels.pixels.resize(pixels.offset(0, height));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            pixels.at(x, y) = colour(x, y);
    return std::make_shared<const ArtworkPlate>(std::make_shared<const Artwork>(std::move(pixels), "plate.png"));
}

/// Left half red, right half blue.
inline PlatePtr twoColours(int width = 400, int height = 300) {
    return plateOf(width, height, [width](int x, int) {
        return x < width / 2 ? Rgba{0.8F, 0.2F, 0.1F, 1} : Rgba{0.1F, 0.2F, 0.8F, 1};
    });
}

} // namespace limner::testing
