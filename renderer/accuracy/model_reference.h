#pragma once

#include "renderer/accuracy/picture_error.h"
#include "renderer/accuracy/probe.h"

namespace limner::accuracy {

/// The figure's own model - its voxels, interpolation, gradients and rays - without error of sampling (spec accuracy.md
/// 1.4): steps of 1/8, 1/16, 1/32 voxel and on without early end, until the bar is as small as it has to be, at the
/// finest 1/256; extrapolated where the error falls as it should, by the single-precision ray caster.
struct ModelReference {
    Picture searched; ///< as `drawProbe` stacks them
    Picture heldOut;
    double step = 0;  ///< the finest drawn, voxels
    double order = 0; ///< observed, of the root mean square between the last three steps
    bool extrapolated = false;
    PictureError bar; ///< of the better part of the two differences, times the factor that belongs to the order
    /// Largest difference and root mean square to the double-precision ray caster on a sixteenth of the tiles at 1/8
    /// voxel: what single precision, tables and skipping do. 0 where it was not asked for.
    PictureError arithmetic;

    /// Of a metric: both together.
    [[nodiscard]] double errorBar(ErrorMetric metric) const;
};

/// A bar that is small enough.
struct WantedBar {
    ErrorMetric metric = ErrorMetric::ciede2000;
    double value = 0.07;
};

/// Draws the reference of a figure whose quality is already its best. `judge`: the double-precision ray caster; null
/// leaves `arithmetic` out. Throws Error(notFinite) where a pixel is no number.
ModelReference makeModelReference(const Figure& figure, const PlanRequest& request, const Probe& probe,
                                  const WantedBar& wanted, const Backend& backend, const Backend* judge,
                                  Planner& planner, Task& task);

} // namespace limner::accuracy
