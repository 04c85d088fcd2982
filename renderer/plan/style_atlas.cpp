#include "renderer/plan/style_atlas.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace limner {
namespace {

std::int16_t fifteenBits(float unit) {
    return static_cast<std::int16_t>(std::lround(std::clamp(unit, 0.0F, 1.0F) * 32767.0F));
}

/// The sphere's mip level of `size` texels, or the next finer one where halving does not meet it.
std::shared_ptr<const LitSphere> mipLevel(std::shared_ptr<const LitSphere> sphere, int size) {
    while (sphere->size() / 2 >= size) {
        sphere = sphere->half();
    }
    return sphere;
}

/// The picture at `size` texels a side.
std::vector<Rgba> resampled(const LitSphere& sphere, int size) {
    if (sphere.size() == size) {
        return {sphere.pixels().begin(), sphere.pixels().end()};
    }
    std::vector<Rgba> texels;
    for (int row = 0; row < size; ++row) {
        for (int column = 0; column < size; ++column) {
            texels.push_back(sphere.at((2.0 * column + 1) / size - 1, 1 - (2.0 * row + 1) / size));
        }
    }
    return texels;
}

} // namespace

std::shared_ptr<const StyleAtlas> packStyles(std::span<const std::shared_ptr<const LitSphere>> spheres, int texels) {
    auto atlas = std::make_shared<StyleAtlas>();
    atlas->size = static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::clamp(texels, 8, 512))));
    atlas->slots = static_cast<int>(spheres.size());
    atlas->directionalOpacity =
        std::any_of(spheres.begin(), spheres.end(), [](const auto& sphere) { return sphere->hasDirectionalOpacity(); });
    const auto side = static_cast<std::size_t>(atlas->size);
    const std::size_t padded = (spheres.size() * side * side + side + 1) * StyleAtlas::kPerTexel;
    atlas->texels.reserve(padded);
    for (const auto& sphere : spheres) {
        assert(sphere != nullptr);
        const std::vector<Rgba> picture = resampled(*mipLevel(sphere, atlas->size), atlas->size);
        for (std::size_t i = 0; i < side * side; ++i) {
            const Rgba& here = picture[i];
            const Rgba& next = picture[i % side + 1 < side ? i + 1 : i];
            for (const float channel : {here.r, next.r, here.g, next.g, here.b, next.b, here.a, next.a}) {
                atlas->texels.push_back(fifteenBits(channel));
            }
        }
        atlas->mean.push_back(sphere->mean());
    }
    atlas->texels.resize(padded, 0);
    return atlas;
}

} // namespace limner
