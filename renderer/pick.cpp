#include "renderer/pick.h"

#include "core/optics/opacity.h"
#include "renderer/reference/field.h"
#include "renderer/reference/layer_optics.h"

namespace limner {

std::optional<Pick> pickMatter(const RenderPlan& plan, const glm::dvec2& positionPixel) {
    constexpr double kHalf = 0.5;
    const auto ray = reference::rayThrough(plan, positionPixel);
    if (!ray) {
        return std::nullopt;
    }
    double opacity = 0;
    const reference::SampleSpan span = reference::samplesOf(*ray, plan.lattice);
    for (long k = span.first; k < span.end; ++k) {
        const reference::Segment segment = reference::segmentOf(*ray, plan.lattice, k);
        if (!(segment.lengthMm > 0)) {
            continue;
        }
        const glm::dvec3 position = ray->positionVoxel(segment.positionMm);
        const double value = reference::valueAt(plan, position);
        const reference::SampleFacts facts = reference::sampleFacts(plan, *ray, segment, value);
        for (const PlanLayer& layer : plan.layers) {
            const reference::LayerSample sample = reference::shadeLayer(plan, layer, facts);
            opacity += (1 - opacity) * optics::opacityOfLength(sample.opacity, sample.lengthRatio);
        }
        if (opacity >= kHalf) {
            return Pick{plan.volume->grid().mmFromVoxel(position), value};
        }
    }
    return std::nullopt;
}

} // namespace limner
