#pragma once

#include "core/base/task.h"
#include "core/volume/volume.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace limner {

/// Counts of a volume's voxels over equal bins of two measures; both ends included, what lies outside counts in the
/// outermost bins.
struct JointHistogram {
    ValueRange x;
    ValueRange y;
    int columns = 0;
    int rows = 0;
    std::vector<std::uint64_t> counts; ///< row after row, the first at the low end of y

    [[nodiscard]] std::uint64_t at(int column, int row) const {
        return counts[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                      static_cast<std::size_t>(column)];
    }
    [[nodiscard]] std::uint64_t greatest() const {
        return counts.empty() ? 0 : *std::max_element(counts.begin(), counts.end());
    }
};

/// An axis of a joint histogram.
struct JointAxis {
    ValueRange range;
    int bins = 256; ///< at least 1
};

/// All of these run in parallel, count every voxel of `volume` once, and throw Error(cancelled).

/// Value of the volume over that of another one on the same grid.
JointHistogram jointHistogram(const Volume& volume, const JointAxis& x, const Volume& second, const JointAxis& y,
                              Task& task);
/// Value over the magnitude of the gradient by central differences, divided by `gradientMax` (data's unit per mm;
/// not above 0: all are 0) and held in 0..1: the transfer functions' axis "gradient".
JointHistogram jointHistogramOfGradient(const Volume& volume, const JointAxis& x, double gradientMax, int rows,
                                        Task& task);
/// Value over the distance of the voxels' centres from a point, in mm.
JointHistogram jointHistogramOfDistance(const Volume& volume, const JointAxis& x, const glm::dvec3& fromMm,
                                        const JointAxis& y, Task& task);

} // namespace limner
