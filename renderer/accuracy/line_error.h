#pragma once

#include "renderer/picture.h"

#include <vector>

namespace limner::accuracy {

/// How far lines are from where they should be (spec accuracy.md 1.3): they have edges, so differences of pixels say
/// little of them. In pixels.
struct LineError {
    double meanDistance = 0; ///< between the two masks, each pixel to the nearest of the other, both ways
    double p95Distance = 0;
    double disagreement = 0; ///< share of the pixels of either that are not in both
    bool any = false;        ///< either picture has lines
};

/// Pixels that lines change: where a picture and the same without its lines differ by more than a tenth.
std::vector<bool> lineMask(const Picture& picture, const Picture& withoutLines);

/// Both row by row, `width` pixels a row. Lines without a counterpart count as `kFarthest` away.
LineError compareLines(const std::vector<bool>& mask, const std::vector<bool>& reference, int width);
inline constexpr int kFarthest = 16;

} // namespace limner::accuracy
