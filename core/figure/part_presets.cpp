#include "core/figure/part_presets.h"

namespace limner {

const std::vector<PartPreset<Tone>>& tonePresets() {
    using Keys = std::vector<ColourKey>;
    const auto tone = [](Keys keys) {
        Tone result;
        result.keys = std::move(keys);
        return result;
    };
    static const std::vector<PartPreset<Tone>> presets{
        {"cool-to-warm", "Cool to warm", "Blue shade turns smoothly into warm light.",
         tone({{0, {0.40, 0.46, 0.74}}, {0.45, {0.60, 0.64, 0.82}}, {0.75, {0.94, 0.90, 0.84}}, {1, {1, 0.97, 0.86}}})},
        {"cartoon", "Cartoon", "Four flat tones with three hard steps between them.",
         tone({{0, {0.32, 0.32, 0.42}},
               {0.45, {0.32, 0.32, 0.42}},
               {0.45, {0.56, 0.55, 0.62}},
               {0.70, {0.56, 0.55, 0.62}},
               {0.70, {0.82, 0.80, 0.80}},
               {0.90, {0.82, 0.80, 0.80}},
               {0.90, {1, 1, 1}},
               {1, {1, 1, 1}}})},
        {"two-tones", "Two tones", "One hard edge between shade and light, as in a poster.",
         tone({{0, {0.48, 0.45, 0.55}}, {0.68, {0.48, 0.45, 0.55}}, {0.68, {1, 1, 1}}, {1, {1, 1, 1}}})},
        {"sepia-wash", "Sepia wash", "Brown shade and creamy light, as in a wash drawing.",
         tone({{0, {0.28, 0.18, 0.10}}, {0.5, {0.62, 0.47, 0.33}}, {0.85, {0.95, 0.86, 0.72}}, {1, {1, 0.97, 0.90}}})},
        {"night-blue", "Night blue", "Deep blue shade under pale moonlight.",
         tone({{0, {0.04, 0.06, 0.20}}, {0.5, {0.22, 0.32, 0.60}}, {0.85, {0.62, 0.74, 0.95}}, {1, {0.90, 0.95, 1}}})},
    };
    return presets;
}

const std::vector<PartPreset<PositionRamp>>& positionPresets() {
    using Ramp = std::vector<RampKey>;
    const auto along = [](const char* axis, Ramp ramp) {
        PositionRamp result;
        result.axis = axis;
        result.ramp = std::move(ramp);
        return result;
    };
    static const std::vector<PartPreset<PositionRamp>> presets{
        {"aerial-perspective", "Aerial perspective", "Near things are warm and full, far ones cool and light.",
         along("view", {{0, {1, 0.94, 0.86, 1}}, {0.4, {1, 0.98, 0.96, 1}}, {1, {0.86, 0.96, 1.12, 0.45}}})},
        {"warm-to-cool", "Warm to cool", "Near things are warm, far ones cool; nothing fades.",
         along("view", {{0, {1.12, 0.96, 0.80, 1}}, {0.5, {1, 1, 1, 1}}, {1, {0.76, 0.90, 1.14, 1}}})},
        {"vertical-fade", "Vertical fade", "The lower end of the scan fades away.",
         along("z", {{0, {1, 1, 1, 0}}, {0.15, {1, 1, 1, 0}}, {0.6, {1, 1, 1, 1}}, {1, {1, 1, 1, 1}}})},
        {"depth-fade", "Depth fade", "What is far fades away.",
         along("view", {{0, {1, 1, 1, 1}}, {0.3, {1, 1, 1, 1}}, {1, {1, 1, 1, 0.05}}})},
    };
    return presets;
}

} // namespace limner
