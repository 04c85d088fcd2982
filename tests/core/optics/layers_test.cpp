#include "core/optics/layers.h"
#include "core/optics/opacity.h"

#include <gtest/gtest.h>

#include <cmath>

namespace limner::optics {
namespace {

TEST(ToneRamp, RunsFromShadeToLight) {
    EXPECT_DOUBLE_EQ(tonePlace(1.0, 1.0), 1);
    EXPECT_DOUBLE_EQ(tonePlace(-1.0, 1.0), 0);
    EXPECT_DOUBLE_EQ(tonePlace(0.5, 1.0), 0.75);
    EXPECT_DOUBLE_EQ(tonePlace(1.0, 0.0), 0.5) << "where there is no surface, neither shade nor light";
    EXPECT_DOUBLE_EQ(tonePlace(1.0 + 1e-12, 1.0), 1) << "rounding does not leave the ramp";
}

TEST(SilhouetteShare, FallsFromFullToNone) {
    EXPECT_DOUBLE_EQ(silhouetteShare(0.0, 0.1, 0.3, 1.0), 1);
    EXPECT_DOUBLE_EQ(silhouetteShare(-0.1, 0.1, 0.3, 1.0), 1) << "backs have outlines as fronts do";
    EXPECT_DOUBLE_EQ(silhouetteShare(0.2, 0.1, 0.3, 1.0), 0.5);
    EXPECT_DOUBLE_EQ(silhouetteShare(0.3, 0.1, 0.3, 1.0), 0);
    EXPECT_DOUBLE_EQ(silhouetteShare(0.0, 0.1, 0.3, 0.0), 0) << "no surface, no outline";
    EXPECT_DOUBLE_EQ(silhouetteShare(0.19, 0.2, 0.2, 1.0), 1) << "equal edges are a step";
    EXPECT_DOUBLE_EQ(silhouetteShare(0.2, 0.2, 0.2, 1.0), 0);
}

TEST(Highlight, IsThatOfTheHalfwayVector) {
    // Light and viewer 60 degrees apart, the normal half way between them.
    EXPECT_NEAR(halfway(std::cos(M_PI / 6), std::cos(M_PI / 6), 0.5), 1, 1e-12);
    // The light at the eye: h is the direction to the viewer.
    EXPECT_NEAR(halfway(0.3, 0.3, 1.0), 0.3, 1e-12);
    EXPECT_DOUBLE_EQ(halfway(0.7, -0.7, -1.0), 0) << "the light right behind: no half way";
    EXPECT_DOUBLE_EQ(halfway(-0.5, 0.1, 0.2), 0) << "turned away";
}

TEST(Lines, LieOverTheirShadingWhateverTheStep) {
    const double shading = 0.3;
    const double line = 0.6;
    const double both = withLine(shading, line);
    EXPECT_DOUBLE_EQ(both, 1 - (1 - shading) * (1 - line));
    EXPECT_DOUBLE_EQ(lineShare(shading, line), line / both);
    EXPECT_DOUBLE_EQ(lineShare(0.0, 0.0), 0);
    EXPECT_DOUBLE_EQ(lineShare(1.0, 0.0), 0);
    EXPECT_DOUBLE_EQ(lineShare(0.5, 1.0), 1);
    // One colour and one opacity of the reference length: seven parts of a step make the step.
    Accumulated<double> whole = compositeBehind<double>({0, 0, 0, 0}, {lineShare(shading, line), 0, 0}, both);
    Accumulated<double> parts{0, 0, 0, 0};
    for (int i = 0; i < 7; ++i) {
        parts = compositeBehind<double>(parts, {lineShare(shading, line), 0, 0}, opacityOfLength(both, 1.0 / 7));
    }
    EXPECT_NEAR(parts.r, whole.r, 1e-14);
    EXPECT_NEAR(parts.a, whole.a, 1e-14);
}

TEST(Cuts, KeepTheExactShareOfALength) {
    for (const double inside : {-0.4, -0.25, 0.0, 0.1, 0.3, 2.0}) {
        // A sample of length 0.8 that meets the plane at 60 degrees: the distance changes by 0.4 over it.
        const double reach = 0.4;
        int kept = 0;
        constexpr int n = 100000;
        for (int i = 0; i < n; ++i) {
            kept += inside + reach * ((i + 0.5) / n - 0.5) > 0 ? 1 : 0;
        }
        EXPECT_NEAR(keptByPlane(inside, reach), static_cast<double>(kept) / n, 2e-5) << inside;
    }
    EXPECT_DOUBLE_EQ(keptByPlane(0.0, 0.0), 1) << "a ray in the plane is kept";
    EXPECT_DOUBLE_EQ(keptByPlane(-1e-9, 0.0), 0);
}

TEST(CutFaces, AreAVoxelDeepAndFadeOverAnother) {
    EXPECT_DOUBLE_EQ(cutFaceShare(0.0), 1);
    EXPECT_DOUBLE_EQ(cutFaceShare(1.0), 1);
    EXPECT_DOUBLE_EQ(cutFaceShare(1.5), 0.5);
    EXPECT_DOUBLE_EQ(cutFaceShare(2.0), 0);
}

TEST(DepthOfField, IsSharpAtTheFocus) {
    EXPECT_DOUBLE_EQ(blurLevel(0.4, 0.4, 5.0), 0);
    EXPECT_DOUBLE_EQ(blurLevel(0.65, 0.4, 1.0), 1);
    EXPECT_DOUBLE_EQ(blurLevel(0.15, 0.4, 1.0), 1);
    EXPECT_DOUBLE_EQ(blurLevel(1.0, 0.0, 100.0), kBlurLevels);
}

/// Occlusion 1 wherever n.d < c: mean and 2 n . (mean of occlusion times direction), in closed form.
double ambientOfCap(double c) { return ambientOcclusion((1 + c) / 2, -(1 - c * c) / 4, 1.0); }

TEST(AmbientOcclusion, IsNothingOnAFlatSurface) {
    EXPECT_NEAR(ambientOfCap(0), 0, 1e-15);
    EXPECT_NEAR(ambientOfCap(-0.5), 0, 1e-15) << "a sample just outside the matter";
    EXPECT_NEAR(ambientOfCap(1), 1, 1e-15) << "shut in";
    double before = 0;
    for (double c = 0; c <= 1; c += 0.1) {
        EXPECT_GE(ambientOfCap(c) + 1e-12, before) << "darker the narrower the opening, at " << c;
        before = ambientOfCap(c);
    }
    EXPECT_DOUBLE_EQ(ambientOcclusion(1.0, 0.0, 0.0), 0);
}

TEST(Shadows, LieOnWhatFacesTheLight) {
    EXPECT_DOUBLE_EQ(shadowed(1.0, 1.0, 1.0), 1);
    EXPECT_DOUBLE_EQ(shadowed(1.0, -0.2, 1.0), 0);
    EXPECT_DOUBLE_EQ(shadowed(0.4, 0.3, 1.0), 0.4);
    EXPECT_DOUBLE_EQ(shadowed(1.0, 0.15, 1.0), 0.5);
}

} // namespace
} // namespace limner::optics
