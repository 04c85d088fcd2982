#pragma once

#include "core/figure/effects.h"
#include "renderer/marks/line_scene.h"

#include <vector>

namespace limner {

/// Lines where the surface turns away from the viewer (paper 004, 5.6): of mark voxels with v LoG < `log`,
/// |n.e| < `eye` and |g| > `gradient`. Moving: a segment along n x e for each. Still: the zero of n.e on the surface
/// along such voxels, in whole lines of the pen's width. A group per layer for visible lines and for hidden ones.
std::vector<MarkGroup> drawSilhouettes(const LineScene& scene, const StippleCurves& settings);

} // namespace limner
