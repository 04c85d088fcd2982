#pragma once

#include "renderer/backend.h"

namespace limner {

/// A rectangle of sub-pixels, row-major RGBA.
struct SubPixels {
    const float* rgba = nullptr;
    int rowLength = 0;    ///< sub-pixels from one row to the next
    glm::ivec2 corner{0}; ///< of the whole picture, in sub-pixels; a multiple of `perAxis`
    glm::ivec2 pixels{0}; ///< whole pixels of it
    int perAxis = 1;
};

/// Averages sub-pixels into those pixels of a tile that they cover.
void averageSubPixels(const SubPixels& from, const Tile& tile, Picture& picture);

} // namespace limner
