#pragma once

#include "core/style/lit_sphere.h"

#include <glm/vec3.hpp>

#include <vector>

namespace limner::accuracy {

/// What the hardware of 2002 kept of a normal (paper 003, section 3.1): one of 240 directions, those of the faces of a
/// dodecahedron and an icosahedron combined (60 triangles, each of one vertex of the icosahedron and an edge of the
/// dodecahedron) and divided in four. Limner keeps real normals; this says what that is worth. Unit vectors.
const std::vector<glm::dvec3>& quantisedDirections();

/// The direction nearest to a unit normal.
glm::dvec3 quantisedNormal(const glm::dvec3& normal);

struct NormalQuantisationError {
    double meanDeg = 0;
    double largestDeg = 0;
};
/// Over the whole sphere, every direction alike: the mean over `samples` even points, the largest exactly.
NormalQuantisationError measureNormalQuantisation(int samples);

struct LitSphereError {
    double rms = 0;     ///< over pixels and the three channels, 0..1
    double largest = 0; ///< of any channel
};
/// A ball of `pixels` across that is drawn in a style (sRGB-encoded, as the style is) by its 240 directions instead of
/// by its normals; over the pixels whose middle lies on the ball.
LitSphereError measureLitSphereError(const LitSphere& style, int pixels);

} // namespace limner::accuracy
