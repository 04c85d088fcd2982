#include "core/figure/part_presets.h"

#include "core/figure/figure_json.h"
#include "core/figure/ramp_edits.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace limner {
namespace {

Figure figureWith(const Layer& part) {
    Figure figure;
    Layer layer = part;
    layer.transfer.nodes = {{0, "", glm::dvec3(1, 0.5, 0)}};
    layer.transfer.opacity = {{0, 1}};
    figure.layers = {layer};
    return figure;
}

/// Valid, and the same after a file.
void expectSound(const Figure& figure) {
    for (const Problem& problem : validateFigure(figure))
        EXPECT_FALSE(problem.fatal) << problem.pointer << ": " << problem.why;
    EXPECT_EQ(readFigure(writeFigure(figure), "here").layers, figure.layers);
}

template <class Key>
int stepsOf(const std::vector<Key>& keys) {
    const auto step = [](const Key& a, const Key& b) { return a.at == b.at && a != b; };
    int steps = 0;
    for (std::size_t i = 1; i < keys.size(); ++i)
        steps += step(keys[i - 1], keys[i]) ? 1 : 0;
    return steps;
}

double lightness(const glm::dvec4& rgba) { return rgba.r * 0.3 + rgba.g * 0.6 + rgba.b * 0.1; }

TEST(PartPresets, EveryToneIsValidAndRisesToTheLight) {
    std::set<std::string> ids;
    for (const PartPreset<Tone>& preset : tonePresets()) {
        SCOPED_TRACE(preset.id);
        EXPECT_TRUE(ids.insert(preset.id).second);
        EXPECT_FALSE(preset.name.empty());
        EXPECT_TRUE(preset.help.ends_with(".")) << preset.help;
        Layer layer;
        layer.tone = preset.part;
        expectSound(figureWith(layer));
        const RampKeys ramp = rampOf(preset.part.keys);
        ASSERT_GE(ramp.size(), 2U);
        EXPECT_EQ(ramp.front().at, 0);
        EXPECT_EQ(ramp.back().at, 1);
        for (double at = 0; at < 1; at += 0.05)
            EXPECT_LE(lightness(rampAt(ramp, at)), lightness(rampAt(ramp, at + 0.05)) + 1e-12) << at;
        EXPECT_GT(lightness(rampAt(ramp, 1)), lightness(rampAt(ramp, 0.3)) + 0.2) << "a head light shows it";
    }
}

TEST(PartPresets, AbruptTonesJumpAndSmoothOnesDoNot) {
    const std::map<std::string, int> jumps{
        {"cool-to-warm", 0}, {"cartoon", 3}, {"two-tones", 1}, {"sepia-wash", 0}, {"night-blue", 0}};
    ASSERT_EQ(tonePresets().size(), jumps.size());
    for (const PartPreset<Tone>& preset : tonePresets()) {
        const std::vector<ColourKey>& keys = preset.part.keys;
        EXPECT_EQ(stepsOf(keys), jumps.at(preset.id)) << preset.id;
        for (std::size_t i = 1; jumps.at(preset.id) > 0 && i < keys.size(); ++i)
            EXPECT_TRUE(keys[i].at == keys[i - 1].at || keys[i].rgb == keys[i - 1].rgb) << "flat between its jumps";
    }
}

TEST(PartPresets, EveryPositionRampIsValidAndDoesWhatItsNameSays) {
    std::map<std::string, PositionRamp> found;
    for (const PartPreset<PositionRamp>& preset : positionPresets()) {
        SCOPED_TRACE(preset.id);
        EXPECT_TRUE(found.emplace(preset.id, preset.part).second);
        Layer layer;
        layer.position = preset.part;
        expectSound(figureWith(layer));
    }
    const auto warmth = [](const glm::dvec4& c) { return c.r - c.b; };
    for (const char* id : {"aerial-perspective", "warm-to-cool"}) {
        const PositionRamp& ramp = found.at(id);
        EXPECT_EQ(ramp.axis, "view");
        EXPECT_GT(warmth(rampAt(ramp.ramp, 0)), 0.1) << id;
        EXPECT_LT(warmth(rampAt(ramp.ramp, 1)), -0.1) << id;
    }
    EXPECT_EQ(rampAt(found.at("aerial-perspective").ramp, 0).a, 1);
    EXPECT_LT(rampAt(found.at("aerial-perspective").ramp, 1).a, 0.7);
    EXPECT_EQ(rampAt(found.at("warm-to-cool").ramp, 1).a, 1);
    EXPECT_EQ(found.at("vertical-fade").axis, "z");
    EXPECT_EQ(rampAt(found.at("vertical-fade").ramp, 0).a, 0);
    EXPECT_EQ(rampAt(found.at("vertical-fade").ramp, 1).a, 1);
    EXPECT_EQ(found.at("depth-fade").axis, "view");
    EXPECT_LT(rampAt(found.at("depth-fade").ramp, 1).a, 0.1);
}

} // namespace
} // namespace limner
