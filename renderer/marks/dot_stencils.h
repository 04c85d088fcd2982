#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace limner {

/// How much of each of 4 x 4 pixels a small disc covers, for its radius and where in its pixel the middle lies.
class DotStencils {
  public:
    static constexpr int kEdge = 4;
    static constexpr float kLargestRadius = 1.5F; ///< pixels: still inside 4 x 4 wherever it lies
    static constexpr int kLog2Phases = 5;
    static constexpr int kPhases = 1 << kLog2Phases; ///< of a pixel, each way
    static constexpr int kSizes = 46;
    static constexpr float kWhole = 65535;                    ///< a pixel that is covered
    using Stencil = std::array<std::uint16_t, kEdge * kEdge>; ///< of a size, all stay in the first cache

    static const DotStencils& instance();

    /// `phaseX`, `phaseY` in [0, kPhases): of the disc's middle less kLargestRadius; the stencil begins at that pixel.
    /// Times `scaleOf(radius)` the coverage adds up to the disc's area.
    [[nodiscard]] const Stencil& at(float radius, int phaseX, int phaseY) const {
        return stencils_[static_cast<std::size_t>((sizeOf(radius) * kPhases + phaseY) * kPhases + phaseX)];
    }
    /// By size, then by the phase down, then by the phase across.
    [[nodiscard]] std::span<const Stencil> all() const { return stencils_; }
    [[nodiscard]] static float scaleOf(float radius) {
        const float ratio = radius * kSizesPerPixel / static_cast<float>(sizeOf(radius) + kFirstSize);
        return ratio * ratio;
    }

  private:
    static constexpr int kSizesPerPixel = 32;
    static constexpr int kFirstSize = 3; ///< smaller ones are a few parts of kWhole, and no one sees their shape

    DotStencils();
    [[nodiscard]] static int sizeOf(float radius) {
        const int size = static_cast<int>(radius * kSizesPerPixel + 0.5F);
        return std::clamp(size - kFirstSize, 0, kSizes - 1);
    }

    std::vector<Stencil> stencils_;
};

} // namespace limner
