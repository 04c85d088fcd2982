#include "core/style/ramps.h"

#include "core/style/transfer_function.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace limner {

namespace {

/// Colour at a place of keys by rising `at`.
template <typename Key, typename Colour>
Colour interpolated(const std::vector<Key>& keys, double place, Colour Key::*colour) {
    if (keys.empty()) {
        return Colour(1);
    }
    const auto after =
        std::upper_bound(keys.begin(), keys.end(), place, [](double p, const Key& k) { return p < k.at; });
    if (after == keys.begin()) {
        return (*after).*colour;
    }
    const Key& low = *(after - 1);
    if (after == keys.end()) {
        return low.*colour;
    }
    return glm::mix(low.*colour, (*after).*colour, (place - low.at) / (after->at - low.at));
}

template <typename Function>
auto baked(const Function& function) {
    std::vector<decltype(function(0.0))> table;
    table.reserve(kRampEntries);
    for (int i = 0; i < kRampEntries; ++i) {
        table.push_back(function(static_cast<double>(i) / (kRampEntries - 1)));
    }
    return table;
}

} // namespace

glm::dvec3 toneAt(const Tone& tone, double place) {
    const glm::dvec3 rgb = interpolated(tone.keys, place, &ColourKey::rgb);
    const glm::dvec3 grey(glm::dot(rgb, glm::dvec3(0.2126, 0.7152, 0.0722)));
    return glm::max(glm::mix(grey, rgb, tone.saturation), 0.0);
}

glm::dvec4 positionTintAt(const PositionRamp& ramp, double place) {
    return interpolated(ramp.ramp, place, &RampKey::rgba);
}

bool changesOpacity(const PositionRamp& ramp) {
    return std::any_of(ramp.ramp.begin(), ramp.ramp.end(), [](const RampKey& key) { return key.rgba.a != 1; });
}

std::vector<glm::vec4> bakeTone(const Tone& tone) {
    return baked([&](double place) { return glm::vec4(glm::vec3(toneAt(tone, place)), 1.0F); });
}

std::vector<glm::vec4> bakePositionTint(const PositionRamp& ramp) {
    return baked([&](double place) { return glm::vec4(positionTintAt(ramp, place)); });
}

std::vector<float> bakeUnitCurve(const std::vector<glm::dvec2>& points) {
    return baked([&](double at) { return static_cast<float>(opacityAt(points, at)); });
}

} // namespace limner
