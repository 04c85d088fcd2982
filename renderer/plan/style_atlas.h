#pragma once

#include "core/style/lit_sphere.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace limner {

/// The distinct lit spheres of a plan at one mip level, packed for fast lookup (`sft`). All slots have the same size.
struct StyleAtlas {
    int size = 0; ///< texels per side
    int slots = 0;
    /// Every texel with its right neighbour (at the end of a row with itself), interleaved: r r' g g' b b' a a',
    /// 0..32767 (a: the directional opacity); slot after slot, row-major, top row first; one extra row and texel
    /// readable past the end. 15 bits, so that two neighbours interpolate in one integer instruction.
    std::vector<std::int16_t> texels;
    static constexpr int kPerTexel = 8; ///< numbers
    bool directionalOpacity = false;    ///< whether any style has an alpha below 1
    std::vector<Rgba> mean;             ///< per slot
};

/// `texels`: wished size per side; the next power of two within [8, 512] is taken.
std::shared_ptr<const StyleAtlas> packStyles(std::span<const std::shared_ptr<const LitSphere>> spheres, int texels);

} // namespace limner
