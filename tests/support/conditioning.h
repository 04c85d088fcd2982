#pragma once

#include "support/extreme_figures.h"

#include <memory>
#include <string>
#include <vector>

namespace limner::testing {

/// How far a figure's exact picture goes when the figure itself moves by what a backend in single precision with tables
/// cannot tell: a transfer function by an entry of its table, rays and samples by a few ulp of the volume's diagonal,
/// opacities by a few ulp, gradients by what rounding leaves of equal voxels. Where a rounding decides between two
/// sides of a step, or where a claim of importance is made by next to no opacity (numerics.md 2c, Conditioning), this
/// is large, and no backend can be held to less.
class Conditioning {
  public:
    /// Of rays that go to their end.
    Conditioning(const ExtremeFigure& made, const RenderPlan& plan);

    /// Of a pixel of the whole picture: the greatest difference of a channel, and the move that makes it.
    struct Spread {
        double most = 0;
        std::string by;
    };
    [[nodiscard]] Spread at(glm::ivec2 pixel) const;

  private:
    struct Neighbour {
        std::string name;
        std::shared_ptr<const RenderPlan> plan;
    };
    void addTransfers(const ExtremeFigure& made);
    void addRays();

    RenderPlan plan_;
    std::vector<Neighbour> neighbours_;
    std::unique_ptr<Backend> exact_;
};

} // namespace limner::testing
