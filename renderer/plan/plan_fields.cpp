#include "renderer/plan/plan_fields.h"

#include "core/base/error.h"
#include "core/optics/layers.h"
#include "core/volume/gradient_choice.h"
#include "renderer/plan/plan_importance.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>

namespace limner {

namespace {

[[noreturn]] void refuse(const std::string& where, const std::string& why, const std::string& remedy) {
    throw Error(ErrorKind::badInput, {"the figure cannot be drawn", where, why, remedy});
}

const std::shared_ptr<const Volume>& labelsOf(const RenderPlan& plan) {
    if (!plan.figure->labels || !plan.figure->labels->data) {
        refuse("/labels", "a layer or an object's importance reads labels and there are none",
               "give the figure a label volume");
    }
    return plan.figure->labels->data;
}

/// Whether composition or an axis weighs labelled objects.
bool readsObjects(const RenderPlan& plan) {
    return (plan.importance || plan.axisMeasures) && weighsObjects(*plan.figure->importance);
}

/// Every label that a layer names gets a slot of its own; 0 is for all others.
std::map<int, std::uint8_t> slotsOf(const RenderPlan& plan) {
    std::map<int, std::uint8_t> slots;
    const auto add = [&](int label) {
        if (label >= 0 && slots.size() < std::numeric_limits<std::uint8_t>::max()) {
            slots.emplace(label, static_cast<std::uint8_t>(slots.size() + 1));
        } else if (label >= 0 && slots.count(label) == 0) {
            refuse("/layers", "its layers name more than 255 labels", "name fewer of them");
        }
    };
    for (const PlanLayer& layer : plan.layers) {
        std::for_each(layer.table.labels.begin(), layer.table.labels.end(), add);
        if (layer.source->labels) {
            std::for_each(layer.source->labels->begin(), layer.source->labels->end(), add);
        }
    }
    if (readsObjects(plan)) {
        for (const ObjectImportance& object : plan.figure->importance->objects) {
            add(object.label);
        }
    }
    return slots;
}

/// From a point to the farthest corner of the grid.
double greatestDistanceMm(const Grid& grid, const glm::dvec3& fromMm) {
    double greatest = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 voxel = glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2) * glm::dvec3(grid.dims) - 0.5;
        greatest = std::max(greatest, glm::distance(grid.mmFromVoxel(voxel), fromMm));
    }
    return greatest;
}

bool namesAxis(const Transfer& transfer, TransferAxis axis) {
    return firstAxis(transfer) == axis || secondAxis(transfer) == axis;
}

std::vector<std::uint8_t> shownSlots(const Layer& layer, const std::map<int, std::uint8_t>& slots) {
    std::vector<std::uint8_t> shown(std::numeric_limits<std::uint8_t>::max() + 1, 0);
    for (const int label : *layer.labels) {
        if (const auto slot = slots.find(label); slot != slots.end()) { // no voxel has a label below 0
            shown[slot->second] = 1;
        }
    }
    return shown;
}

std::vector<float> weightOfSlot(const Importance& importance, const std::map<int, std::uint8_t>& slots) {
    std::vector<float> weights(std::numeric_limits<std::uint8_t>::max() + 1, 0.0F);
    for (const ObjectImportance& object : importance.objects) {
        if (const auto slot = slots.find(object.label); slot != slots.end()) {
            weights[slot->second] = static_cast<float>(object.weight);
        }
    }
    return weights;
}

std::vector<std::int16_t> rowOfSlot(const TransferTable& table, const std::map<int, std::uint8_t>& slots) {
    const auto others = std::find(table.labels.begin(), table.labels.end(), -1);
    const auto otherRow = static_cast<std::int16_t>(others == table.labels.end() ? -1 : others - table.labels.begin());
    std::vector<std::int16_t> rows(std::numeric_limits<std::uint8_t>::max() + 1, otherRow);
    for (std::size_t row = 0; row < table.labels.size(); ++row) {
        if (table.labels[row] >= 0) {
            rows[slots.at(table.labels[row])] = static_cast<std::int16_t>(row);
        }
    }
    return rows;
}

double largestSpacing(const Grid& grid) { return std::max({grid.spacingMm.x, grid.spacingMm.y, grid.spacingMm.z}); }

/// What thick slices are blurred by, in their plane, before Sobel's estimator, which itself blurs by a variance of half
/// a voxel along each axis: edges are then as wide along the slices as across them, in mm, and no steps show. At most
/// two voxels, so that very thick slices do not cost all that their pixels resolve.
glm::dvec3 sliceSigmaVoxels(const Grid& grid) {
    constexpr double kMost = 2;
    const glm::dvec3 ratio = largestSpacing(grid) / grid.spacingMm;
    return glm::min(glm::sqrt(0.5 * (ratio * ratio - 1.0)), glm::dvec3(kMost));
}

/// Second derivatives of a scan as it is are noise, and even those of a clean edge two voxels wide are off by nearly
/// half of what they are (on a ball of 20 voxels' radius); over 1.5 voxels they are right to 2 %, and a ring of 8
/// voxels' radius loses less than 1 % of its own. In the plane of thick slices as far as these are thick.
glm::dvec3 bendSigmaVoxels(const Grid& grid) {
    return glm::max(largestSpacing(grid) / grid.spacingMm, glm::dvec3(1.5));
}

/// For depth of field: optics::kBlurLevels copies, each blurred twice as far as the one before, in int16.
std::vector<std::shared_ptr<const Volume>> blurredCopies(const Volume& volume, Task& task) {
    std::vector<std::shared_ptr<const Volume>> copies;
    const Grid& grid = volume.grid();
    for (int level = 0; level < optics::kBlurLevels; ++level) {
        const double sigmaMm = std::exp2(level) * grid.smallestSpacingMm();
        auto copy = gaussianBlurred(volume, sigmaMm / grid.spacingMm, task);
        copies.push_back(copy->type() == VoxelType::int16 ? copy : resampledValues(*copy, grid, task));
    }
    return copies;
}

} // namespace

void PlanFields::chooseEstimators(RenderPlan& plan, Task& task) {
    const Quality& quality = plan.figure->quality;
    plan.interpolation = quality.interpolation;
    if (plan.interpolation == Interpolation::automatic) {
        plan.interpolation = hasThickSlices(plan.volume->grid()) ? Interpolation::smooth : Interpolation::linear;
    }
    const auto splines = [&]() -> const VolumePointer& {
        return splines_.get(plan.volume, [&] { return splineCoefficients(*plan.volume, task); });
    };
    plan.field = plan.interpolation == Interpolation::tricubic ? splines() : plan.volume;
    plan.gradient = quality.gradient;
    if (plan.gradient == GradientEstimator::automatic && hasThickSlices(plan.volume->grid())) {
        plan.gradient = GradientEstimator::sobel;
        plan.gradientField = slices_.get(
            plan.volume, [&] { return gaussianBlurred(*plan.volume, sliceSigmaVoxels(plan.volume->grid()), task); });
        return;
    }
    if (plan.gradient == GradientEstimator::automatic) {
        // Between voxels that a spline joins, its own derivative is the field's.
        plan.gradient =
            plan.interpolation != Interpolation::linear ? GradientEstimator::bspline : automatic_.get(plan.volume, [&] {
                return characterOf(*plan.volume) == DataCharacter::clean ? GradientEstimator::bspline
                                                                         : GradientEstimator::sobel;
            });
    }
    const bool ownCoefficients =
        plan.gradient == GradientEstimator::bspline && plan.interpolation == Interpolation::linear;
    plan.gradientField = ownCoefficients ? splines() : plan.field;
}

AxisRanges PlanFields::axisRanges(const RenderPlan& plan, const Layer& layer, Task& task) {
    AxisRanges ranges;
    if (plan.figure->secondVolume && plan.figure->secondVolume->data) {
        ranges.second = plan.figure->secondVolume->data->range();
    }
    if (layer.opacity > 0 && namesAxis(layer.transfer, TransferAxis::distance)) {
        // No farther than anything is: a table's entries are few.
        const auto& origin = layer.transfer.distance;
        ranges.distance = {0, origin && origin->fromMm ? greatestDistanceMm(plan.volume->grid(), *origin->fromMm)
                                                       : distanceMap(plan, layer, task)->range().high};
    }
    if (plan.figure->importance) {
        ranges.importance = {0, greatestOfPlace(*plan.figure->importance)};
    }
    // A ball of two voxels' radius is the smallest whose curvature voxels can hold.
    ranges.curvature = {0, 0.5 / plan.volume->grid().smallestSpacingMm()};
    return ranges;
}

void PlanFields::addFields(RenderPlan& plan, Task& task) {
    addLabels(plan, task);
    if (std::any_of(plan.layers.begin(), plan.layers.end(), readsSecondDerivatives)) {
        plan.bendField = bends_.get(
            plan.volume, [&] { return gaussianBlurred(*plan.volume, bendSigmaVoxels(plan.volume->grid()), task); });
    }
    if (std::any_of(plan.layers.begin(), plan.layers.end(),
                    [](const auto& layer) { return layer.focus.has_value(); })) {
        plan.blurs = blurs_.get(plan.volume, [&] { return blurredCopies(*plan.volume, task); });
    }
    for (PlanLayer& layer : plan.layers) {
        if (readsAxis(layer, TransferAxis::distance) && !layer.distanceFromMm) {
            layer.distance = distanceMap(plan, *layer.source, task);
        }
    }
    for (auto* measures : {&plan.importance, &plan.axisMeasures}) {
        if (*measures && (*measures)->source->weights.statistics > 0) {
            const double sigma = (*measures)->source->statisticsVoxels;
            (*measures)->statistics =
                statistics_.get({plan.volume, sigma}, [&] { return localContrast(*plan.volume, sigma, task); });
        }
    }
    const auto readsSecond = [](const PlanLayer& layer) { return readsAxis(layer, TransferAxis::second); };
    if (std::any_of(plan.layers.begin(), plan.layers.end(), readsSecond)) {
        if (!plan.figure->secondVolume || !plan.figure->secondVolume->data) {
            refuse("/second_volume", "a layer reads a second volume and there is none", "give the figure one");
        }
        const VolumePointer& second = plan.figure->secondVolume->data;
        plan.secondVolume =
            second_.get({second, plan.volume}, [&] { return resampledValues(*second, plan.volume->grid(), task); });
    }
}

void PlanFields::addLabels(RenderPlan& plan, Task& task) {
    const auto reads = [](const PlanLayer& layer) {
        return layer.source->labels.has_value() || readsAxis(layer, TransferAxis::label);
    };
    const bool objects = readsObjects(plan);
    if (std::none_of(plan.layers.begin(), plan.layers.end(), reads) && !objects) {
        return;
    }
    const VolumePointer& labels = labelsOf(plan);
    const std::map<int, std::uint8_t> slots = slotsOf(plan);
    plan.labels =
        slots_.get({labels, plan.volume, slots}, [&] { return labelSlots(*labels, plan.volume->grid(), slots, task); });
    for (auto* measures : {&plan.importance, &plan.axisMeasures}) {
        if (objects && *measures) {
            (*measures)->weightOfSlot = weightOfSlot(*(*measures)->source, slots);
        }
    }
    for (PlanLayer& layer : plan.layers) {
        if (layer.source->labels) {
            layer.shownSlots = shownSlots(*layer.source, slots);
        }
        if (readsAxis(layer, TransferAxis::label)) {
            layer.rowOfSlot = rowOfSlot(layer.table, slots);
        }
    }
}

const PlanFields::VolumePointer& PlanFields::distanceMap(const RenderPlan& plan, const Layer& layer, Task& task) {
    const VolumePointer& labels = labelsOf(plan);
    const int label = layer.transfer.distance ? layer.transfer.distance->label : 0;
    return distances_.get({labels, plan.volume, label}, [&] {
        // On the scan's grid first: beyond the label volume there is no label, not distance 0.
        const auto onGrid = labelSlots(*labels, plan.volume->grid(), {{label, std::uint8_t{1}}}, task);
        const auto distance = distanceToLabel(*onGrid, 1, task);
        if (!distance) {
            refuse("/labels", "no voxel has the label " + std::to_string(label), "measure the distance from another");
        }
        return distance;
    });
}

} // namespace limner
