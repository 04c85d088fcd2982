#pragma once

#include <array>
#include <span>
#include <vector>

namespace limner {

/// How much of each of 4 x 4 pixels a small disc covers, for its radius and where in its pixel the middle lies.
class DotStencils {
  public:
    static constexpr int kEdge = 4;
    static constexpr float kLargestRadius = 1.5F; ///< pixels: still inside 4 x 4 wherever it lies
    static constexpr int kPhases = 16;            ///< of a pixel, each way
    static constexpr int kSizes = 24;
    using Stencil = std::array<float, kEdge * kEdge>;

    static const DotStencils& instance();

    /// `phaseX`, `phaseY` in [0, kPhases): of the disc's middle less kLargestRadius; the stencil begins at that pixel.
    /// Times `scaleOf(radius)` the coverage adds up to the disc's area.
    [[nodiscard]] const Stencil& at(float radius, int phaseX, int phaseY) const {
        return stencils_[static_cast<std::size_t>((sizeOf(radius) * kPhases + phaseY) * kPhases + phaseX)];
    }
    /// By size, then by the phase down, then by the phase across.
    [[nodiscard]] std::span<const Stencil> all() const { return stencils_; }
    [[nodiscard]] static float scaleOf(float radius) {
        const float ratio = radius * kSizesPerPixel / static_cast<float>(sizeOf(radius) + 1);
        return ratio * ratio;
    }

  private:
    static constexpr int kSizesPerPixel = 16;

    DotStencils();
    [[nodiscard]] static int sizeOf(float radius) {
        const int size = static_cast<int>(radius * kSizesPerPixel + 0.5F);
        return size < 1 ? 0 : (size > kSizes ? kSizes - 1 : size - 1);
    }

    std::vector<Stencil> stencils_;
};

} // namespace limner
