// The functions of the SIMD scalar against the standard library's in double, on every instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/renderer/cpu/optics_lanes_test.cpp"
#include <hwy/foreach_target.h> // must come before the headers that each target compiles anew
#include <hwy/highway.h>        // names the target: before the formulas

#include "renderer/cpu/optics_lanes-inl.h"

#ifndef LIMNER_LANE_FUNCTIONS
#define LIMNER_LANE_FUNCTIONS
namespace limner {
/// Results for 16 pairs of arguments.
struct LaneResults {
    float exp[16], expm1[16], log1p[16], exp2[16], log2[16], pow[16], atan2[16], min[16], max[16];
};
} // namespace limner
#endif

HWY_BEFORE_NAMESPACE();
namespace limner::HWY_NAMESPACE {

void laneFunctions(const float* x, const float* y, LaneResults& out) {
    for (std::size_t i = 0; i < 16; i += hn::Lanes(kF)) {
        const Lanes a(hn::LoadU(kF, x + i));
        const Lanes b(hn::LoadU(kF, y + i));
        const auto keep = [&](Lanes result, float* to) HWY_ATTR { hn::StoreU(result.v, kF, to + i); };
        keep(exp(a), out.exp);
        keep(expm1(a), out.expm1);
        keep(log1p(a), out.log1p);
        keep(exp2(a), out.exp2);
        keep(log2(a), out.log2);
        keep(pow(a, b), out.pow);
        keep(atan2(a, b), out.atan2);
        keep(min(a, b), out.min);
        keep(max(a, b), out.max);
    }
}

} // namespace limner::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include "renderer/cpu/kernel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

namespace limner {
namespace {

HWY_EXPORT(laneFunctions);

constexpr float kInfinity = std::numeric_limits<float>::infinity();

class LaneFunctions : public ::testing::TestWithParam<std::string> {
  protected:
    void SetUp() override { restrictKernelTarget(GetParam()); }
    void TearDown() override { restrictKernelTarget(""); }

    static LaneResults all(const float* x, const float* y) {
        LaneResults out;
        HWY_DYNAMIC_DISPATCH(laneFunctions)(x, y, out);
        return out;
    }
    /// Of one pair.
    static LaneResults of(float x, float y = 1) {
        float xs[16];
        float ys[16];
        std::fill(std::begin(xs), std::end(xs), x);
        std::fill(std::begin(ys), std::end(ys), y);
        return all(xs, ys);
    }
    /// The largest |lane - exact| / scale(exact) over 16,000 arguments from low to high.
    template <typename Exact, typename Scale>
    static double worst(float low, float high, float (LaneResults::*lanes)[16], Exact exact, Scale scale) {
        std::mt19937 random(11);
        std::uniform_real_distribution<float> between(low, high);
        double largest = 0;
        for (int block = 0; block < 1000; ++block) {
            float x[16];
            for (float& value : x) {
                value = between(random);
            }
            const LaneResults out = all(x, x);
            for (int i = 0; i < 16; ++i) {
                const double expected = exact(static_cast<double>(x[i]));
                largest = std::max(largest, std::abs((out.*lanes)[i] - expected) / scale(expected));
            }
        }
        return largest;
    }
};

double relative(double expected) { return std::abs(expected) + 1e-37; }
double absolute(double) { return 1; }

TEST_P(LaneFunctions, AreAccurate) {
    const auto exp = [](double x) { return std::exp(x); };
    const auto exp2 = [](double x) { return std::exp2(x); };
    const auto log2 = [](double x) { return std::log2(x); };
    const auto log1p = [](double x) { return std::log1p(x); };
    const auto expm1 = [](double x) { return std::expm1(x); };
    // 2e-7: three and a half units of rounding
    EXPECT_LT(worst(-1, 1, &LaneResults::exp, exp, relative), 2e-7);
    EXPECT_LT(worst(-80, 80, &LaneResults::exp, exp, relative), 2e-7);
    EXPECT_LT(worst(-1, 1, &LaneResults::exp2, exp2, relative), 2e-7);
    EXPECT_LT(worst(-126, 127.9F, &LaneResults::exp2, exp2, relative), 2e-7);
    EXPECT_LT(worst(0.5F, 2, &LaneResults::log2, log2, relative), 2e-7);
    EXPECT_LT(worst(0.999F, 1.001F, &LaneResults::log2, log2, relative), 2e-7);
    EXPECT_LT(worst(1e-30F, 1e-20F, &LaneResults::log2, log2, relative), 2e-7);
    EXPECT_LT(worst(1, 1e30F, &LaneResults::log2, log2, relative), 2e-7);
    EXPECT_LT(worst(1e-42F, 1e-38F, &LaneResults::log2, log2, relative), 2e-7); // below the smallest normal number
    // Highway's own: 4 units
    EXPECT_LT(worst(-0.999F, 1, &LaneResults::log1p, log1p, relative), 4e-7);
    EXPECT_LT(worst(0, 1e6F, &LaneResults::log1p, log1p, relative), 4e-7);
    EXPECT_LT(worst(-1e-6F, 1e-6F, &LaneResults::log1p, log1p, relative), 4e-7);
    EXPECT_LT(worst(-30, 3, &LaneResults::expm1, expm1, relative), 4e-7);
    EXPECT_LT(worst(-1e-6F, 1e-6F, &LaneResults::expm1, expm1, relative), 4e-7);
    // Both arguments are the same: x^x.
    EXPECT_LT(worst(
                  0, 4, &LaneResults::pow, [](double x) { return std::pow(x, x); }, relative),
              1e-6);
}

TEST_P(LaneFunctions, HaveTheirEnds) {
    EXPECT_EQ(of(-kInfinity).exp[0], 0);
    EXPECT_EQ(of(-1e30F).exp[0], 0);
    EXPECT_EQ(of(0).exp[0], 1);
    EXPECT_EQ(of(1e30F).exp[0], kInfinity);
    EXPECT_EQ(of(-kInfinity).expm1[0], -1);
    EXPECT_EQ(of(1e30F).expm1[0], kInfinity);
    EXPECT_EQ(of(-1).log1p[0], -kInfinity);
    EXPECT_EQ(of(kInfinity).log1p[0], kInfinity);
    EXPECT_EQ(of(-kInfinity).exp2[0], 0);
    EXPECT_EQ(of(1e30F).exp2[0], kInfinity);
    EXPECT_EQ(of(-149).exp2[0], std::numeric_limits<float>::denorm_min());
    EXPECT_EQ(of(0).log2[0], -kInfinity);
    EXPECT_TRUE(std::isnan(of(-1).log2[0]));
    EXPECT_EQ(of(kInfinity).log2[0], kInfinity);
    for (int power = -149; power < 128; ++power) {
        EXPECT_EQ(of(std::ldexp(1.0F, power)).log2[0], power);
        EXPECT_EQ(of(static_cast<float>(power)).exp2[0], std::ldexp(1.0F, power));
    }
    EXPECT_EQ(of(0, 0).pow[0], 1);
    EXPECT_EQ(of(0, 2).pow[0], 0);
    EXPECT_EQ(of(1, 1e30F).pow[0], 1);
}

TEST_P(LaneFunctions, AnglesAreRightInEveryQuadrant) {
    double largest = 0;
    for (int i = 0; i < 16000; ++i) {
        const double angle = (i + 0.5) / 8000 * M_PI - M_PI;
        const double length = std::pow(10, i % 11 - 5);
        const auto x = static_cast<float>(length * std::cos(angle));
        const auto y = static_cast<float>(length * std::sin(angle));
        largest = std::max(largest, std::abs(of(y, x).atan2[0] - std::atan2(double(y), double(x))));
    }
    EXPECT_LT(largest, 4e-7);
    EXPECT_EQ(of(0, 0).atan2[0], 0);
    EXPECT_EQ(of(0, 1).atan2[0], 0);
    EXPECT_NEAR(of(0, -1).atan2[0], M_PI, 1e-7);
    EXPECT_NEAR(of(1, 0).atan2[0], M_PI / 2, 1e-7);
    EXPECT_NEAR(of(-1, 0).atan2[0], -M_PI / 2, 1e-7);
    EXPECT_LT(worst(
                  0, 1, &LaneResults::atan2, [](double) { return M_PI / 4; }, absolute),
              2e-7); // x = y
}

TEST_P(LaneFunctions, MinAndMaxTreatWhatIsNoNumberAsTheStandardLibrary) {
    const float none = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(of(1, none).min[0], 1);
    EXPECT_EQ(of(1, none).max[0], 1);
    EXPECT_TRUE(std::isnan(of(none, 1).min[0]));
    EXPECT_TRUE(std::isnan(of(none, 1).max[0]));
}

INSTANTIATE_TEST_SUITE_P(Targets, LaneFunctions, ::testing::ValuesIn(kernelTargets()),
                         [](const auto& target) { return target.param; });

} // namespace
} // namespace limner

#endif
