#include "renderer/marks/dot_stencils.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace limner {

namespace {

/// Exact along rows, by chords of 32 lines a pixel across them; then scaled to the disc's own area.
DotStencils::Stencil coverageOf(double radius, double x, double y) {
    constexpr int kLines = 32;
    std::array<double, DotStencils::kEdge * DotStencils::kEdge> shares{};
    double sum = 0;
    for (int line = 0; line < DotStencils::kEdge * kLines; ++line) {
        const double above = (line + 0.5) / kLines - y;
        if (std::abs(above) >= radius)
            continue;
        const double half = std::sqrt(radius * radius - above * above);
        for (int column = 0; column < DotStencils::kEdge; ++column) {
            const double covered = std::min(x + half, column + 1.0) - std::max(x - half, static_cast<double>(column));
            if (covered > 0) {
                shares[static_cast<std::size_t>(line / kLines * DotStencils::kEdge + column)] += covered / kLines;
                sum += covered / kLines;
            }
        }
    }
    const double scale = sum > 0 ? std::numbers::pi * radius * radius / sum : 0;
    DotStencils::Stencil stencil{};
    std::transform(shares.begin(), shares.end(), stencil.begin(), [&](double share) {
        return static_cast<std::uint16_t>(std::lround(std::min(share * scale, 1.0) * DotStencils::kWhole));
    });
    return stencil;
}

} // namespace

const DotStencils& DotStencils::instance() {
    // Isolated: while it waits, the thread that makes them must not take up a task that asks for them.
    static const std::unique_ptr<const DotStencils> stencils =
        tbb::this_task_arena::isolate([] { return std::unique_ptr<const DotStencils>(new DotStencils); });
    return *stencils;
}

DotStencils::DotStencils() {
    constexpr std::size_t kOfSize = std::size_t{kPhases} * kPhases;
    stencils_.resize(kSizes * kOfSize);
    tbb::parallel_for(std::size_t{0}, std::size_t{kSizes} * kPhases, [&](std::size_t row) {
        const double radius = static_cast<double>(row / kPhases + kFirstSize) / kSizesPerPixel;
        const double y = kLargestRadius + static_cast<double>(row % kPhases) / kPhases;
        for (std::size_t x = 0; x < kPhases; ++x)
            stencils_[row * kPhases + x] = coverageOf(radius, kLargestRadius + static_cast<double>(x) / kPhases, y);
    });
}

} // namespace limner
