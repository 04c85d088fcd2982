#include "renderer/reference/ray.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace limner::reference {

namespace {

/// Below this a direction's component is rounding noise of a parallel ray: a division would give 0 * infinity.
constexpr double kParallel = 1e-20;

/// Keeps the part of a stretch where `at0 + slope * t <= limit`.
void keepBelow(Stretch& stretch, double at0, double slope, double limit) {
    if (std::abs(slope) < kParallel) {
        if (at0 > limit) {
            stretch.outMm = -std::numeric_limits<double>::infinity();
        }
    } else if (slope > 0) {
        stretch.outMm = std::min(stretch.outMm, (limit - at0) / slope);
    } else {
        stretch.inMm = std::max(stretch.inMm, (limit - at0) / slope);
    }
}

void keepInside(Stretch& stretch, const glm::dvec3& origin, const glm::dvec3& direction, const BoxMm& box) {
    for (int axis = 0; axis < 3; ++axis) {
        keepBelow(stretch, origin[axis], direction[axis], box.high[axis]);
        keepBelow(stretch, -origin[axis], -direction[axis], -box.low[axis]);
    }
}

} // namespace

std::optional<Ray> rayThrough(const RenderPlan& plan, const glm::dvec2& positionPixel) {
    const RayFrame& frame = plan.rays;
    const glm::dvec3 offset = positionPixel.x * frame.rightVoxel + positionPixel.y * frame.downVoxel;
    Ray ray;
    ray.originVoxel = frame.perspective ? frame.originVoxel : frame.originVoxel + offset;
    const glm::dvec3 along = frame.perspective ? frame.forwardVoxel + offset : frame.forwardVoxel;
    ray.directionVoxel = along / glm::length(frame.mmFromVoxel * along);
    const glm::dvec3 directionMm = frame.mmFromVoxel * ray.directionVoxel;
    ray.directionEye = glm::normalize(frame.eyeFromMm * directionMm);

    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Grid& grid = plan.volume->grid();
    ray.box = {frame.perspective ? 0 : -infinity, infinity};
    const double face = 0.5 - plan.lattice.boxInset;
    keepInside(ray.box, ray.originVoxel, ray.directionVoxel, {glm::dvec3(-face), glm::dvec3(grid.dims - 1) + face});
    ray.visible = ray.box;
    const glm::dvec3 originMm = grid.mmFromVoxel(ray.originVoxel);
    if (plan.clip.boxMm) {
        keepInside(ray.visible, originMm, directionMm, *plan.clip.boxMm);
    }
    for (const ClipPlane& plane : plan.clip.planes) {
        keepBelow(ray.visible, glm::dot(plane.normal, originMm), glm::dot(plane.normal, directionMm), plane.offsetMm);
    }
    if (!(ray.visible.lengthMm() > 0)) {
        return std::nullopt;
    }
    return ray;
}

SampleSpan samplesOf(const Ray& ray, const SampleLattice& lattice) {
    // One more at either end than rounding could need: samples outside the visible stretch have no length.
    const auto index = [&](double mm) { return (mm - ray.box.inMm) / lattice.stepMm; };
    return {std::max(0L, static_cast<long>(std::floor(index(ray.visible.inMm))) - 1),
            static_cast<long>(std::ceil(index(ray.visible.outMm))) + 1};
}

Segment segmentOf(const Ray& ray, const SampleLattice& lattice, long k) {
    const auto at = [&](double index) { return ray.box.inMm + index * lattice.stepMm; };
    const double in = std::max(at(static_cast<double>(k)), ray.visible.inMm);
    const double out = std::min(at(static_cast<double>(k) + 1), ray.visible.outMm);
    // A stretch this short is a rounding residue of the box's exit, not matter.
    constexpr double residue = 1e-9;
    if (!(out - in > residue * lattice.stepMm)) {
        return {};
    }
    return {in + (out - in) * lattice.phase, out - in};
}

} // namespace limner::reference
