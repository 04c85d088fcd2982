#pragma once

#include "core/figure/effects.h"
#include "renderer/marks/line_scene.h"

#include <cstdint>
#include <span>
#include <vector>

namespace limner {

/// Strokes over the form, along the direction in which it bends most, as dense as the tone asks for; above the tone
/// `cross` others cross them. Only the nearest surface of those with a tone is hatched.
/// `tone`: parallel to the field's voxels: the share of paper that ink covers, 0 for what is not drawn.
/// `colours`: the same, or empty for the scene's ink. `seed`: other strokes, as even.
/// Still: evenly laid on paper, the same for any number of threads. Moving: on the volume, so that they turn with it.
/// A group per layer.
std::vector<MarkGroup> drawHatching(const LineScene& scene, const StippleHatching& settings,
                                    std::span<const float> tone, std::span<const InkColour> colours,
                                    std::uint32_t seed);

} // namespace limner
