#pragma once

#include "renderer/plan/render_plan.h"

#include <optional>

namespace limner {

/// Width of one ray in the target plane, voxels of the smallest spacing.
double footprintVoxels(const RenderPlan& plan);

/// Texels per side at which the finest structure turns by one texel from ray to ray; no more than `largest`.
int atlasTexels(const RenderPlan& plan, int largest);

/// How samples choose among the mip levels of the plan's lit spheres, packed at `atlasSize` texels; nothing where all
/// of them would read the finest, because no ray is wider than a voxel, or where one level serves the whole picture:
/// the atlas's own. Where mip levels are kept in: only the latter. Asks for the plan's rays, volume and layers.
std::optional<PlanMipLevels> planMipLevels(const RenderPlan& plan, int atlasSize);

/// Where neither depth nor curvature varies the level.
bool oneLevelServesAll(const RenderPlan& plan);

/// Why a plan has none where the rule of leaving out (renderer/plan/leave_out.h) is not the reason.
const char* whyNoMipLevels(const RenderPlan& plan);

} // namespace limner
