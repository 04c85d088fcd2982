#include "renderer/accuracy/signal_peak.h"

#include "support/rendering.h"

#include <gtest/gtest.h>

// The total error of a picture, that of the sampled field included, against the field itself (accuracy.md 1.7).

namespace limner {
namespace {

using accuracy::SignalPeak;
using testing::BackendTest;
using testing::renderWhole;
using testing::rootMeanSquare;

class TotalError : public BackendTest {
  protected:
    static constexpr int kPixels = 24;
    [[nodiscard]] double of(const SignalPeak& peak, Interpolation interpolation, GradientEstimator gradient) const {
        return rootMeanSquare(renderWhole(backend(), peak.scene(interpolation, gradient, 0.0625, kPixels)),
                              peak.truth(kPixels));
    }
};
LIMNER_ON_EVERY_BACKEND(TotalError);

TEST_P(TotalError, IsTenTimesLessWithBetterReconstruction) {
    for (const double width : {0.1, 0.02}) {
        SignalPeak peak;
        peak.width = width;
        const double plain = of(peak, Interpolation::linear, GradientEstimator::central);
        const double better = of(peak, Interpolation::tricubic, GradientEstimator::bspline);
        EXPECT_GT(plain / better, 10) << width << ": " << plain << " and " << better;
    }
}

TEST(SignalPeakTruth, DoesNotHangOnItsSteps) {
    const SignalPeak peak;
    EXPECT_LT(rootMeanSquare(peak.truth(8, 4096), peak.truth(8, 1024)), 1e-5);
}

} // namespace
} // namespace limner
