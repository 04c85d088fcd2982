#pragma once

#include "core/style/extraction/artwork.h"
#include "core/style/extraction/forms.h"

#include <glm/vec2.hpp>

#include <vector>

namespace limner {

/// Eye-space normals over a cut's pixels: (n_x, n_y), n_y UP, in the unit disk; x = NaN where there is no form.
struct NormalField {
    int width = 0;
    int height = 0;
    std::vector<glm::vec2> normals; ///< width * height, top row first
};

/// Of a ball seen as an ellipse: linear in the place (spec style-extraction.md, way 1).
NormalField ellipseNormals(const ArtCut& cut, const Ellipse& ellipse);

/// Of any form (way 2). The region is inflated: z^2 solves Poisson's equation with z = 0 along the occluding outline,
/// which is exact for an ellipsoid; what the marks say differently is spread from them by Laplace's equation.
/// `region` is over the cut's own pixels. Throws Error(cancelled).
NormalField formNormals(const ArtCut& cut, const Mask& region, const FormMarks& marks, Task& task);

} // namespace limner
