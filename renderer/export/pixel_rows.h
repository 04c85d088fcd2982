#pragma once

#include "renderer/export/picture_format.h"
#include "renderer/picture.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace limner {

/// Where a tile's pixels go in a band of full-width rows, all in the layout's form.
struct BandTarget {
    std::span<std::byte> bytes; ///< of the whole band
    int width = 0;              ///< pixels per row of the band
    glm::ivec2 origin{0};       ///< of the tile in the band
    glm::ivec2 place{0};        ///< of the tile in the whole picture: where its backdrop lies
};

/// Converts a rendered tile into the layout's numbers, in parallel. Integers are rounded to nearest and clamped, floats
/// are kept as they are. Returns the number of pixels that were not finite; they count as empty.
std::uint64_t writePixels(const Picture& tile, const PixelLayout& layout, const BandTarget& target);

/// sRGB's transfer function both ways (IEC 61966-2-1), continued past 1 and mirrored below 0.
float linearFromSrgb(float encoded);
float srgbFromLinear(float linear);

} // namespace limner
