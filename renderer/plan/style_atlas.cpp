#include "renderer/plan/style_atlas.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <utility>

namespace limner {
namespace {

std::int16_t fifteenBits(float unit) {
    return static_cast<std::int16_t>(std::lround(std::clamp(unit, 0.0F, 1.0F) * 32767.0F));
}

void pack(const std::vector<Rgba>& picture, std::vector<std::int16_t>& texels) {
    for (const Rgba& texel : picture) {
        for (const float channel : {texel.r, texel.g, texel.b, texel.a}) {
            texels.push_back(fifteenBits(channel));
        }
    }
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

int atlasSize(int texels) {
    const int wished = std::clamp(texels, StyleAtlas::kSmallest, StyleAtlas::kLargest);
    return static_cast<int>(std::bit_ceil(static_cast<unsigned>(wished)));
}

std::shared_ptr<const StyleAtlas> packStyles(std::span<const std::shared_ptr<const LitSphere>> spheres, int texels,
                                             AtlasLevels levels) {
    auto atlas = std::make_shared<StyleAtlas>();
    atlas->size = atlasSize(texels);
    atlas->slots = static_cast<int>(spheres.size());
    atlas->directionalOpacity =
        std::any_of(spheres.begin(), spheres.end(), [](const auto& sphere) { return sphere->hasDirectionalOpacity(); });
    for (const auto& sphere : spheres) {
        assert(sphere != nullptr);
        atlas->mean.push_back(sphere->mean());
    }
    std::vector<std::shared_ptr<const LitSphere>> pictures(spheres.begin(), spheres.end());
    const int last = levels == AtlasLevels::all ? 1 : atlas->size;
    for (int size = atlas->size; size >= last; size /= 2) {
        atlas->levelStart.push_back(static_cast<std::int32_t>(atlas->texels.size() / 4));
        for (auto& picture : pictures) {
            picture = mipLevel(std::move(picture), size);
            pack(resampled(*picture, size), atlas->texels);
        }
        if (levels == AtlasLevels::all) {
            atlas->pictures.push_back(pictures);
        }
    }
    atlas->texels.resize(atlas->texels.size() + 4 * (static_cast<std::size_t>(last) + 1), 0);
    return atlas;
}

} // namespace limner
