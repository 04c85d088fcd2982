#pragma once

#include "core/figure/layer.h"

#include <string>
#include <vector>

namespace limner {

/// Ready-made settings of single parts of a layer. Immutable, thread-safe.

template <class Part>
struct PartPreset {
    std::string id;   ///< "cool-to-warm"
    std::string name; ///< "Cool to warm"
    std::string help; ///< one sentence: what it looks like
    Part part;
};

/// Tones from smooth to abrupt (spec layers.md; the cool and warm ones after Gooch and others 1998). Places run from 0,
/// facing away from the light, to 1, facing it: under the head light most of what is seen lies above 0.3.
const std::vector<PartPreset<Tone>>& tonePresets();

/// Colours and fades by position: along the view 0 is near and 1 far; along z 0 is the scan's lower end.
const std::vector<PartPreset<PositionRamp>>& positionPresets();

} // namespace limner
