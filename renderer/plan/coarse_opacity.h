#pragma once

#include "core/base/task.h"
#include "renderer/plan/render_plan.h"

namespace limner {

/// How opaque the plan's layers make the volume, on cells of `voxelsPerCell`^3 voxels: for each cell the mean, over its
/// voxels, of the opacity of a column of that matter as long as the cell; layers one behind the other. What a clip cuts
/// away is clear. A sketch for depth cues: labels count by the nearest voxel and gradients by central differences.
/// Parallel, deterministic. Throws Error(cancelled).
CueField coarseOpacity(const RenderPlan& plan, int voxelsPerCell, Task& task);

/// False for layers by curvature or importance: what they show is known along rays only.
bool countsInCues(const PlanLayer& layer);

/// A binomial blur over three cells, of a field of one channel: its cells are not to be seen in what is made of them.
void smooth(CueField& field);

/// Voxels per cell, so that no axis has more than `mostCells`.
int voxelsPerCell(const Grid& grid, int mostCells);

} // namespace limner
