#pragma once

#include "core/figure/figure.h"
#include "renderer/marks/marks.h"
#include "renderer/plan/planner.h"

#include <functional>
#include <memory>
#include <vector>

namespace limner::testing {

/// A volume of `edge`^3 voxels of a mm around the origin: 1 inside the body, 0 outside, a ramp of two voxels between.
/// `distanceMm`: from the body's surface, positive outside.
std::shared_ptr<const Volume> bodyVolume(int edge, const std::function<double(const glm::dvec3&)>& distanceMm);
/// Matter below z = 0.
std::shared_ptr<const Volume> slabVolume(int edge);

/// Ink alone on a square of paper, seen along -y with z up, or from above where `fromAbove`; the paper shows
/// `heightMm`.
Figure inkFigure(std::shared_ptr<const Volume> volume, double paperMm, double heightMm);
void lookFromAbove(Figure& figure);

std::shared_ptr<const RenderPlan> markPlan(const Figure& figure, bool moving = false);
Marks marksOf(const Figure& figure, bool moving = false);

/// All dots of all groups.
std::vector<Dot> allDots(const Marks& marks);

/// Share of the square [low, high)^2 of paper that dots cover, measured on a lattice of places a twentieth of a dot
/// apart; dots that are not whole count by their opacity.
double inkedShare(const Marks& marks, double lowMm, double highMm);

} // namespace limner::testing
