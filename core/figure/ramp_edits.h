#pragma once

#include "core/figure/layer.h"

#include <cstddef>
#include <vector>

namespace limner {

/// Changes of a colour ramp as functions from value to value: what ramp editors are made of. Places run from 0 to 1 and
/// rise; two keys at one place are a step. Indices must exist.

using RampKeys = std::vector<RampKey>;

/// Linear between keys, right-continuous at a step, constant outside. No keys: factors of one.
glm::dvec4 rampAt(const RampKeys& keys, double at);
glm::dvec3 rampAt(const std::vector<ColourKey>& keys, double at);

/// The key goes to `at`, held between its neighbours and in 0..1.
RampKeys withKeyMoved(RampKeys keys, std::size_t index, double at);

struct AddedKey {
    RampKeys keys;
    std::size_t index = 0; ///< of the new key
};
/// A new key in the colour that the ramp has there; after keys at the same place.
AddedKey withKeyAdded(const RampKeys& keys, double at);
RampKeys withKeyRemoved(RampKeys keys, std::size_t index);
/// The ramp keeps the previous key's colour up to this key and jumps there. A step, and the first key, stay.
RampKeys withKeyStep(RampKeys keys, std::size_t index);

/// A tone's keys as a ramp of full opacity, and back.
RampKeys rampOf(const std::vector<ColourKey>& keys);
std::vector<ColourKey> toneKeysOf(const RampKeys& keys);

} // namespace limner
