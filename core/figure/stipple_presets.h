#pragma once

#include "core/figure/effects.h"
#include "core/figure/part_presets.h"

#include <optional>
#include <vector>

namespace limner {

/// Ready-made looks of ink: the dots' factors, lines and strokes. Immutable, thread-safe. The first is what a figure
/// starts with.
const std::vector<PartPreset<Stipple>>& stipplePresets();

/// A look over what is there: ink, dot size, placing and what the dots take for matter stay as they were set.
Stipple stippleInLook(const std::optional<Stipple>& now, const Stipple& look);

} // namespace limner
