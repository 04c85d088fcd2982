#pragma once

#include "core/volume/volume.h"

#include <array>
#include <cstdint>
#include <vector>

namespace limner {

/// Counts of a volume's voxels over equal bins of its value range; both ends included.
struct Histogram {
    ValueRange range;
    std::vector<std::uint64_t> counts;

    [[nodiscard]] double binCentre(std::size_t bin) const;
    [[nodiscard]] double lowerEdge(std::size_t bin) const;
    /// Value below which the share `fraction` of all voxels lies, to one bin.
    [[nodiscard]] double percentile(double fraction) const;
    /// Values of the clear maxima of the smoothed histogram, most prominent first.
    [[nodiscard]] std::vector<double> peaks(std::size_t atMost) const;
    /// Threshold that parts two classes of least variance (Otsu 1979).
    [[nodiscard]] double otsu() const;
    /// The lower and the upper threshold that part three.
    [[nodiscard]] std::array<double, 2> otsuOfThree() const;
};

/// Runs in parallel; every voxel is counted once. `bins` > 0; a constant volume puts all into the first bin.
Histogram computeHistogram(const Volume& volume, int bins);

} // namespace limner
