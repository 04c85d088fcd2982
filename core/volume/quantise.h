#pragma once

#include "core/base/task.h"
#include "core/volume/volume.h"

#include <memory>
#include <vector>

namespace limner {

/// A volume in at most 256 levels, and what that costs.
struct QuantisedVolume {
    /// One byte a voxel: the codes, with `Volume::Contents::levels` for their values where those are uneven.
    std::shared_ptr<const Volume> volume;
    std::vector<double> levels; ///< rising, in the data's unit; code k stands for levels[k]
    double meanSquareError = 0; ///< over all voxels, in the data's unit squared
    double largestError = 0;    ///< in the data's unit
};

/// The levels of least mean square error that Lloyd's iteration reaches (S. P. Lloyd, 1957/1982; J. Max, 1960), on the
/// histogram: every stored number of 16-bit data for itself, 65,536 bins of float data with their means. It starts from
/// levels as dense as the cube root of the histogram (Panter and Dite 1951) and from even ones, and keeps the better
/// end: never worse than `quantiseUniformly`. Exact where there are no more than 256 values. Throws Error(cancelled),
/// Error(noResources).
QuantisedVolume quantiseLloydMax(const Volume& volume, Task& task);

/// Even levels: the middles of 256 equal parts of the value range. For comparison.
QuantisedVolume quantiseUniformly(const Volume& volume, Task& task);

/// Lloyd's iteration on its own. `values` rise strictly, `weights` (same length, above 0) say how often each
/// occurs. Gives at most `count` rising levels.
std::vector<double> lloydMaxLevels(const std::vector<double>& values, const std::vector<double>& weights,
                                   std::size_t count);

} // namespace limner
