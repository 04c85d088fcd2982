#pragma once

#include "renderer/accuracy/analytic_scenes.h"

#include <glm/vec3.hpp>

#include <array>

namespace limner::accuracy {

/// Scenes of importance-aware composition whose picture is known in closed form (spec accuracy.md 1.5, A5 and A8). Rays
/// run along +x; the noise floor is off and nothing is capped below 64.

/// A5: a slab of opacity a0 in red that is not important; a gap; a slab of optical depth tau in green, of importance D.
struct ImportancePair {
    double frontOpacity = 0.99;
    double importance = 2;
    double depth = 0.5;
    [[nodiscard]] AnalyticScene scene(int stepsPerSlab) const;
    /// Shares of red and of green in the picture, and its opacity; the same at every step.
    [[nodiscard]] glm::dvec3 weights() const;
};

/// A5 as the specification tabulates it.
struct ImportanceRow {
    ImportancePair pair;
    glm::dvec3 tabulated;
};
std::array<ImportanceRow, 7> importanceTable();

/// A5 with a step's error: one medium on [0, 1] mm whose colour is x and whose importance is `slope` x.
struct RisingImportance {
    double extinctionPerMm = 3;
    double slope = 10;
    [[nodiscard]] AnalyticScene scene(double stepMm) const;
    /// With E = e^I: E' = s (e^(g x) - E), and behind the place where a = E e^(-g x) colours obey (c E)' = E' x.
    [[nodiscard]] double premultiplied() const;
};

/// A8: a sheet of importance 20 that is 0.003 mm thick in the middle of 1 mm of one medium; sheet white, all else
/// black.
struct ThinSheet {
    double extinctionPerMm = 5;
    double importance = 20;
    double frontMm = 0.5;
    double thicknessMm = 0.003;
    [[nodiscard]] AnalyticScene scene(double stepMm) const;
    [[nodiscard]] double premultiplied() const;
};

} // namespace limner::accuracy
