#include "renderer/plan/picture_warnings.h"

#include "core/base/machine.h"
#include "core/figure/quantity.h"

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace limner {
namespace {

constexpr double kStepShare = 8;      // a ramp this many times narrower than a step's change is jumped over: rings show
constexpr double kCoarserLabels = 2;  // their edges are rounder than the scan's
constexpr double kFlattest = 4;       // longest to shortest side of a voxel: beyond it slices show as terraces
constexpr double kMemoryShare = 0.75; // more makes the machine swap

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

/// Width of the narrowest part of a curve over which opacity rises or falls by a tenth and more; infinite: none.
double narrowestRamp(const std::vector<glm::dvec2>& points) {
    constexpr double kMatters = 0.1;
    double narrowest = INFINITY;
    for (std::size_t i = 1; i < points.size(); ++i)
        if (std::abs(points[i].y - points[i - 1].y) >= kMatters)
            narrowest = std::min(narrowest, points[i].x - points[i - 1].x);
    return narrowest;
}

void warnOfSteepness(const RenderPlan& plan, std::vector<std::string>& warnings) {
    const Figure& figure = *plan.figure;
    const double stepMm = figure.quality.stepVoxels * plan.volume->grid().smallestSpacingMm();
    const double perStep = steepestChange(*plan.volume) * stepMm;
    const std::string& unit = plan.volume->contents().unit;
    for (const Layer& layer : figure.layers) {
        if (!figure.draws(layer) || layer.transfer.kind != TransferKind::oneDimensional ||
            layer.transfer.axis != "value")
            continue;
        const double ramp = narrowestRamp(layer.transfer.opacity);
        if (ramp * kStepShare < perStep)
            warnings.push_back(
                "layer \"" + layer.name + "\": its opacity jumps within " + number(ramp) +
                (unit.empty() ? "" : " " + unit) + ", while the scan changes by up to " + number(perStep) +
                " between two samples; thin rings may show: widen the slope, or take " + "smaller steps");
    }
}

void warnOfGrids(const RenderPlan& plan, std::vector<std::string>& warnings) {
    const Grid& grid = plan.volume->grid();
    const glm::dvec3& spacing = grid.spacingMm;
    const double longest = std::max({spacing.x, spacing.y, spacing.z});
    if (longest > kFlattest * grid.smallestSpacingMm())
        warnings.push_back("the scan's slices are " + number(longest) + " mm apart, its pixels " +
                           number(grid.smallestSpacingMm()) +
                           " mm: what lies between slices is made up by interpolation");
    if (glm::determinant(grid.direction) < 0)
        warnings.push_back("the scan's file counts its voxels in a mirrored order; it is drawn the right way round");
    const auto& labels = plan.figure->labels;
    if (plan.labels && labels && labels->data &&
        labels->data->grid().smallestSpacingMm() > kCoarserLabels * grid.smallestSpacingMm())
        warnings.push_back("the labels' voxels are " + number(labels->data->grid().smallestSpacingMm()) +
                           " mm, the scan's " + number(grid.smallestSpacingMm()) +
                           " mm: edges of labels are rounded by as much");
}

void warnOfMemory(const RenderPlan& plan, std::vector<std::string>& warnings) {
    const std::uint64_t machine = machineMemory();
    const std::size_t held = plan.bytes + plan.volume->bytes();
    if (static_cast<double>(held) > kMemoryShare * static_cast<double>(machine))
        warnings.push_back("the figure holds " + formatBytes(held) + " of the machine's " + formatBytes(machine) +
                           ": keep its voxels in eight bits (precision), or crop the scan");
}

} // namespace

double steepestChange(const Volume& volume) {
    constexpr int kPerAxis = 28; // some 20,000 voxels: a thousandth of them is still twenty
    constexpr double kShare = 0.999;
    const Grid& grid = volume.grid();
    std::vector<double> changes;
    const glm::ivec3 step = glm::max(grid.dims / kPerAxis, glm::ivec3(1));
    for (int z = step.z / 2; z < grid.dims.z; z += step.z)
        for (int y = step.y / 2; y < grid.dims.y; y += step.y)
            for (int x = step.x / 2; x < grid.dims.x; x += step.x) {
                const glm::ivec3 voxel(x, y, z);
                double change = 0;
                for (int axis = 0; axis < 3; ++axis) {
                    glm::ivec3 next = voxel;
                    next[axis] += 1;
                    if (next[axis] < grid.dims[axis])
                        change = std::max(change, std::abs(volume.valueAt(next) - volume.valueAt(voxel)) /
                                                      grid.spacingMm[axis]);
                }
                if (change > 0) // air around the patient says nothing
                    changes.push_back(change);
            }
    if (changes.empty())
        return 0;
    const auto at = changes.begin() + static_cast<std::ptrdiff_t>(kShare * static_cast<double>(changes.size() - 1));
    std::nth_element(changes.begin(), at, changes.end());
    return *at;
}

std::vector<std::string> pictureWarnings(const RenderPlan& plan) {
    std::vector<std::string> warnings;
    if (!plan.volume)
        return warnings;
    warnOfSteepness(plan, warnings);
    warnOfGrids(plan, warnings);
    warnOfMemory(plan, warnings);
    return warnings;
}

} // namespace limner
