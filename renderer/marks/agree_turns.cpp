#include "renderer/marks/agree_turns.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace limner {

namespace {

/// What a neighbour weighs against a certain direction of a cell's own.
constexpr float kNeighbour = 3;
/// Neighbours that disagree among themselves count less.
constexpr float kDisagreeing = 0.7F;
constexpr int kSteps = 30;
/// Directions spread over long ways on coarser grids.
constexpr int kCoarser = 3;
constexpr int kFewestCells = 24;

TurnGrid coarser(const TurnGrid& fine) {
    TurnGrid coarse;
    coarse.size = (fine.size + kCoarser - 1) / kCoarser;
    const std::size_t count = static_cast<std::size_t>(coarse.size.x) * static_cast<std::size_t>(coarse.size.y);
    coarse.depthMm.assign(count, std::numeric_limits<float>::quiet_NaN());
    coarse.turns.assign(count, glm::vec2(0));
    for (int y = 0; y < coarse.size.y; ++y) {
        for (int x = 0; x < coarse.size.x; ++x) {
            glm::vec2 turn(0);
            float depth = 0;
            float cells = 0;
            for (int v = y * kCoarser; v < std::min((y + 1) * kCoarser, fine.size.y); ++v) {
                for (int u = x * kCoarser; u < std::min((x + 1) * kCoarser, fine.size.x); ++u) {
                    const std::size_t i = fine.indexOf(u, v);
                    if (!std::isnan(fine.depthMm[i])) {
                        turn += fine.turns[i];
                        depth += fine.depthMm[i];
                        cells += 1;
                    }
                }
            }
            if (cells > 0) {
                coarse.turns[coarse.indexOf(x, y)] = turn / cells;
                coarse.depthMm[coarse.indexOf(x, y)] = depth / cells;
            }
        }
    }
    return coarse;
}

/// One step of all cells.
void relax(const TurnGrid& asked, float jumpMm, const std::vector<glm::vec2>& now, std::vector<glm::vec2>& next) {
    tbb::parallel_for(0, asked.size.y, [&](int y) {
        for (int x = 0; x < asked.size.x; ++x) {
            const std::size_t i = asked.indexOf(x, y);
            const float depth = asked.depthMm[i];
            if (std::isnan(depth)) {
                continue;
            }
            glm::vec2 sum = asked.turns[i];
            float weights = glm::length(sum);
            const std::array<glm::ivec2, 4> around{{{x - 1, y}, {x + 1, y}, {x, y - 1}, {x, y + 1}}};
            for (const glm::ivec2& at : around) {
                if (at.x < 0 || at.y < 0 || at.x >= asked.size.x || at.y >= asked.size.y) {
                    continue;
                }
                const std::size_t j = asked.indexOf(at.x, at.y);
                if (std::abs(asked.depthMm[j] - depth) < jumpMm) { // never where it is not a number
                    sum += kNeighbour / std::max(glm::length(now[j]), kDisagreeing) * now[j];
                    weights += kNeighbour;
                }
            }
            next[i] = weights > 0 ? sum / weights : glm::vec2(0);
        }
    });
}

} // namespace

std::vector<glm::vec2> agreedTurns(const TurnGrid& asked, float jumpMm) {
    std::vector<glm::vec2> now = asked.turns;
    if (std::min(asked.size.x, asked.size.y) >= kFewestCells) {
        const TurnGrid coarse = coarser(asked);
        const std::vector<glm::vec2> far = agreedTurns(coarse, jumpMm * kCoarser);
        for (int y = 0; y < asked.size.y; ++y) {
            for (int x = 0; x < asked.size.x; ++x) {
                now[asked.indexOf(x, y)] = far[coarse.indexOf(x / kCoarser, y / kCoarser)];
            }
        }
    }
    std::vector<glm::vec2> next(now.size(), glm::vec2(0));
    for (int step = 0; step < kSteps; ++step) {
        relax(asked, jumpMm, now, next);
        std::swap(now, next);
    }
    return now;
}

} // namespace limner
