#pragma once

#include "core/style/extraction/picture.h"

namespace limner {

class Task;

/// What a disk of gathered colours lacks. `disk` is square, alpha 1 where there were votes and 0 where not; texels
/// whose centre lies outside the inscribed disk do not count. Internal to core/style/extraction.

/// Share of the disk that had votes.
double diskCoverage(const Picture& disk);
/// Twice the largest angle between a direction without votes and the nearest one with some; 0 where all had.
double largestHoleDegrees(const Picture& disk);
/// Fills the holes by a membrane over the disk, free at its rim, held by what is covered; all alphas become 1. At least
/// one texel must be covered. Throws Error(cancelled).
void fillHoles(Picture& disk, Task& task);

} // namespace limner
