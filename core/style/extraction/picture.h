#pragma once

#include "core/style/lit_sphere.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace limner {

/// Pixels of a picture, top row first: sRGB-encoded, alpha not premultiplied.
struct ArtPicture {
    int width = 0;
    int height = 0;
    std::vector<Rgba> pixels; ///< width * height

    [[nodiscard]] bool empty() const { return pixels.empty(); }
    [[nodiscard]] std::size_t offset(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    [[nodiscard]] const Rgba& at(int x, int y) const { return pixels[offset(x, y)]; }
    [[nodiscard]] Rgba& at(int x, int y) { return pixels[offset(x, y)]; }
};

/// Yes (255) or no (0) for each pixel, and what lies between at soft edges; 128 and more counts as yes.
struct Mask {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> values; ///< width * height, top row first

    [[nodiscard]] bool empty() const { return values.empty(); }
    [[nodiscard]] std::size_t offset(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    [[nodiscard]] bool has(int x, int y) const { return values[offset(x, y)] >= 128; }
};

} // namespace limner
