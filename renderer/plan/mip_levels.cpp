#include "renderer/plan/mip_levels.h"

#include "core/optics/mip.h"
#include "renderer/plan/plan_layer.h"

#include <algorithm>

namespace limner {

namespace {

/// Depth of the farthest corner of the volume's box over the target's.
double farthestDepth(const RenderPlan& plan) {
    if (!plan.rays.perspective) {
        return 1;
    }
    const glm::dmat3 eyeFromVoxel = plan.rays.eyeFromMm * plan.rays.mmFromVoxel;
    const double toPlane = (eyeFromVoxel * plan.rays.forwardVoxel).z;
    double farthest = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 high(corner & 1, corner >> 1 & 1, corner >> 2);
        const glm::dvec3 at = glm::dvec3(high * plan.volume->grid().dims) - 0.5;
        farthest = std::max(farthest, (eyeFromVoxel * (at - plan.rays.originVoxel)).z / toPlane);
    }
    return farthest;
}

} // namespace

bool oneLevelServesAll(const RenderPlan& plan) {
    return !plan.rays.perspective && std::none_of(plan.layers.begin(), plan.layers.end(), [](const PlanLayer& layer) {
        return drawsSpheres(layer) && bendsLevels(layer);
    });
}

double footprintVoxels(const RenderPlan& plan) {
    return plan.rays.footprintMm / plan.subPixels / plan.volume->grid().smallestSpacingMm();
}

int atlasTexels(const RenderPlan& plan, int largest) {
    // Twice as fine costs a style up to 60 % more time: several spheres then no longer fit the second-level cache.
    const double texels = 2 * optics::kStructureVoxels / std::max(footprintVoxels(plan), 1e-6);
    return static_cast<int>(std::min<double>(largest, texels));
}

std::optional<PlanMipLevels> planMipLevels(const RenderPlan& plan, int atlasSize) {
    const double footprint = footprintVoxels(plan);
    if (oneLevelServesAll(plan) || (!plan.kept.has(LeaveOut::mipLevels) && footprint * farthestDepth(plan) <= 1)) {
        return std::nullopt;
    }
    PlanMipLevels levels;
    levels.voxelMm = plan.volume->grid().smallestSpacingMm();
    levels.footprintVoxels = footprint;
    // The atlas is up to twice as fine as it need be: only then is its finest picture right in the target plane.
    levels.radiusTexels =
        std::clamp(optics::kStructureVoxels / footprint, 0.5 * StyleAtlas::kSmallest, 0.5 * atlasSize);
    return levels;
}

const char* whyNoMipLevels(const RenderPlan& plan) {
    return plan.atlas ? "one level serves the whole picture" : "no layer is drawn in styles";
}

} // namespace limner
