#pragma once

#include "renderer/picture.h"

#include <glm/vec3.hpp>

#include <vector>

namespace limner::accuracy {

/// Pixels of the printed picture in one degree of the reader's view, from 300 mm away.
double pixelsPerDegree(double pixelsPerMm);

/// Colour difference (CIEDE2000) of every pixel, row by row, as a reader sees it: fine patterns blend before they are
/// compared (S-CIELAB: Zhang and Wandell 1997, A spatial extension of CIELAB; the opponent channels and Gaussians of
/// its table). Both pictures of one size, laid on the background (sRGB); a pixel that is no number counts as white
/// against black.
std::vector<float> perceivedDifferences(const Picture& picture, const Picture& reference, const glm::dvec3& background,
                                        double pixelsPerDegree);

} // namespace limner::accuracy
