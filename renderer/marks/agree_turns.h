#pragma once

#include <glm/vec2.hpp>

#include <cstddef>
#include <vector>

namespace limner {

/// Directions without a sign on a grid of paper, as twice their angles: the length is how certain they are.
struct TurnGrid {
    glm::ivec2 size{0};
    std::vector<float> depthMm; ///< not a number where no surface is
    std::vector<glm::vec2> turns;

    [[nodiscard]] std::size_t indexOf(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x);
    }
};

/// Directions between what each cell asks for and what its neighbours have: where a cell is uncertain, it follows them.
/// Neighbours whose depths are further apart than `jumpMm` are of different surfaces. Parallel; the same for any number
/// of threads.
std::vector<glm::vec2> agreedTurns(const TurnGrid& asked, float jumpMm);

} // namespace limner
