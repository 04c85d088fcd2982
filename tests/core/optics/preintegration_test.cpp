#include "core/optics/preintegration.h"

#include "core/optics/opacity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

// Slabs between two samples: closed forms (accuracy.md 1.5), and the place of what is seen.

namespace limner::optics {
namespace {

/// Depth and place of a slab of length 1 whose extinction is linear between the entries 0, 1, ... of a table.
struct Slab {
    double depth = 0;
    double seen = 0;
};

Slab slabOf(int entries, const std::function<double(double)>& extinctionAtEntry) {
    SlabIntegrals<double> sum{0, 0, 0};
    for (int k = 0; k < entries; ++k) {
        const auto own =
            countedFrom(integralsInside(extinctionAtEntry(k), extinctionAtEntry(k + 1), 1.0), static_cast<double>(k));
        sum = {sum.depth + own.depth, sum.first + own.first, sum.second + own.second};
    }
    const double back = entries;
    const double depth = meanExtinction(0.0, back, sum.depth, 0.0);
    return {depth, seenPlace(momentsBetween(0.0, back, sum), depth)};
}

/// Mean place of what is seen, by brute force: integral of u sigma exp(-depth so far) over 1 - exp(-depth).
double seenByStrips(const std::function<double(double)>& extinction) {
    constexpr int strips = 200000;
    double depth = 0;
    double sum = 0;
    for (int i = 0; i < strips; ++i) {
        const double u = (i + 0.5) / strips;
        const double own = extinction(u) / strips;
        sum += u * std::exp(-depth) * -std::expm1(-own);
        depth += own;
    }
    return sum / -std::expm1(-depth);
}

TEST(Preintegration, AnEvenMediumIsSeenWhereMorelandAndAngelSeeIt) {
    for (const double depth : {1e-9, 1e-3, 0.05, 0.0999999, 0.1, 0.3, 1.0, 2.0, 10.0, 100.0}) {
        const double psi = -std::expm1(-depth) / depth; // mean transmittance
        const double zeta = std::exp(-depth);
        if (depth > 1e-2) { // below, the quotient cancels
            EXPECT_NEAR(evenSeenPlace(depth), (psi - zeta) / (1 - zeta), 1e-9) << depth;
        }
        EXPECT_NEAR(evenSeenPlace(depth), seenByStrips([&](double) { return depth; }), 1e-6) << depth;
        EXPECT_NEAR(evenSeenPlace(static_cast<float>(depth)), evenSeenPlace(depth), 2e-6) << depth;
    }
    EXPECT_EQ(evenSeenPlace(0.0), 0.5);
}

TEST(Preintegration, A1OpacityIsThatOfTheMedium) {
    for (const double extinction : {0.01, 2.0, 30.0}) {
        const Slab slab = slabOf(7, [&](double) { return extinction; });
        EXPECT_NEAR(opacityOfDepth(slab.depth), 1 - std::exp(-extinction), 1e-15);
        EXPECT_NEAR(slab.seen, evenSeenPlace(extinction), 1e-12);
    }
}

TEST(Preintegration, A2OneSlabHasTheRampsOpacityAndItsColourToTheBlocksError) {
    const double s0 = 4;
    const Slab slab = slabOf(64, [&](double k) { return s0 * k / 64; });
    EXPECT_NEAR(opacityOfDepth(slab.depth), 0.864664716763, 1e-12);
    // A ramp counts as a block of the same mean and spread: 0.4 % of the colour's range in a slab as deep as this.
    EXPECT_NEAR(opacityOfDepth(slab.depth) * slab.seen, 0.462808723425, 0.004);
    // A block without attenuation would be seen at its mean.
    EXPECT_GT(opacityOfDepth(slab.depth) * (2.0 / 3) - 0.462808723425, 0.1);
}

TEST(Preintegration, A2FallsWithTheThirdPowerOfTheStepOrFaster) {
    const double s0 = 4;
    const auto colour = [&](int slabs) {
        double sum = 0;
        double through = 1;
        for (int i = 0; i < slabs; ++i) {
            const auto extinction = [&](double k) { return s0 * (i + k / 16) / slabs / slabs; };
            const Slab slab = slabOf(16, extinction);
            sum += through * opacityOfDepth(slab.depth) * (i + slab.seen) / slabs;
            through *= std::exp(-slab.depth);
        }
        return sum;
    };
    const double exact = -std::exp(-s0 / 2) + std::sqrt(std::numbers::pi / (2 * s0)) * std::erf(std::sqrt(s0 / 2));
    double before = std::abs(colour(1) - exact);
    for (int slabs = 2; slabs <= 8; slabs *= 2) {
        const double error = std::abs(colour(slabs) - exact);
        EXPECT_GT(std::log2(before / error), 2.7) << slabs;
        before = error;
    }
}

TEST(Preintegration, ABlockOfMatterIsExact) {
    for (const double extinction : {0.1, 3.0, 40.0, 90.0}) { // of the block, which is from a quarter to a half
        const auto at = [&](double k) { return k >= 256 && k < 512 ? extinction : 0.0; };
        const Slab slab = slabOf(1024, at);
        const double depth = extinction / 4;
        EXPECT_NEAR(slab.depth, depth, 1e-3 * depth); // the table's ends slope over an entry
        EXPECT_NEAR(slab.seen, 0.25 + 0.25 * evenSeenPlace(depth), 2e-3);
    }
}

TEST(Preintegration, AThinSheetIsSeenWhereItIs) {
    for (const double extinction : {1e-4, 1.0, 1e4}) {
        const Slab slab = slabOf(4096, [&](double k) { return k == 3000 ? extinction : 0.0; });
        EXPECT_NEAR(slab.seen, 3000.0 / 4096, 1.0 / 4096);
    }
}

TEST(Preintegration, WhateverIsFaintIsSeenAtItsMean) {
    const auto profile = [](double u) { return 1e-4 * (1 + std::sin(9 * u) + 3 * u * u); };
    const Slab slab = slabOf(512, [&](double k) { return profile(k / 512); });
    EXPECT_NEAR(slab.seen, seenByStrips(profile), 1e-5);
}

TEST(Preintegration, DeepMatterIsSeenInsideItself) {
    for (const double depth : {0.5, 3.0, 20.0}) {
        for (const double power : {0.0, 1.0, 2.0, 4.0}) { // ever later
            const auto profile = [&](double u) { return depth * (power + 1) * std::pow(u, power); };
            const Slab slab = slabOf(512, [&](double k) { return profile(k / 512); });
            const double exact = seenByStrips(profile);
            EXPECT_NEAR(slab.seen, exact, power == 0 ? 1e-5 : 0.15) << depth << ' ' << power;
            EXPECT_GE(slab.seen, 0);
            EXPECT_LE(slab.seen, 1);
        }
    }
}

TEST(Preintegration, EndsOfOneValueDoNotCancel) {
    // Integrals that differ by nothing but rounding.
    EXPECT_EQ(meanExtinction(100.0F, 100.0F, 1e-3F, 0.7F), 0.7F);
    EXPECT_EQ(meanExtinction(100.0F, 100.01F, -1e-3F, 0.7F), 0.7F);
    EXPECT_EQ(meanExtinction(100.0, 101.0, -1e-9, 0.7), 0);
    const SlabMoments<double> moments = momentsBetween(5.0, 5.0, SlabIntegrals<double>{0, 0, 0});
    EXPECT_EQ(moments.mean, 0.5);
    EXPECT_EQ(moments.variance, 1.0 / 12);
    // Falling values are the same slab seen from the other side.
    const SlabIntegrals<double> up = countedFrom(integralsInside(1.0, 3.0, 1.0), 0.0);
    const SlabMoments<double> rising = momentsBetween(0.0, 1.0, up);
    const SlabMoments<double> falling = momentsBetween(1.0, 0.0, {-up.depth, -up.first, -up.second});
    EXPECT_NEAR(rising.mean + falling.mean, 1, 1e-15);
    EXPECT_NEAR(rising.variance, falling.variance, 1e-15);
}

TEST(Preintegration, OpacityOneIsDeepAndFinite) {
    EXPECT_EQ(extinctionOfOpacity(1.0), kOpaqueExtinction);
    EXPECT_EQ(extinctionOfOpacity(2.0), kOpaqueExtinction);
    EXPECT_EQ(extinctionOfOpacity(0.0), 0);
    EXPECT_EQ(extinctionOfOpacity(-1.0), 0);
    EXPECT_NEAR(extinctionOfOpacity(0.5), std::log(2.0), 1e-15);
}

} // namespace
} // namespace limner::optics
