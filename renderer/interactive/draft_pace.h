#pragma once

#include <glm/vec2.hpp>

namespace limner {

/// How a picture is made: fewer pixels and longer steps make a draft.
struct Coarseness {
    double pixelScale = 1; ///< > 1: the picture has this many times fewer pixels on each side
    double stepScale = 1;  ///< > 1: this many times longer steps
    int subPixels = 0;     ///< per axis; 0: the figure's quality
    friend bool operator==(const Coarseness&, const Coarseness&) = default;
};

/// Chooses a coarseness from the measured speed, so that a draft comes in time on any machine and any figure. The
/// model is one number, the time per ray and step length, which changes little while a figure is edited. Not
/// thread-safe.
class DraftPace {
  public:
    explicit DraftPace(double budgetMs) : budgetMs_(budgetMs) {}

    /// Coarseness whose predicted time is within the budget, or the full picture with one ray per pixel if that is.
    [[nodiscard]] Coarseness draft(glm::ivec2 size) const;
    [[nodiscard]] double predictedMs(glm::ivec2 size, const Coarseness& coarseness) const;
    /// A picture of that full size and coarseness took so long; `complete` false: it was stopped after that time.
    void measured(glm::ivec2 size, const Coarseness& coarseness, double milliseconds, bool complete);

    /// What went before the last rendering (planning) takes its part of the budget from the next draft.
    void prepared(double milliseconds) { preparationMs_ = milliseconds; }

    /// Pixels of a picture of full size `size`.
    static glm::ivec2 pixels(glm::ivec2 size, const Coarseness& coarseness);

  private:
    [[nodiscard]] double renderBudgetMs() const;

    double budgetMs_;
    double preparationMs_ = 0;
    /// Per million rays at the figure's step. The first guess is slow, so that the first draft is early: 512^2 of a
    /// real head takes a third of it on two cores.
    double msPerMegaRay_ = 1000;
    bool known_ = false;
};

} // namespace limner
