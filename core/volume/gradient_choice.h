#pragma once

#include "core/volume/gradient_statistics.h"

namespace limner {

/// What a volume's numbers are like, as far as it matters for estimating gradients.
enum class DataCharacter {
    clean, ///< smooth from voxel to voxel: estimators of high order show what is there
    noisy, ///< noise, or edges sharper than the voxels resolve, turns gradients: estimators that average
    mask,  ///< matter changes in one step, as in segmentations: to be smoothed before gradients mean anything
};

/// By measure: mask where the variation is in steps (or the file says labels), noisy where `noiseToSignal` is high,
/// else clean; a constant volume is clean. Deterministic; costs `computeGradientStatistics` (some 30 ms for 256^3).
DataCharacter characterOf(const Volume& volume);
/// The same where the volume's statistics are at hand.
DataCharacter characterOf(const Volume& volume, const GradientStatistics& statistics);

/// Whether one axis has a spacing of at least 1.5 times either of the others: slices thicker than their pixels, which
/// show as terraces.
bool hasThickSlices(const Grid& grid);

} // namespace limner
