#include "core/volume/gradient_choice.h"

#include <algorithm>
#include <array>

namespace limner {

DataCharacter characterOf(const Volume& volume) { return characterOf(volume, computeGradientStatistics(volume)); }

DataCharacter characterOf(const Volume& volume, const GradientStatistics& statistics) {
    // Label volumes have 0.92 to 1, scans 0 to 0.37 (an angiogram cut off at a threshold).
    constexpr double kMask = 0.7;
    // Were it all noise, normals of a cubic B-spline would be off by 20 degrees, of Sobel's estimator by 4. Scans known
    // as clean have 0.1 to 0.2, noisy and coarse ones 0.29 to 0.55.
    constexpr double kNoisy = 0.25;
    if (volume.contents().modality == Modality::labels || statistics.stepShare > kMask) {
        return DataCharacter::mask;
    }
    return statistics.noiseToSignal > kNoisy ? DataCharacter::noisy : DataCharacter::clean;
}

bool hasThickSlices(const Grid& grid) {
    constexpr double kThick = 1.5 * (1 - 1e-6); // headers in single precision
    std::array<double, 3> spacing = {grid.spacingMm.x, grid.spacingMm.y, grid.spacingMm.z};
    std::sort(spacing.begin(), spacing.end());
    return spacing[2] >= kThick * spacing[1];
}

} // namespace limner
