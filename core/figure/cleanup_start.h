#pragma once

#include "core/figure/figure.h"
#include "core/volume/histogram.h"

namespace limner {

/// A clean-up step that does something sensible to a scan before anybody has set a number: matter is what is denser
/// than air where the values are Hounsfield units, else what is above Otsu's threshold; islands go that hold less than
/// a thousandth of it; in CT a headrest that touches the skin does not count as the patient. Numbers are rounded to
/// what a person would type. `histogram`: of the volume.
CleanupStep startingStep(CleanupKind kind, const Volume& volume, const Histogram& histogram);

/// Keeps the island that is seen at a point, where the figure's volume has this value: matter is what is as dense as
/// the least that the figure shows, or as that value, whichever is less, to a hundredth of the volume's range.
CleanupStep islandStep(const Figure& figure, const Volume& volume, const glm::dvec3& pointMm, double value);

} // namespace limner
