#pragma once

#include "renderer/accuracy/analytic_scenes.h"
#include "renderer/picture.h"

namespace limner::accuracy {

/// The signal of A6 with three rings, a Gaussian peak of opacity in its values and Phong's head light: what a picture's
/// total error is made of, sampling of the field included (spec accuracy.md 1.7). Its truth is the field itself.
struct SignalPeak {
    MarschnerLobb signal{0.25, 3};
    int voxels = 64;    ///< per axis, on [-1, 1]^3 mm
    double peak = 0.5;  ///< of the opacity, a value of the signal
    double width = 0.1; ///< its standard deviation
    /// Orthographic, 1.6 mm of the signal across, far from its sides.
    [[nodiscard]] AnalyticScene scene(Interpolation interpolation, GradientEstimator gradient, double stepVoxels,
                                      int pixels) const;
    /// The scene's picture without voxels: each ray in `steps` pieces over the field and its gradient in closed form.
    [[nodiscard]] Picture truth(int pixels, int steps = 4096) const;
};

} // namespace limner::accuracy
