#pragma once

#include "core/style/lit_sphere.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace limner {

/// The distinct lit spheres of a plan, packed for fast lookup (`sft`): one mip level, or a chain of them from `size`
/// down to one texel, each half as wide as the one before. All slots have the same size.
struct StyleAtlas {
    static constexpr int kSmallest = 8; ///< of `size`
    static constexpr int kLargest = 512;
    int size = 0; ///< texels per side, of level 0
    int slots = 0;
    /// RGBA of every texel, 0..32767 (alpha: the directional opacity), level after level, in it slot after slot,
    /// row-major, top row first; one extra row and texel readable past the end. 15 bits, so that two neighbours
    /// interpolate in one integer instruction.
    std::vector<std::int16_t> texels;
    std::vector<std::int32_t> levelStart; ///< first texel of every level
    /// Of a chain: what was packed, `pictures[level][slot]`.
    std::vector<std::vector<std::shared_ptr<const LitSphere>>> pictures;
    bool directionalOpacity = false; ///< whether any style has an alpha below 1
    std::vector<Rgba> mean;          ///< per slot
};

enum class AtlasLevels { one, all };

/// The size for a wished number of texels per side: the next power of two within [8, 512].
int atlasSize(int texels);

/// `texels`: wished, see `atlasSize`.
std::shared_ptr<const StyleAtlas> packStyles(std::span<const std::shared_ptr<const LitSphere>> spheres, int texels,
                                             AtlasLevels levels = AtlasLevels::one);

} // namespace limner
