#pragma once

#include "core/figure/effects.h"

#include <glm/vec2.hpp>

#include <span>

namespace limner {

struct RenderPlan;

/// A lens in its place on the picture (paper 001; spec importance-composition.md, "Focus lens"). Lengths are shares of
/// the figure's height, so that a poster shows the same lens as the screen.
struct PlanLens {
    Lens lens;
    glm::dvec2 centre{0}; ///< from the figure's top left corner, right and down
    bool seen = true;     ///< false: its anchor is behind the eye
};

PlanLens placeLens(const Lens& lens, const RenderPlan& plan);

/// Distance from a lens' middle over that to its border in the same direction; a box has the round corners of a
/// superellipse of fourth degree. `offset`: right and down.
double lensDistance(const Lens& lens, glm::dvec2 offset);

/// What the lenses make of the global weight at a point: the greatest of their factors; 1 without lenses. `point`: from
/// the figure's top left corner, right and down, in heights of the figure.
double lensFactor(std::span<const PlanLens> lenses, glm::dvec2 point);

/// Whether every point of a rectangle has the factor 0. May say no where it is so.
bool lensesMiss(std::span<const PlanLens> lenses, glm::dvec2 low, glm::dvec2 high);

} // namespace limner
