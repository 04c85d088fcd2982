#pragma once

#include "core/figure/figure.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace limner {

/// Exact evaluation of the colour ramps of a layer's parts (paper 003; spec layers.md). Linear between keys,
/// right-continuous where two keys share a place (a step), constant outside. No keys: all factors are 1.

/// Factors of a tone ramp at a place from shade (0) to light (1). Saturation mixes the ramp with its own luminance
/// (Rec. 709 weights); above 1 it is pushed away from it. Never below 0.
glm::dvec3 toneAt(const Tone& tone, double place);

/// Factors of colour and opacity at a place from 0 to 1.
glm::dvec4 positionTintAt(const PositionRamp& ramp, double place);

/// Whether any key fades: its opacity factor is not 1.
bool changesOpacity(const PositionRamp& ramp);

/// The same functions as tables of `kRampEntries` entries over [0, 1], RGBA (a tone's alpha is 1).
inline constexpr int kRampEntries = 1024;
std::vector<glm::vec4> bakeTone(const Tone& tone);
std::vector<glm::vec4> bakePositionTint(const PositionRamp& ramp);

/// A curve of opacity factors over [0, 1] (`opacityAt`) as such a table.
std::vector<float> bakeUnitCurve(const std::vector<glm::dvec2>& points);

} // namespace limner
