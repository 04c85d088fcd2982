#include "core/style/extraction/membrane.h"

#include "core/base/error.h"
#include "core/base/task.h"

#include <gtest/gtest.h>

#include <cmath>

namespace limner {
namespace {

using Cell = Membrane::Cell;

Membrane freeMembrane(int width, int height) {
    const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    return {width, height, std::vector<Cell>(count, Cell::free), std::vector<float>(count, 0), 0, 1};
}

TEST(Membrane, AHarmonicFunctionComesBackFromItsBorder) {
    constexpr int kSide = 61;
    Membrane m = freeMembrane(kSide, kSide);
    const auto truth = [](int x, int y) {
        return static_cast<float>(0.01 * (x * x - y * y) / 60.0 + 0.005 * x * y / 60.0);
    };
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            if (x == 0 || y == 0 || x == kSide - 1 || y == kSide - 1) {
                const auto i = static_cast<std::size_t>(y * kSide + x);
                m.cells[i] = Cell::fixed;
                m.values[i] = truth(x, y);
            }
        }
    }
    Task task;
    solveMembrane(m, task);
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            EXPECT_NEAR(m.values[static_cast<std::size_t>(y * kSide + x)], truth(x, y), 2e-5) << x << ", " << y;
        }
    }
}

TEST(Membrane, NothingFlowsThroughAWall) {
    // Two halves, each held at one end: without a wall between them values would run from 0 to 1.
    Membrane m = freeMembrane(40, 8);
    for (int y = 0; y < 8; ++y) {
        const auto row = static_cast<std::size_t>(40 * y);
        m.cells[row] = Cell::fixed;
        m.cells[row + 20] = Cell::wall;
        m.cells[row + 39] = Cell::fixed;
        m.values[row + 39] = 1;
    }
    Task task;
    solveMembrane(m, task);
    EXPECT_NEAR(m.values[40 * 4 + 19], 0, 1e-4);
    EXPECT_NEAR(m.values[40 * 4 + 21], 1, 1e-4);
}

TEST(Membrane, ASourceLiftsADiskToAParaboloid) {
    constexpr int kSide = 101;
    constexpr double kRadius = 45;
    Membrane m = freeMembrane(kSide, kSide);
    m.source = 4;
    m.grip = 2;
    const auto far = [](int x, int y) { return std::hypot(x + 0.5 - kSide / 2.0, y + 0.5 - kSide / 2.0); };
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            m.cells[static_cast<std::size_t>(y * kSide + x)] = far(x, y) < kRadius ? Cell::free : Cell::fixed;
        }
    }
    Task task;
    solveMembrane(m, task);
    for (int x = 10; x < kSide - 10; x += 8) {
        const double r = far(x, kSide / 2);
        const double height = m.values[static_cast<std::size_t>(kSide / 2 * kSide + x)];
        // The outline is a staircase: within a quarter of a cell, at a slope of 2 r.
        EXPECT_NEAR(height, kRadius * kRadius - r * r, 0.25 * 2 * kRadius) << x;
    }
}

TEST(Membrane, StopsWhenToldTo) {
    Membrane m = freeMembrane(64, 64);
    m.cells[0] = Cell::fixed;
    Task task;
    task.cancel();
    EXPECT_THROW(solveMembrane(m, task), Error);
}

} // namespace
} // namespace limner
