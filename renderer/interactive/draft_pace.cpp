#include "renderer/interactive/draft_pace.h"

#include <algorithm>
#include <cmath>

namespace limner {
namespace {

constexpr double kLongestStep = 2;  // beyond it thin walls break up and the draft misleads
constexpr double kFewestPixels = 8; // 1/64 of the pixels: still tells a view
constexpr double kFixedMs = 2;      // threads starting, delivery
constexpr double kPromptMs = 80;    // preparation and draft together: leaves a fifth of 100 ms for hiccups
constexpr double kLeastMs = 15;     // a draft made in less shows nothing

double megaRays(glm::ivec2 size, const Coarseness& coarseness) {
    const glm::ivec2 pixels = DraftPace::pixels(size, coarseness);
    const int sub = std::max(1, coarseness.subPixels);
    return static_cast<double>(pixels.x) * pixels.y * sub * sub * 1e-6;
}

} // namespace

glm::ivec2 DraftPace::pixels(glm::ivec2 size, const Coarseness& coarseness) {
    const auto scaled = [&](int length) {
        return std::max(1, static_cast<int>(std::lround(length / coarseness.pixelScale)));
    };
    return {scaled(size.x), scaled(size.y)};
}

double DraftPace::predictedMs(glm::ivec2 size, const Coarseness& coarseness) const {
    return kFixedMs + msPerMegaRay_ * megaRays(size, coarseness) / coarseness.stepScale;
}

double DraftPace::renderBudgetMs() const { return std::min(budgetMs_, std::max(kPromptMs - preparationMs_, kLeastMs)); }

Coarseness DraftPace::draft(glm::ivec2 size) const {
    Coarseness coarseness{1, 1, 1};
    const double full = predictedMs(size, coarseness) - kFixedMs;
    const double excess = full / std::max(renderBudgetMs() - kFixedMs, 1.0);
    if (excess <= 1)
        return coarseness;
    // Fewer pixels only blur, longer steps draw wood grain: the step takes the smaller part.
    coarseness.stepScale = std::min(kLongestStep, std::cbrt(excess));
    coarseness.pixelScale = std::clamp(std::sqrt(excess / coarseness.stepScale), 1.0, kFewestPixels);
    return coarseness;
}

void DraftPace::measured(glm::ivec2 size, const Coarseness& coarseness, double milliseconds, bool complete) {
    const double rays = megaRays(size, coarseness);
    if (rays <= 0)
        return;
    const double cost = std::max(milliseconds - kFixedMs, 0.05) * coarseness.stepScale / rays;
    if (!complete) { // only a lower bound
        msPerMegaRay_ = std::max(msPerMegaRay_, cost * 1.5);
        return;
    }
    constexpr double kNewest = 0.6; // trusts the newest most, yet one hiccup of the machine does not halve the pixels
    msPerMegaRay_ = known_ ? msPerMegaRay_ * (1 - kNewest) + cost * kNewest : cost;
    known_ = true;
}

} // namespace limner
