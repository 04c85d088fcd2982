#include "core/style/ramps.h"

#include "core/figure/ramp_edits.h"
#include "core/style/transfer_function.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace limner {

namespace {

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
    const glm::dvec3 rgb = rampAt(tone.keys, place);
    const glm::dvec3 grey(glm::dot(rgb, glm::dvec3(0.2126, 0.7152, 0.0722)));
    return glm::max(glm::mix(grey, rgb, tone.saturation), 0.0);
}

glm::dvec4 positionTintAt(const PositionRamp& ramp, double place) { return rampAt(ramp.ramp, place); }

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
