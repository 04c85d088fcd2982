#include "renderer/plan/style_atlas.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace limner {
namespace {

std::uint32_t quantise(double value, double most) {
    return static_cast<std::uint32_t>(std::lround(std::clamp(value, 0.0, 1.0) * most));
}

std::uint32_t packRgb(const Rgba& colour) {
    // 11 bits for red and green, 10 for blue, to which the eye is least sensitive.
    return quantise(colour.r, 2047) | quantise(colour.g, 2047) << 11U | quantise(colour.b, 1023) << 22U;
}

/// The sphere's mip level of `size` texels, or the next finer one where halving does not meet it.
std::shared_ptr<const LitSphere> mipLevel(std::shared_ptr<const LitSphere> sphere, int size) {
    while (sphere->size() / 2 >= size) {
        sphere = sphere->half();
    }
    return sphere;
}

} // namespace

std::shared_ptr<const StyleAtlas> packStyles(std::span<const std::shared_ptr<const LitSphere>> spheres, int texels) {
    auto atlas = std::make_shared<StyleAtlas>();
    atlas->size = static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::clamp(texels, 8, 512))));
    atlas->slots = static_cast<int>(spheres.size());
    const bool clear =
        std::any_of(spheres.begin(), spheres.end(), [](const auto& sphere) { return sphere->hasDirectionalOpacity(); });
    const auto side = static_cast<std::size_t>(atlas->size);
    const std::size_t padded = spheres.size() * side * side + side + 1;
    atlas->rgb.reserve(padded);
    atlas->alpha.reserve(clear ? padded : 0);
    for (const auto& sphere : spheres) {
        assert(sphere != nullptr);
        const auto level = mipLevel(sphere, atlas->size);
        const bool exact = level->size() == atlas->size;
        for (std::size_t i = 0; i < side * side; ++i) {
            const double u = (2.0 * static_cast<double>(i % side) + 1) / atlas->size - 1;
            const double v = 1 - (2.0 * static_cast<double>(i / side) + 1) / atlas->size;
            const Rgba texel = exact ? level->pixels()[i] : level->at(u, v);
            atlas->rgb.push_back(packRgb(texel));
            if (clear) {
                atlas->alpha.push_back(static_cast<std::uint16_t>(quantise(texel.a, 65535)));
            }
        }
        atlas->mean.push_back(sphere->mean());
    }
    atlas->rgb.resize(padded, 0);
    atlas->alpha.resize(clear ? padded : 0, 0);
    return atlas;
}

} // namespace limner
