#pragma once

#include "core/volume/grid.h"

namespace limner {

/// Whether the boxes of two grids have more than a face in common. Exact, for grids of any direction.
bool boxesOverlap(const Grid& a, const Grid& b);

/// Share of a grid's box that lies in another's, 0..1: exact for the same grid, else to within about 3 %.
double coveredShare(const Grid& box, const Grid& cover);

} // namespace limner
