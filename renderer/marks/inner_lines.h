#pragma once

#include "core/figure/effects.h"
#include "renderer/marks/line_scene.h"
#include "renderer/marks/zero_lines.h"

#include <vector>

namespace limner {

/// Ridges and valleys of a field, the same for every view: where the principal curvature of larger size is largest
/// along its own direction. None without the field's curvatures. Takes a good part of a second for a million voxels:
/// kept beside the field.
std::vector<SurfaceLine> traceInnerLines(const MarkField& field, const StippleInnerLines& settings);

/// Those that face the viewer and that nothing hides, moving or still. A group per layer.
std::vector<MarkGroup> drawInnerLines(const LineScene& scene, const std::vector<SurfaceLine>& traced,
                                      const StippleInnerLines& settings);

} // namespace limner
