#include "core/style/ramps.h"

#include <gtest/gtest.h>

namespace limner {
namespace {

void expectColour(const glm::dvec3& a, const glm::dvec3& b) {
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(a[i], b[i], 1e-12);
    }
}

TEST(ToneRamps, AreLinearBetweenKeysAndStepWhereTwoMeet) {
    Tone tone;
    tone.keys = {{0.2, {0, 0, 1}}, {0.6, {1, 0, 1}}, {0.6, {1, 1, 0}}, {1, {1, 1, 1}}};
    expectColour(toneAt(tone, 0), {0, 0, 1});
    expectColour(toneAt(tone, 0.4), {0.5, 0, 1});
    expectColour(toneAt(tone, 0.6), {1, 1, 0}); // right-continuous
    expectColour(toneAt(tone, 0.8), {1, 1, 0.5});
    expectColour(toneAt(tone, 2), {1, 1, 1});
    expectColour(toneAt(Tone{}, 0.5), {1, 1, 1}); // no keys: nothing changes
}

TEST(ToneRamps, SaturationLeavesTheLuminance) {
    Tone tone;
    tone.keys = {{0, {0.8, 0.2, 0.4}}};
    const double luminance = 0.2126 * 0.8 + 0.7152 * 0.2 + 0.0722 * 0.4;
    tone.saturation = 0;
    expectColour(toneAt(tone, 0), glm::dvec3(luminance));
    tone.saturation = 2;
    expectColour(toneAt(tone, 0), {2 * 0.8 - luminance, 2 * 0.2 - luminance, 2 * 0.4 - luminance});
    tone.saturation = 4;
    EXPECT_DOUBLE_EQ(toneAt(tone, 0).g, 0) << "never below black";
}

TEST(PositionRamps, TellWhetherTheyFade) {
    PositionRamp ramp;
    ramp.ramp = {{0, {1, 1, 1, 1}}, {1, {0.5, 0.5, 2, 1}}};
    EXPECT_FALSE(changesOpacity(ramp));
    ramp.ramp[1].rgba.a = 0.5;
    EXPECT_TRUE(changesOpacity(ramp));
    EXPECT_DOUBLE_EQ(positionTintAt(ramp, 0.5).a, 0.75);
    EXPECT_DOUBLE_EQ(positionTintAt(ramp, 0.5).b, 1.5);
}

TEST(RampTables, AreTheFunctionsAtTheirEntries) {
    Tone tone;
    tone.keys = {{0, {0, 0.5, 1}}, {1, {1, 0.5, 0}}};
    const auto table = bakeTone(tone);
    ASSERT_EQ(table.size(), static_cast<std::size_t>(kRampEntries));
    for (const int i : {0, 1, 511, 1023}) {
        const glm::dvec3 exact = toneAt(tone, i / 1023.0);
        EXPECT_EQ(table[static_cast<std::size_t>(i)].r, static_cast<float>(exact.r)) << i;
        EXPECT_EQ(table[static_cast<std::size_t>(i)].a, 1) << i;
    }
    EXPECT_EQ(bakeUnitCurve({{0, 0}, {1, 1}}).back(), 1);
}

} // namespace
} // namespace limner
