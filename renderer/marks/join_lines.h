#pragma once

#include "renderer/marks/zero_lines.h"

namespace limner {

/// Joins ends that lie within some voxels of each other and point at each other, the nearest first, and drops lines
/// that are shorter than `leastVoxels` or too weak.
std::vector<SurfaceLine> joinLines(std::vector<SurfaceLine> lines, double voxelMm, double leastVoxels);

} // namespace limner
