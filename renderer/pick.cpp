#include "renderer/pick.h"

#include "core/optics/opacity.h"
#include "renderer/reference/field.h"
#include "renderer/reference/layer_optics.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace limner {
namespace {

Pick pickAt(const RenderPlan& plan, const glm::dvec3& positionVoxel, double value) {
    const double gradient = glm::length(reference::eyeGradient(plan, positionVoxel));
    return {plan.volume->grid().mmFromVoxel(positionVoxel), value,
            plan.gradientMax > 0 ? std::min(1.0, gradient / plan.gradientMax) : 0};
}

/// How far along the ray a point lies, mm from the ray's origin.
double depthOf(const RenderPlan& plan, const reference::Ray& ray, const glm::dvec3& pointMm) {
    const glm::dvec3 originMm = plan.volume->grid().mmFromVoxel(ray.originVoxel);
    const glm::dvec3 alongMm = plan.rays.mmFromVoxel * ray.directionVoxel;
    return glm::dot(pointMm - originMm, alongMm);
}

double distanceTo(ValueRange range, double value) { return std::max({0.0, range.low - value, value - range.high}); }

/// Within reach of a depth, the place of the value nearest to the wanted ones.
std::optional<Pick> nearestValue(const RenderPlan& plan, const reference::Ray& ray, double depthMm,
                                 const PickTrail& trail) {
    const reference::SampleSpan span = reference::samplesOf(ray, plan.lattice);
    std::optional<glm::dvec3> best;
    double value = 0;
    double least = std::numeric_limits<double>::infinity();
    for (long k = span.first; k < span.end; ++k) {
        const reference::Segment segment = reference::segmentOf(ray, plan.lattice, k);
        if (!(segment.lengthMm > 0) || std::abs(segment.positionMm - depthMm) > trail.reachMm) {
            continue;
        }
        const glm::dvec3 position = ray.positionVoxel(segment.positionMm);
        const double here = reference::valueAt(plan, position);
        if (distanceTo(trail.wanted, here) < least) {
            least = distanceTo(trail.wanted, here);
            best = position;
            value = here;
        }
    }
    return best ? std::optional(pickAt(plan, *best, value)) : std::nullopt;
}

} // namespace

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
            return pickAt(plan, position, value);
        }
    }
    return std::nullopt;
}

std::optional<Pick> followMatter(const RenderPlan& plan, const glm::dvec2& positionPixel, PickTrail& trail) {
    const auto ray = reference::rayThrough(plan, positionPixel);
    if (!ray) {
        return std::nullopt;
    }
    std::optional<Pick> next = pickMatter(plan, positionPixel);
    if (trail.last) {
        const double depth = depthOf(plan, *ray, trail.last->pointMm);
        if (!next || std::abs(depthOf(plan, *ray, next->pointMm) - depth) > trail.reachMm) {
            next = nearestValue(plan, *ray, depth, trail);
        }
    }
    if (next) {
        trail.last = next;
    }
    return next;
}

} // namespace limner
