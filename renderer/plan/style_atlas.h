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
    /// RGB as 11, 11 and 10 bits (red lowest), slot after slot, row-major, top row first; one extra row and texel
    /// readable past the end.
    std::vector<std::uint32_t> rgb;
    /// Directional opacity 0..65535, same order; empty where every style is opaque.
    std::vector<std::uint16_t> alpha;
    std::vector<Rgba> mean; ///< per slot
};

/// `texels`: wished size per side; the next power of two within [8, 512] is taken.
std::shared_ptr<const StyleAtlas> packStyles(std::span<const std::shared_ptr<const LitSphere>> spheres, int texels);

} // namespace limner
