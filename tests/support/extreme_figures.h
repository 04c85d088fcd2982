#pragma once

#include "core/figure/figure.h"
#include "renderer/backend.h"
#include "renderer/plan/planner.h"

#include <string>

namespace limner::testing {

/// A small figure that is pushed to several extremes at a time (numerics.md 2f), and which of its pixels to draw.
struct ExtremeFigure {
    Figure figure;
    PlanRequest request; ///< the whole picture's size, up to 32768 pixels a side
    Tile tile;           ///< what is drawn of it: up to 12 x 12 pixels
    std::string story;   ///< what was pushed, in words
};

/// The same for the same seed. Everything that a file may hold may be in it: what validation refuses is not.
ExtremeFigure extremeFigure(unsigned seed);

} // namespace limner::testing
