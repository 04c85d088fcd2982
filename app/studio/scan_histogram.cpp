#include "app/studio/scan_histogram.h"

#include <cmath>

namespace limner {
namespace {

constexpr int kHistogramBins = 4096; // finer than any screen is wide, at any useful zoom

/// One bin per value where there are few values: finer ones would stand empty in between.
int histogramBins(const Volume& volume) {
    if (volume.type() != VoxelType::uint8)
        return kHistogramBins;
    const ValueRange range = volume.range();
    return 1 + static_cast<int>(std::lround((range.high - range.low) / std::abs(volume.contents().slope)));
}

} // namespace

std::shared_ptr<const Histogram> scanHistogram(const Figure& figure) {
    if (!figure.volume || !figure.volume->data)
        return nullptr;
    const Volume& volume = *figure.volume->data;
    return std::make_shared<const Histogram>(computeHistogram(volume, histogramBins(volume)));
}

} // namespace limner
