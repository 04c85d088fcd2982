#pragma once

#include "core/style/extraction/picture.h"

namespace limner {

class Task;

/// What a disk of gathered colours lacks. `disk` is square, alpha 1 where there were votes and 0 where not; texels
/// whose centre lies outside the inscribed disk do not count. Internal to core/style/extraction.

/// Share of the disk that had votes.
double diskCoverage(const ArtPicture& disk);
/// The widest stretch of directions without votes: around each of them, as far as the nearest one with some, but not
/// beyond the rim. 0 where all had.
double largestHoleDegrees(const ArtPicture& disk);
/// Fills the holes by a membrane over the disk, free at its rim, held by what is covered; all alphas become 1. At least
/// one texel must be covered. Throws Error(cancelled).
void fillHoles(ArtPicture& disk, Task& task);

} // namespace limner
