#pragma once

#include "core/base/task.h"
#include "core/volume/volume.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace limner {

/// Fields computed once per volume for figures that need them. All are volumes on the grid of their source, so that a
/// backend reads them at the place where it reads the voxels. Deterministic, parallel, thread-safe; throw
/// Error(cancelled) and Error(noResources).

/// Coefficients of the cubic B-spline that passes through the voxels (recursive prefilter of Unser 1999). To be read
/// with indices clamped to the volume: the data count as mirrored at the border voxels' faces, f[-1-k] = f[k], so that
/// the spline passes through the border's voxels too, and is that of the mirrored data in all of [0, dims - 1]. An axis
/// of one voxel stays unchanged. Kept as int16 with a slope and intercept of their own (16 bits over the coefficients'
/// range), as float32 in the source's units for float32 sources. `range()` is the coefficients'.
std::shared_ptr<const Volume> splineCoefficients(const Volume& source, Task& task);

/// Gaussian blur; sigma in voxels along each axis, 0: none; the border voxel repeats outside. Sampled weights up to 4
/// sigma: the cost grows with sigma. int16 over the result's range, or float32 for float32 sources.
std::shared_ptr<const Volume> gaussianBlurred(const Volume& source, const glm::dvec3& sigmaVoxels, Task& task);

/// Exact Euclidean distance in mm (Felzenszwalb and Huttenlocher 2012, anisotropic spacing) from every voxel centre to
/// the nearest voxel of the label; 0 inside; int16 in steps of the largest distance / 65535. Nothing where no voxel has
/// the label.
std::shared_ptr<const Volume> distanceToLabel(const Volume& labels, int label, Task& task);

/// The source on another grid: trilinear, int16 with the source's range (float32 sources too). The source reaches half
/// a voxel past its outer centres; outside it its lowest value. Grids of any direction and spacing.
std::shared_ptr<const Volume> resampledValues(const Volume& source, const Grid& grid, Task& task);

/// How much a voxel's surroundings differ from the volume, in [0, 1]: mean mu and variance var over a Gaussian of
/// `sigmaVoxels` voxels of the smallest spacing (the same length in mm along every axis; 0: the voxel itself; weights
/// and border as `gaussianBlurred`) against mean M and variance S^2 of the volume's matter,
///   1 - S^2 / (d^2 + S^2) * S^2 / (var + S^2),   d = mu - M:
/// 0 where all is M, 1/2 where a smooth place lies one S away or one at M varies as much as the matter. Our own measure
/// for the "local statistics" of paper 001's outlook. int16, 0..1 as 0..32767.
/// Matter is what lies above Otsu's threshold, where three quarters of the voxels on the twelve edges of the volume's
/// box do not: what surrounds a scanned thing is its background. Else, and where matter has one value only, it is all
/// voxels. A constant volume gives 0 everywhere. Works in 10 bytes a voxel; the cost grows with sigma.
std::shared_ptr<const Volume> localContrast(const Volume& volume, double sigmaVoxels, Task& task);

/// Slot of the label of every voxel of `grid` (nearest voxel of `labels`), uint8: `slotOf[label]`, 0 for labels that it
/// has not and outside. At most 255 slots.
std::shared_ptr<const Volume> labelSlots(const Volume& labels, const Grid& grid,
                                         const std::map<int, std::uint8_t>& slotOf, Task& task);

/// Label numbers that occur, rising, with their voxel counts. Nothing where the volume is no label volume: more than
/// 65536 different numbers, or fractions.
std::optional<std::map<int, std::size_t>> labelCounts(const Volume& labels);

} // namespace limner
