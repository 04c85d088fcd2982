#pragma once

#include "core/volume/volume.h"

namespace limner {

/// Central-difference gradients of a volume over its voxels, in the data's unit per mm.
struct GradientStatistics {
    double p999 = 0;  ///< 99.9th percentile of the magnitude: g_max of paper 000 as the spec defines it
    double noise = 0; ///< robust estimate of the gradient magnitude that noise alone gives (median over flat matter)
    /// What varies from voxel to voxel against what a surface gives: the gradient magnitude that white noise of the
    /// fourth differences' strength has, over the magnitude itself; median over the voxels with at least an eighth of
    /// `p999`. About 0.01 on smooth data, 0.5 on a sharp step, 0.9 on noise alone.
    double noiseToSignal = 0;
    /// Share of the variation across voxels (sum of |after - before| along the axes) that jumps in one step: the voxel
    /// between equals one of the two. 1 for segmentations, below 0.4 where edges pass through values between.
    double stepShare = 0;
};

/// Samples at most a few million voxels on a fixed lattice, in parallel; deterministic.
GradientStatistics computeGradientStatistics(const Volume& volume);

} // namespace limner
