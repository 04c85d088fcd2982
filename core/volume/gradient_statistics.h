#pragma once

#include "core/volume/volume.h"

namespace limner {

/// Central-difference gradients of a volume over its voxels, in the data's unit per mm.
struct GradientStatistics {
    double p999 = 0;  ///< 99.9th percentile of the magnitude: g_max of paper 000 as the spec defines it
    double noise = 0; ///< robust estimate of the gradient magnitude that noise alone gives (median over flat matter)
};

/// Samples at most a few million voxels on a fixed lattice, in parallel; deterministic.
GradientStatistics computeGradientStatistics(const Volume& volume);

} // namespace limner
