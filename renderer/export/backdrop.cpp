#include "renderer/export/backdrop.h"

#include <algorithm>
#include <cmath>

namespace limner {

namespace {

/// Two neighbours in a row or column of texels, and the second one's weight.
struct Pair {
    std::size_t first = 0;
    std::size_t second = 0;
    float weight = 0;

    Pair(double at, int count) {
        const double inside = std::clamp(at, 0.0, count - 1.0);
        const double floor = std::floor(inside);
        first = static_cast<std::size_t>(floor);
        second = std::min(first + 1, static_cast<std::size_t>(count - 1));
        weight = static_cast<float>(inside - floor);
    }
};

std::size_t budgetOf(const PictureOptions& options) { return options.memoryBudget / 4; }

bool hasBackdrop(const PictureOptions& options, const PixelLayout& layout) {
    return options.backgroundPicture != nullptr && !layout.keepsAlpha();
}

} // namespace

void Backdrop::layOver(glm::ivec2 start, std::span<float> rgb) const {
    const CoveringCopy& copy = *copy_;
    const auto texel = [&](double pixel, double first) { return first + (pixel + 0.5) * copy.texelsPerPixel - 0.5; };
    const Pair rows(texel(start.y, copy.first.y), copy.size.y);
    const auto width = static_cast<std::size_t>(copy.size.x);
    const std::uint16_t* upper = copy.rgba.data() + rows.first * width * 4;
    const std::uint16_t* lower = copy.rgba.data() + rows.second * width * 4;
    const int count = static_cast<int>(rgb.size() / 3);
    for (int i = 0; i < count; ++i) {
        const Pair columns(texel(start.x + i, copy.first.x), copy.size.x);
        const auto channel = [&](std::size_t c) {
            const auto across = [&](const std::uint16_t* row) {
                const float left = row[columns.first * 4 + c];
                return left + columns.weight * (static_cast<float>(row[columns.second * 4 + c]) - left);
            };
            const float up = across(upper);
            return (up + rows.weight * (across(lower) - up)) / 65535;
        };
        float* out = rgb.data() + static_cast<std::ptrdiff_t>(i) * 3;
        const float clear = 1 - channel(3);
        for (std::size_t c = 0; c < 3; ++c) {
            out[c] = channel(c) + clear * out[c];
        }
    }
}

std::size_t backdropBytes(const PictureOptions& options, const PixelLayout& layout, glm::ivec2 size) {
    return hasBackdrop(options, layout) ? options.backgroundPicture->coveringBytes(size, budgetOf(options)) : 0;
}

std::shared_ptr<const Backdrop> makeBackdrop(const PictureOptions& options, const PixelLayout& layout,
                                             glm::ivec2 size) {
    return hasBackdrop(options, layout)
               ? std::make_shared<const Backdrop>(options.backgroundPicture->covering(size, budgetOf(options)))
               : nullptr;
}

} // namespace limner
