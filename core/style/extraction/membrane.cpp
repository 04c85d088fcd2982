#include "core/style/extraction/membrane.h"

#include "core/base/task.h"

#include <cmath>
#include <cstddef>

namespace limner {
namespace {

using Cell = Membrane::Cell;

constexpr int kMostSteps = 400;     ///< a level starts from the coarser one's answer: tens are usual
constexpr double kConverged = 1e-5; ///< of the first residual: far below the eighth bit of a colour
constexpr int kCoarsest = 8;        ///< cells a side: few enough to be solved from nothing

std::size_t offsetOf(const Membrane& m, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(m.width) + static_cast<std::size_t>(x);
}

/// The free cells of a membrane as a system of equations: what holds each, and by which neighbours.
struct System {
    std::vector<std::size_t> cells;       ///< of the unknowns, in the grid
    std::vector<std::int32_t> neighbours; ///< four for each unknown: the unknown there, or -1
    std::vector<float> diagonal;
    std::vector<float> right;
};

System systemOf(const Membrane& m) {
    System s;
    std::vector<std::int32_t> unknownAt(m.cells.size(), -1);
    for (std::size_t i = 0; i < m.cells.size(); ++i) {
        if (m.cells[i] == Cell::free) {
            unknownAt[i] = static_cast<std::int32_t>(s.cells.size());
            s.cells.push_back(i);
        }
    }
    s.neighbours.assign(4 * s.cells.size(), -1);
    s.diagonal.assign(s.cells.size(), 0);
    s.right.assign(s.cells.size(), static_cast<float>(m.source));
    constexpr int kSteps[4][2] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};
    for (std::size_t u = 0; u < s.cells.size(); ++u) {
        const int x = static_cast<int>(s.cells[u] % static_cast<std::size_t>(m.width));
        const int y = static_cast<int>(s.cells[u] / static_cast<std::size_t>(m.width));
        for (std::size_t k = 0; k < 4; ++k) {
            const int nx = x + kSteps[k][0];
            const int ny = y + kSteps[k][1];
            if (nx < 0 || ny < 0 || nx >= m.width || ny >= m.height) {
                continue;
            }
            const std::size_t n = offsetOf(m, nx, ny);
            if (m.cells[n] == Cell::free) {
                s.neighbours[4 * u + k] = unknownAt[n];
                s.diagonal[u] += 1;
            } else if (m.cells[n] == Cell::fixed) {
                s.diagonal[u] += static_cast<float>(m.grip);
                s.right[u] += static_cast<float>(m.grip) * m.values[n];
            }
        }
    }
    return s;
}

/// The matrix times a vector.
void apply(const System& s, const std::vector<float>& v, std::vector<float>& product) {
    for (std::size_t u = 0; u < v.size(); ++u) {
        float sum = s.diagonal[u] * v[u];
        for (std::size_t k = 4 * u; k < 4 * u + 4; ++k) {
            if (s.neighbours[k] >= 0) {
                sum -= v[static_cast<std::size_t>(s.neighbours[k])];
            }
        }
        product[u] = sum;
    }
}

double dot(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += static_cast<double>(a[i]) * b[i];
    }
    return sum;
}

/// Conjugate gradients, preconditioned by the diagonal (a lone cell's diagonal of 0 leaves it as it is).
void solve(const System& s, std::vector<float>& v, Task& task) {
    const std::size_t count = v.size();
    std::vector<float> residual(count);
    std::vector<float> scaled(count);
    std::vector<float> direction(count);
    std::vector<float> product(count);
    const auto precondition = [&] {
        for (std::size_t u = 0; u < count; ++u) {
            scaled[u] = s.diagonal[u] > 0 ? residual[u] / s.diagonal[u] : 0;
        }
    };
    apply(s, v, product);
    for (std::size_t u = 0; u < count; ++u) {
        residual[u] = s.diagonal[u] > 0 ? s.right[u] - product[u] : 0;
    }
    precondition();
    direction = scaled;
    double wrong = dot(residual, scaled);
    const double enough = wrong * kConverged * kConverged;
    for (int step = 0; step < kMostSteps && wrong > enough && wrong > 0; ++step) {
        task.throwIfCancelled();
        apply(s, direction, product);
        const double curvature = dot(direction, product);
        if (!(curvature > 0)) {
            break; // nothing holds what is left
        }
        const auto length = static_cast<float>(wrong / curvature);
        for (std::size_t u = 0; u < count; ++u) {
            v[u] += length * direction[u];
            residual[u] -= length * product[u];
        }
        precondition();
        const double next = dot(residual, scaled);
        const auto keep = static_cast<float>(next / wrong);
        wrong = next;
        for (std::size_t u = 0; u < count; ++u) {
            direction[u] = scaled[u] + keep * direction[u];
        }
    }
}

/// Cells in fours: fixed where any of them is, at their mean; else free where any is; else a wall.
Membrane coarser(const Membrane& fine) {
    Membrane m;
    m.width = (fine.width + 1) / 2;
    m.height = (fine.height + 1) / 2;
    m.source = 4 * fine.source;
    m.grip = fine.grip;
    m.cells.assign(static_cast<std::size_t>(m.width) * static_cast<std::size_t>(m.height), Cell::wall);
    m.values.assign(m.cells.size(), 0);
    for (int y = 0; y < m.height; ++y) {
        for (int x = 0; x < m.width; ++x) {
            double sum = 0;
            int fixed = 0;
            int free = 0;
            for (int k = 0; k < 4; ++k) {
                const int fx = 2 * x + k % 2;
                const int fy = 2 * y + k / 2;
                if (fx >= fine.width || fy >= fine.height) {
                    continue;
                }
                const std::size_t f = offsetOf(fine, fx, fy);
                free += fine.cells[f] == Cell::free ? 1 : 0;
                if (fine.cells[f] == Cell::fixed) {
                    ++fixed;
                    sum += fine.values[f];
                }
            }
            const std::size_t c = offsetOf(m, x, y);
            m.cells[c] = fixed > 0 ? Cell::fixed : (free > 0 ? Cell::free : Cell::wall);
            m.values[c] = fixed > 0 ? static_cast<float>(sum / fixed) : 0;
        }
    }
    return m;
}

} // namespace

void solveMembrane(Membrane& membrane, Task& task) {
    task.throwIfCancelled();
    if (membrane.width > kCoarsest && membrane.height > kCoarsest) {
        Membrane coarse = coarser(membrane);
        solveMembrane(coarse, task);
        for (int y = 0; y < membrane.height; ++y) {
            for (int x = 0; x < membrane.width; ++x) {
                const std::size_t i = offsetOf(membrane, x, y);
                if (membrane.cells[i] == Cell::free) {
                    membrane.values[i] = coarse.values[offsetOf(coarse, x / 2, y / 2)];
                }
            }
        }
    }
    const System system = systemOf(membrane);
    std::vector<float> unknown(system.cells.size());
    for (std::size_t u = 0; u < unknown.size(); ++u) {
        unknown[u] = membrane.values[system.cells[u]];
    }
    solve(system, unknown, task);
    for (std::size_t u = 0; u < unknown.size(); ++u) {
        membrane.values[system.cells[u]] = unknown[u];
    }
}

} // namespace limner
