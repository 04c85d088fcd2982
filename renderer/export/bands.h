#pragma once

#include "renderer/export/picture_format.h"

namespace limner {

/// How a picture is cut for rendering and writing: bands of full width, each rendered as a row of tiles.
struct BandLayout {
    int rows = 0;          ///< per band, but for the last
    int tileWidth = 0;     ///< of a rendered tile, but for the last of a row; its height is the band's
    std::size_t bytes = 0; ///< of memory that all of it takes, about
};

/// Bands that fit the budget and are no larger than serves parallel work, so that a stop is quick and progress smooth.
/// Throws Error(noResources) where not even the smallest fits.
BandLayout chooseBands(glm::ivec2 size, PictureFormat format, const PixelLayout& layout, const PictureOptions& options);

} // namespace limner
