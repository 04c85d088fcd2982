#pragma once

#include "renderer/marks/hatch_map.h"

#include <glm/vec2.hpp>

#include <cstdint>
#include <functional>
#include <vector>

namespace limner {

/// Strokes of one family that lie evenly on paper.

struct HatchStroke {
    std::vector<glm::vec2> points; ///< mm, in equal steps
    std::vector<float> widths;
    std::uint32_t voxel = 0; ///< where it starts
};

struct HatchPen {
    HatchMap::Family family = HatchMap::Family::along;
    float lengthMm = 4;
    float widthMm = 0.2F;
    /// Share of paper that this family covers, from the tone there.
    std::function<float(float tone)> share;
    std::uint32_t seed = 1;
};

/// As far apart as the share asks for, then as wide as makes it up: a stroke has the ink of the paper that is nearest
/// to it. `starts`: places that are tried first to last; between them strokes are laid beside strokes.
std::vector<HatchStroke> layStrokes(const HatchMap& map, const HatchPen& pen, const glm::dvec2& paperMm,
                                    const std::vector<glm::vec2>& starts);

} // namespace limner
