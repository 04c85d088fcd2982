#include "renderer/plan/lenses.h"

#include "core/optics/blue_noise.h"
#include "core/optics/measures.h"
#include "renderer/plan/render_plan.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace limner {

namespace {

/// How much of a lens there is at a distance, in its radii: 0..1.
double shareOf(const Lens& lens, double distance, glm::dvec2 point) {
    if (lens.kind == "circular") {
        return lens.soft > 0 ? 1 - optics::smoothStep<double>(1 - lens.soft, 1, distance)
                             : optics::circularLens<double>(1, distance, 1);
    }
    const double soft = optics::gaussianLens<double>(1, distance, 1);
    if (lens.kind == "gaussian") {
        return soft;
    }
    const auto grain = [&](double at) { return static_cast<int>(std::floor(std::clamp(at / lens.cell, -1e9, 1e9))); };
    return soft > blueNoise().threshold(grain(point.x), grain(point.y)) ? 1 : 0;
}

/// Beyond this many radii a lens is at most e^-18 of itself: nothing.
double reach(const Lens& lens) { return lens.kind == "circular" ? 1 : 3; }

} // namespace

PlanLens placeLens(const Lens& lens, const RenderPlan& plan) {
    const glm::dvec2 size(plan.size);
    if (!lens.anchorMm) {
        return {lens, {lens.center.x * size.x / size.y, lens.center.y}, true};
    }
    const glm::dvec3 voxel = plan.volume->grid().voxelFromMm(*lens.anchorMm);
    const glm::dmat3 across(plan.rays.rightVoxel, plan.rays.downVoxel, plan.rays.forwardVoxel);
    glm::dvec3 at = glm::inverse(across) * (voxel - plan.rays.originVoxel); // pixels right and down, and along
    if (plan.rays.perspective) {
        at /= at.z > 0 ? at.z : 1;
    }
    return {lens, glm::dvec2(at) / size.y, !plan.rays.perspective || at.z > 0};
}

double lensDistance(const Lens& lens, glm::dvec2 offset) {
    if (lens.shape == "circle") {
        return glm::length(offset) / lens.radius;
    }
    const double turn = glm::radians(lens.angleDeg);
    const glm::dvec2 own(offset.x * std::cos(turn) - offset.y * std::sin(turn),
                         offset.x * std::sin(turn) + offset.y * std::cos(turn));
    const glm::dvec2 p = glm::abs(own) / glm::dvec2(lens.radius * lens.aspect, lens.radius);
    if (lens.shape == "ellipse") {
        return glm::length(p);
    }
    const double most = std::max(p.x, p.y);
    const double least = most > 0 ? std::min(p.x, p.y) / most : 0;
    return most * std::sqrt(std::sqrt(1 + least * least * least * least));
}

double lensFactor(std::span<const PlanLens> lenses, glm::dvec2 point) {
    if (lenses.empty()) {
        return 1;
    }
    double greatest = 0;
    for (const PlanLens& placed : lenses) {
        const Lens& lens = placed.lens;
        const double distance = lensDistance(lens, point - placed.centre);
        const double share = placed.seen && distance < reach(lens) ? shareOf(lens, distance, point) : 0;
        greatest = std::max(greatest, lens.outside + (lens.inside - lens.outside) * share);
    }
    return greatest;
}

bool lensesMiss(std::span<const PlanLens> lenses, glm::dvec2 low, glm::dvec2 high) {
    return !lenses.empty() && std::none_of(lenses.begin(), lenses.end(), [&](const PlanLens& placed) {
        const Lens& lens = placed.lens;
        const double farthest = reach(lens) * lens.radius * std::max(1.0, lens.aspect) * std::sqrt(2.0);
        const glm::dvec2 nearest = glm::clamp(placed.centre, low, high);
        return lens.outside > 0 || (placed.seen && glm::distance(nearest, placed.centre) <= farthest);
    });
}

} // namespace limner
