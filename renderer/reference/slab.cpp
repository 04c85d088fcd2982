#include "renderer/reference/slab.h"

#include "core/optics/opacity.h"
#include "core/optics/preintegration.h"
#include "renderer/reference/field.h"
#include "renderer/reference/gauss.h"

#include <algorithm>
#include <cmath>

namespace limner::reference {

namespace {

/// Where extinction or its slope may jump, as places 0 to 1 between two values; with both ends.
std::vector<double> cutsBetween(const PlanLayer& layer, double front, double back) {
    std::vector<double> cuts{0, 1};
    for (const glm::dvec2& point : layer.source->transfer.opacity) {
        const double at = (point.x - front) / (back - front);
        if (at > 0 && at < 1) { // nowhere between equal values
            cuts.push_back(at);
        }
    }
    std::sort(cuts.begin(), cuts.end());
    return cuts;
}

struct Matter {
    double extinction = 0; ///< mean over the slab, optical depth of the reference length
    optics::SlabMoments<double> moments{};
};

Matter matterBetween(const PlanLayer& layer, double front, double back) {
    const std::vector<double> cuts = cutsBetween(layer, front, back);
    const GaussRule& rule = gaussRule();
    optics::SlabIntegrals<double> sum{0, 0, 0};
    for (std::size_t i = 1; i < cuts.size(); ++i) {
        const double width = cuts[i] - cuts[i - 1];
        for (std::size_t j = 0; j < rule.point.size(); ++j) {
            const double u = cuts[i - 1] + width * rule.point[j];
            const double depth =
                rule.weight[j] * width * optics::extinctionOfOpacity(opacityOf(layer, front + u * (back - front)));
            sum = {sum.depth + depth, sum.first + u * depth, sum.second + u * u * depth};
        }
    }
    // Places are the slab's own: its ends are 0 and 1.
    return {sum.depth, optics::momentsBetween(0.0, 1.0, sum)};
}

/// From its front, where the lattice's phase would put the sample's place, to its back.
Segment stretchOf(const RenderPlan& plan, const Ray& ray, long k) {
    SampleLattice fronts = plan.lattice;
    fronts.phase = 0;
    return segmentOf(ray, fronts, k);
}

} // namespace

std::vector<SlabPart> slabAt(const RenderPlan& plan, const Ray& ray, long k) {
    const Segment slab = stretchOf(plan, ray, k);
    std::vector<SlabPart> parts;
    if (!(slab.lengthMm > 0)) {
        return parts;
    }
    const double front = valueAt(plan, ray.positionVoxel(slab.positionMm));
    const double back = valueAt(plan, ray.positionVoxel(slab.positionMm + slab.lengthMm));
    for (const PlanLayer& layer : plan.layers) {
        const Matter matter = matterBetween(layer, front, back);
        const double depth = matter.extinction * slab.lengthMm / plan.referenceLengthMm;
        if (!(depth > 0)) {
            continue;
        }
        const double seen = optics::seenPlace(matter.moments, depth);
        SlabPart part;
        part.layer = &layer;
        part.opacity = optics::opacityOfDepth(depth);
        part.value = front + seen * (back - front);
        const Segment there{slab.positionMm + seen * slab.lengthMm, slab.lengthMm};
        const SampleFacts facts = sampleFacts(plan, ray, there, part.value);
        part.positionVoxel = facts.positionVoxel;
        part.colour = shadeLayer(plan, layer, facts).colour;
        parts.push_back(part);
    }
    return parts;
}

} // namespace limner::reference
