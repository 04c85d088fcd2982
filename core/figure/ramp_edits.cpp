#include "core/figure/ramp_edits.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cassert>

namespace limner {
namespace {

/// Of the first key that lies beyond `at`.
template <typename Key>
std::size_t placeAfter(const std::vector<Key>& keys, double at) {
    const auto place =
        std::upper_bound(keys.begin(), keys.end(), at, [](double value, const Key& key) { return value < key.at; });
    return static_cast<std::size_t>(place - keys.begin());
}

template <typename Key, typename Colour>
Colour interpolated(const std::vector<Key>& keys, double at, Colour Key::*colour) {
    if (keys.empty()) {
        return Colour(1);
    }
    const std::size_t after = placeAfter(keys, at);
    if (after == 0 || after == keys.size()) {
        return after == 0 ? keys.front().*colour : keys.back().*colour;
    }
    const Key& low = keys[after - 1];
    const Key& high = keys[after];
    return glm::mix(low.*colour, high.*colour, (at - low.at) / (high.at - low.at));
}

} // namespace

glm::dvec4 rampAt(const RampKeys& keys, double at) { return interpolated(keys, at, &RampKey::rgba); }

glm::dvec3 rampAt(const std::vector<ColourKey>& keys, double at) { return interpolated(keys, at, &ColourKey::rgb); }

RampKeys withKeyMoved(RampKeys keys, std::size_t index, double at) {
    assert(index < keys.size());
    const double low = index > 0 ? keys[index - 1].at : 0;
    const double high = index + 1 < keys.size() ? keys[index + 1].at : 1;
    keys[index].at = std::clamp(at, low, high);
    return keys;
}

AddedKey withKeyAdded(const RampKeys& keys, double at) {
    const double place = std::clamp(at, 0.0, 1.0);
    AddedKey added{keys, placeAfter(keys, place)};
    added.keys.insert(added.keys.begin() + static_cast<std::ptrdiff_t>(added.index), {place, rampAt(keys, place)});
    return added;
}

RampKeys withKeyRemoved(RampKeys keys, std::size_t index) {
    assert(index < keys.size());
    keys.erase(keys.begin() + static_cast<std::ptrdiff_t>(index));
    return keys;
}

RampKeys withKeyStep(RampKeys keys, std::size_t index) {
    assert(index < keys.size());
    const double at = keys[index].at;
    const bool step = (index > 0 && keys[index - 1].at == at) || (index + 1 < keys.size() && keys[index + 1].at == at);
    if (!step && index > 0) {
        const RampKey edge{at, keys[index - 1].rgba};
        keys.insert(keys.begin() + static_cast<std::ptrdiff_t>(index), edge);
    }
    return keys;
}

RampKeys rampOf(const std::vector<ColourKey>& keys) {
    RampKeys ramp;
    for (const ColourKey& key : keys) {
        ramp.push_back({key.at, glm::dvec4(key.rgb, 1)});
    }
    return ramp;
}

std::vector<ColourKey> toneKeysOf(const RampKeys& keys) {
    std::vector<ColourKey> tone;
    for (const RampKey& key : keys) {
        tone.push_back({key.at, glm::dvec3(key.rgba)});
    }
    return tone;
}

} // namespace limner
