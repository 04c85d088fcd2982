#include "core/figure/ramp_edits.h"

#include <gtest/gtest.h>

#include <random>

namespace limner {
namespace {

const RampKeys kRamp{{0, {0, 0, 0, 1}}, {0.5, {1, 0, 0, 1}}, {0.5, {0, 1, 0, 0.5}}, {1, {0, 0, 2, 0}}};

TEST(RampEdits, TheRampIsLinearAndJumpsAtAStep) {
    EXPECT_EQ(rampAt(RampKeys{}, 0.3), glm::dvec4(1));
    EXPECT_EQ(rampAt(RampKeys{{0.4, {0.1, 0.2, 0.3, 0.4}}}, 0.9), glm::dvec4(0.1, 0.2, 0.3, 0.4));
    EXPECT_EQ(rampAt(kRamp, 0.25), glm::dvec4(0.5, 0, 0, 1));
    EXPECT_EQ(rampAt(kRamp, 0.5), glm::dvec4(0, 1, 0, 0.5)) << "right-continuous";
    EXPECT_NEAR(rampAt(kRamp, 0.5 - 1e-9).r, 1, 1e-6);
    EXPECT_EQ(rampAt(kRamp, 0.75), glm::dvec4(0, 0.5, 1, 0.25));
    EXPECT_EQ(rampAt(kRamp, 1), kRamp.back().rgba);
    EXPECT_EQ(rampAt(kRamp, -1), kRamp.front().rgba);
}

TEST(RampEdits, KeysKeepTheirOrderUnderAnyMoves) {
    RampKeys keys = kRamp;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-1, 2);
    for (int i = 0; i < 2000; ++i) {
        keys = withKeyMoved(keys, random() % keys.size(), place(random));
        for (std::size_t k = 0; k < keys.size(); ++k) {
            EXPECT_GE(keys[k].at, k > 0 ? keys[k - 1].at : 0);
            EXPECT_LE(keys[k].at, 1);
        }
    }
}

TEST(RampEdits, ANewKeyChangesNothingThatIsDrawn) {
    for (const double at : {0.0, 0.2, 0.5, 0.8, 1.0}) {
        const AddedKey added = withKeyAdded(kRamp, at);
        EXPECT_EQ(added.keys.size(), kRamp.size() + 1);
        EXPECT_EQ(added.keys[added.index].at, at);
        for (double t = 0; t <= 1; t += 0.01)
            for (int c = 0; c < 4; ++c)
                EXPECT_NEAR(rampAt(added.keys, t)[c], rampAt(kRamp, t)[c], 1e-12) << at << " " << t;
        EXPECT_EQ(withKeyRemoved(added.keys, added.index), kRamp);
    }
}

TEST(RampEdits, AStepIsMadeOnce) {
    const RampKeys smooth{{0, {0, 0, 0, 1}}, {0.6, {1, 1, 1, 1}}};
    const RampKeys step = withKeyStep(smooth, 1);
    ASSERT_EQ(step.size(), 3U);
    EXPECT_EQ(rampAt(step, 0.59), glm::dvec4(0, 0, 0, 1));
    EXPECT_EQ(rampAt(step, 0.6), glm::dvec4(1));
    EXPECT_EQ(withKeyStep(step, 1), step);
    EXPECT_EQ(withKeyStep(step, 2), step);
    EXPECT_EQ(withKeyStep(smooth, 0), smooth) << "nothing is before the first";
}

TEST(RampEdits, ATonesKeysMakeARampAndBack) {
    const std::vector<ColourKey> keys{{0, {0.1, 0.2, 0.3}}, {1, {1, 0.9, 0.8}}};
    EXPECT_EQ(toneKeysOf(rampOf(keys)), keys);
    EXPECT_EQ(rampOf(keys)[0].rgba, glm::dvec4(0.1, 0.2, 0.3, 1));
}

} // namespace
} // namespace limner
