#pragma once

#include "core/style/lit_sphere.h"

#include <glm/vec2.hpp>

#include <memory>
#include <optional>
#include <vector>

namespace limner {

/// Changes of a lit sphere as functions from sphere to sphere; what the extraction and the gallery offer. Each gives
/// the same sphere back where it changes nothing.
using SpherePtr = std::shared_ptr<const LitSphere>;

/// Edge-preserving; `amount` 0..1.
SpherePtr withSmoothing(const SpherePtr& sphere, double amount);
/// Turns the light counter-clockwise about the line of sight.
SpherePtr withLightTurned(const SpherePtr& sphere, double degrees);
/// Where the light comes from, degrees counter-clockwise from +x; of a sphere lit from the front, 90.
double lightDirection(const LitSphere& sphere);
/// The mean of the sphere and its mirror image about the light's direction: takes out what is not lighting.
SpherePtr withSymmetry(const SpherePtr& sphere);
/// As if painted on white: divided by the paper's colour in linear light.
SpherePtr withoutPaperCast(const SpherePtr& sphere, const Rgba& paper);

/// One colour of it.
Rgba withoutCast(const Rgba& colour, const Rgba& paper);

/// (radius, alpha), radii rising in 0..1; constant before the first and after the last.
using AlphaCurve = std::vector<glm::dvec2>;
/// Directional opacity from the angle to the viewer alone.
SpherePtr withAlpha(const SpherePtr& sphere, const AlphaCurve& curve);

/// What to do to an extracted sphere, in this order.
struct SphereEdits {
    double smoothing = 0; ///< 0..1
    bool symmetric = false;
    double turnDegrees = 0;
    AlphaCurve alpha; ///< empty: opaque
    friend bool operator==(const SphereEdits&, const SphereEdits&) = default;
};
SpherePtr edited(SpherePtr sphere, const SphereEdits& edits);

/// A sphere from a few picked colours (way 3).
struct Swatches {
    Rgba light;
    Rgba shadow;
    std::optional<Rgba> mid = {};
    std::optional<Rgba> rim = {};
    std::optional<Rgba> highlight = {};
    glm::dvec2 towardsLight{-0.5, 0.5}; ///< n_x, n_y of the brightest place; within the unit disk
};
SpherePtr sphereOfSwatches(const Swatches& swatches, int size = 512);

} // namespace limner
