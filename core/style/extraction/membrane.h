#pragma once

#include <cstdint>
#include <vector>

namespace limner {

class Task;

/// A membrane over a grid: `laplace(v) = -source` at free cells, held at fixed ones, no flux into walls (and beyond the
/// grid). Internal to core/style/extraction.
struct Membrane {
    enum class Cell : std::uint8_t { wall, fixed, free };

    int width = 0;
    int height = 0;
    std::vector<Cell> cells;   ///< width * height, top row first
    std::vector<float> values; ///< the same; at fixed cells what they are held at, at free ones a first guess or 0
    double source = 0;         ///< in units of the cell's size
    /// How strongly a fixed cell holds its neighbour: 1 where its value is at its centre, 2 where it is at the edge
    /// between them.
    double grip = 1;
};

/// Fills the values of the free cells: from coarse grids to fine ones, each by conjugate gradients to 1e-5 of what was
/// wrong at first. Free cells that no fixed one holds keep a constant. Throws Error(cancelled).
void solveMembrane(Membrane& membrane, Task& task);

} // namespace limner
