#include "core/figure/cleanup_start.h"

#include "core/style/transfer_function.h"

#include <algorithm>
#include <cmath>

namespace limner {

namespace {

constexpr double kSkinHu = -300;      // half way from air to fat, and above a cushion
constexpr double kHeadrestMm = 3;     // a shell's half thickness; ears and eyelids come back by themselves
constexpr double kIslandShare = 1e-3; // of the matter: noise is smaller, any part of a body is larger

/// The power of ten at or below a number above 0.
double decadeOf(double number) { return std::pow(10.0, std::floor(std::log10(number))); }

/// What values are rounded to: a power of ten, at most a hundredth of the volume's range; 0 for a constant one.
double valueStep(const Volume& volume) {
    const ValueRange range = volume.range();
    const double hundredth = (range.high - range.low) / 100;
    return hundredth > 0 ? decadeOf(hundredth) : 0;
}

/// The least value that shows; nothing where air does, or where more than the value decides.
std::optional<double> leastShown(const Figure& figure, ValueRange range) {
    constexpr double kFaint = 0.04; // opacity per voxel that nobody would miss
    constexpr int kSteps = 1000;
    for (int i = 0; i <= kSteps; ++i) {
        const double value = range.low + (range.high - range.low) * i / kSteps;
        for (const Layer& layer : figure.layers) {
            const Transfer& transfer = layer.transfer;
            const bool byValue = firstAxis(transfer) == TransferAxis::value && !secondAxis(transfer);
            if (byValue && figure.draws(layer) && layer.opacity * curveOpacityAt(transfer, value) > kFaint) {
                return i > 0 ? std::optional(value) : std::nullopt;
            }
        }
    }
    return std::nullopt;
}

double matterMm3(const Volume& volume, const Histogram& histogram, double above) {
    double voxels = 0;
    for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
        voxels += histogram.binCentre(i) > above ? static_cast<double>(histogram.counts[i]) : 0;
    }
    const glm::dvec3 spacing = volume.grid().spacingMm;
    return voxels * spacing.x * spacing.y * spacing.z;
}

} // namespace

CleanupStep startingStep(CleanupKind kind, const Volume& volume, const Histogram& histogram) {
    CleanupStep step;
    step.kind = kind;
    const ValueRange range = volume.range();
    const bool hounsfield = volume.contents().unit == "HU" && range.low < kSkinHu && range.high > kSkinHu;
    const double unit = valueStep(volume);
    const double otsu = histogram.otsu();
    step.above = hounsfield ? kSkinHu : unit > 0 ? std::round(otsu / unit) * unit : otsu;
    if (kind == CleanupKind::keepLargest && hounsfield) {
        step.openingMm = kHeadrestMm;
    }
    if (kind == CleanupKind::removeIslands) {
        const double share = kIslandShare * matterMm3(volume, histogram, step.above);
        if (share > 0) {
            step.belowMm3 = std::max(1.0, std::round(share / decadeOf(share))) * decadeOf(share);
        }
    }
    if (kind == CleanupKind::eraseLabel) {
        step.label = 1;
    }
    return step;
}

CleanupStep islandStep(const Figure& figure, const Volume& volume, const glm::dvec3& pointMm, double value) {
    CleanupStep step;
    step.kind = CleanupKind::keepAt;
    step.atMm = pointMm;
    const double unit = valueStep(volume);
    const double least = std::min(value, leastShown(figure, volume.range()).value_or(value));
    // Below it in any case: where all matter has one value, none is above that.
    step.above = unit > 0 ? (std::ceil(least / unit) - 1) * unit : value;
    return step;
}

} // namespace limner
