#include "renderer/plan/planner.h"

#include "core/base/error.h"
#include "core/volume/cleanup.h"
#include "core/volume/gradient_statistics.h"
#include "core/volume/widened.h"
#include "renderer/plan/depth_cues.h"
#include "renderer/plan/describe_plan.h"
#include "renderer/plan/eight_bits.h"
#include "renderer/plan/importance_bricks.h"
#include "renderer/plan/mip_levels.h"
#include "renderer/plan/plan_fields.h"
#include "renderer/plan/plan_importance.h"
#include "renderer/plan/plan_layer.h"
#include "renderer/plan/plan_marks.h"
#include "renderer/plan/plan_parts.h"
#include "renderer/plan/ray_frame.h"
#include "renderer/plan/slab_table.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace limner {

namespace {

constexpr double kCentralNoiseGain = 0.707; ///< of the gradients that GradientStatistics measures

[[noreturn]] void refuse(const std::string& where, const std::string& why, const std::string& remedy) {
    throw Error(ErrorKind::badInput, {"the figure cannot be drawn", where, why, remedy});
}

/// Opacity of one step from that of the reference length (spec style-transfer-functions.md 6).
std::vector<float> stepOpacity(const std::vector<float>& opacity, double ratio) {
    std::vector<float> corrected(opacity.size());
    std::transform(opacity.begin(), opacity.end(), corrected.begin(), [ratio](float a) {
        return a >= 1 ? 1.0F : static_cast<float>(-std::expm1(ratio * std::log1p(-static_cast<double>(a))));
    });
    return corrected;
}

/// Standard deviation of the gradient's components for unit white noise and unit spacing (spec accuracy.md 1.6).
double noiseGain(const RenderPlan& plan) {
    switch (plan.gradient) {
    case GradientEstimator::sobel: return plan.gradientField == plan.field ? 0.267 : 0.12; // blurred thick slices
    case GradientEstimator::neumann: return 0.236;
    case GradientEstimator::fourthOrder: return 0.950;
    case GradientEstimator::bspline: return plan.gradientField == plan.volume ? 0.354 : 1.18; // not prefiltered
    case GradientEstimator::automatic:
    case GradientEstimator::central: break;
    }
    return kCentralNoiseGain;
}

/// Reaches of a scan and its blurred copies together, in the scan's stored numbers: depth of field draws values between
/// them.
std::shared_ptr<const MinMaxGrid> withBlurs(const MinMaxGrid& scan, const RenderPlan& plan) {
    auto all = std::make_shared<MinMaxGrid>(scan);
    for (const auto& blur : plan.blurs) {
        const auto reach = computeMinMaxGrid(*blur);
        for (std::size_t i = 0; i < all->low.size(); ++i) {
            for (const float stored : {reach->low[i], reach->high[i]}) {
                const auto own = static_cast<float>(plan.field->storedFromValue(blur->valueFromStored(stored)));
                all->low[i] = std::min(all->low[i], own);
                all->high[i] = std::max(all->high[i], own);
            }
        }
    }
    return all;
}

/// See RenderPlan::gradientRounding: a dozen rounded operations on the largest number.
double gradientRounding(const Volume& field) {
    const ValueRange range = field.range();
    return 1e-6 * std::max(std::abs(field.storedFromValue(range.low)), std::abs(field.storedFromValue(range.high)));
}

/// Gradients that are no more than what single precision leaves of a place where everything is equal: a place between
/// voxels is off by some 1e-6 of a voxel, and a neighbour that is just out of reach gives that much of the data's
/// range.
double smallestGradient(const RenderPlan& plan) {
    constexpr double voxels = 2e-6;
    const ValueRange range = plan.volume->range();
    return voxels * (range.high - range.low) / plan.referenceLengthMm;
}

void checkDrawable(const Figure& figure) {
    if (!figure.volume || !figure.volume->data) {
        refuse("/volume", "there is no volume", "choose a scan or find the one that moved");
    }
    if (!(figure.quality.stepVoxels > 0)) {
        refuse("/quality/step_voxels", "the step must be above 0", "0.5 is a good step");
    }
}

} // namespace

struct Planner::Cache {
    using CleanKey =
        std::tuple<std::shared_ptr<const Volume>, std::shared_ptr<const Volume>, std::vector<CleanupStep>, double>;
    using VisibleKey = std::tuple<std::shared_ptr<const MinMaxGrid>, double, double, std::vector<std::uint8_t>>;
    using AtlasKey = std::tuple<std::vector<std::shared_ptr<const LitSphere>>, int, AtlasLevels>;
    /// Importance without what bounds do not depend on.
    using BricksKey = std::tuple<std::shared_ptr<const SkipGrid>, std::shared_ptr<const Volume>,
                                 std::shared_ptr<const Volume>, Importance, std::vector<Layer>>;
    using MinMaxKey = std::pair<std::shared_ptr<const Volume>, SampleReach>;
    RecentResults<CleanKey, std::shared_ptr<const Volume>> cleaned;
    RecentResults<std::shared_ptr<const Volume>, std::shared_ptr<const Volume>> widened;
    EightBits eightBits;
    RecentResults<MinMaxKey, std::shared_ptr<const MinMaxGrid>> minMax;
    RecentResults<std::pair<std::shared_ptr<const MinMaxGrid>, std::shared_ptr<const Volume>>,
                  std::shared_ptr<const MinMaxGrid>>
        minMaxWithBlurs;
    RecentResults<std::shared_ptr<const Volume>, GradientStatistics> gradients;
    RecentResults<VisibleKey, std::shared_ptr<const SkipGrid>> skip;
    RecentResults<BricksKey, std::shared_ptr<const ImportanceBricks>> bricks;
    RecentResults<AtlasKey, std::shared_ptr<const StyleAtlas>> atlas;
    PlanFields fields;
    DepthCueFields cues;
    MarkFields marks;
    std::vector<std::pair<glm::dvec3, std::shared_ptr<const LitSphere>>> plainSpheres;

    /// Plain colours among lit spheres are constant spheres; one and the same object per colour, so that the atlas is
    /// kept.
    std::shared_ptr<const LitSphere> plainSphere(const glm::dvec3& rgb) {
        for (const auto& [colour, sphere] : plainSpheres) {
            if (colour == rgb) {
                return sphere;
            }
        }
        constexpr int size = StyleAtlas::kSmallest;
        const glm::vec3 c(rgb);
        auto sphere = std::make_shared<const LitSphere>(size, std::vector<Rgba>(size * size, {c.r, c.g, c.b, 1}));
        plainSpheres.emplace_back(rgb, sphere);
        return sphere;
    }

    void packAtlas(RenderPlan& plan);
    void widenVoxels(RenderPlan& plan);
    void addSkipGrid(RenderPlan& plan);
    void boundImportance(RenderPlan& plan, const MinMaxGrid& lowHigh);
    void measureGradients(RenderPlan& plan);
};

void Planner::Cache::packAtlas(RenderPlan& plan) {
    std::vector<std::shared_ptr<const LitSphere>> spheres;
    int largest = 0;
    for (PlanLayer& layer : plan.layers) {
        if (!drawsSpheres(layer)) {
            continue;
        }
        for (const auto& entry : layer.styles.styles) {
            auto sphere = entry.sphere ? entry.sphere : plainSphere(entry.rgb);
            const auto known = std::find(spheres.begin(), spheres.end(), sphere);
            layer.atlasSlots.push_back(static_cast<int>(known - spheres.begin()));
            if (known == spheres.end()) {
                spheres.push_back(sphere);
            }
            largest = std::max(largest, sphere->size());
        }
    }
    if (spheres.empty()) {
        return;
    }
    const int size = atlasSize(atlasTexels(plan, largest));
    plan.mipLevels = planMipLevels(plan, size);
    const AtlasLevels levels = plan.mipLevels ? AtlasLevels::all : AtlasLevels::one;
    plan.atlas = atlas.get({spheres, size, levels}, [&] { return packStyles(spheres, size, levels); });
}

void Planner::Cache::addSkipGrid(RenderPlan& plan) {
    const SampleReach reach = plan.interpolation == Interpolation::linear ? SampleReach::cell : SampleReach::neighbours;
    auto lowHigh = minMax.get({plan.field, reach}, [&] { return computeMinMaxGrid(*plan.field, reach); });
    if (!plan.blurs.empty()) {
        lowHigh = minMaxWithBlurs.get({lowHigh, plan.blurs.front()}, [&] { return withBlurs(*lowHigh, plan); });
    }
    VisibleRange range = visibleRange(plan.layers, *plan.volume);
    // The field may keep its numbers otherwise than the volume.
    range.low = plan.field->storedFromValue(plan.volume->valueFromStored(range.low));
    range.high = plan.field->storedFromValue(plan.volume->valueFromStored(range.high));
    if (range.low > range.high) {
        std::swap(range.low, range.high);
        std::reverse(range.visible.begin(), range.visible.end());
    }
    const auto grid = [&]() -> const std::shared_ptr<const SkipGrid>& {
        return skip.get({lowHigh, range.low, range.high, range.visible},
                        [&] { return computeSkipGrid(*lowHigh, range); });
    };
    plan.skip = grid();
    if (plan.importance) {
        boundImportance(plan, *lowHigh);
    }
    if (plan.kept.has(LeaveOut::emptySpace)) {
        std::fill(range.visible.begin(), range.visible.end(), std::uint8_t{1});
        plan.skip = grid();
    }
}

void Planner::Cache::boundImportance(RenderPlan& plan, const MinMaxGrid& lowHigh) {
    Importance bounded = *plan.importance->source;
    bounded.global = 0;
    bounded.background = 0;
    bounded.lenses.clear();
    plan.importance->bricks =
        bricks.get({plan.skip, plan.labels, plan.importance->statistics, bounded, plan.figure->layers},
                   [&] { return computeImportanceBricks(plan, lowHigh); });
    if (!plan.kept.has(LeaveOut::importance) && mattersNowhere(*plan.importance, plan.layers)) {
        plan.importance.reset();
        const bool read = plan.axisMeasures || std::any_of(plan.layers.begin(), plan.layers.end(), readsLabels);
        plan.labels = read ? plan.labels : nullptr;
    }
}

/// Of what rays sample alone: fields that were made of the voxels stay as they are.
void Planner::Cache::widenVoxels(RenderPlan& plan) {
    if (!plan.kept.has(LeaveOut::wideVoxels) || !samplesEightBits(plan)) {
        return;
    }
    const auto wide = widened.get(plan.volume, [&] { return widenedToInt16(*plan.volume); });
    for (auto* sampled : {&plan.field, &plan.gradientField}) {
        *sampled = *sampled == plan.volume ? wide : *sampled;
    }
}

void Planner::Cache::measureGradients(RenderPlan& plan) {
    if (readsGradientScale(plan)) {
        const GradientStatistics statistics =
            gradients.get(plan.volume, [&] { return computeGradientStatistics(*plan.volume); });
        plan.gradientMax = statistics.p999 > 0 ? statistics.p999 : 1;
        plan.gradientFloor = std::max(statistics.noise * noiseGain(plan) / kCentralNoiseGain, smallestGradient(plan));
    }
}

Planner::Planner() : cache_(std::make_unique<Cache>()) {}
Planner::~Planner() = default;

std::shared_ptr<const RenderPlan> Planner::plan(const Figure& figure, const PlanRequest& request, Task& task) {
    const std::lock_guard lock(mutex_);
    checkDrawable(figure);
    auto plan = std::make_shared<RenderPlan>();
    plan->figure = std::make_shared<const Figure>(figure);
    plan->kept = request.omit ? request.kept : KeptIn::everything();
    plan->size = request.size.x > 0 ? request.size : figure.output.sizePixels();
    const double aspect = figure.output.aspect(); // not the picture's: a window's pixels must not move a cut
    const auto labels = figure.labels ? figure.labels->data : nullptr;
    plan->volume = cache_->cleaned.get({figure.volume->data, labels, figure.cleanup, aspect}, [&] {
        return applyCleanup(figure.volume->data, labels.get(), figure.cleanup, aspect, task);
    });
    const Quality& quality = figure.quality;
    plan->subPixels = request.subPixels > 0           ? request.subPixels
                      : quality.samplesPerPixel >= 16 ? 4
                      : quality.samplesPerPixel >= 4  ? 2
                                                      : 1;
    plan->referenceLengthMm = plan->volume->grid().smallestSpacingMm();
    plan->lattice = request.lattice.value_or(
        SampleLattice{quality.stepVoxels * request.stepScale * plan->referenceLengthMm, 0.5, 0});
    plan->earlyTermination = plan->kept.has(LeaveOut::restOfRay) ? 0 : quality.earlyTermination;
    plan->clip = figure.clip;
    cache_->fields.chooseEstimators(*plan, task);
    cache_->eightBits.apply(*plan, task);
    plan->rays = makeRayFrame(figure.camera, *plan->volume, plan->size);
    if (figure.clip.face && cutsAnything(figure.clip)) {
        plan->faces = planCut(figure.clip, figure, plan->rays);
    }
    plan->gradientRounding = gradientRounding(*plan->gradientField);
    addLayers(*plan, task);
    plan->importance = planImportance(*plan);
    plan->axisMeasures = planAxisMeasures(*plan);
    task.throwIfCancelled();
    cache_->fields.addFields(*plan, task);
    planSlabs(*plan);
    cache_->addSkipGrid(*plan);
    cache_->packAtlas(*plan);
    cache_->measureGradients(*plan);
    cache_->cues.add(*plan, request.stepScale > 1 ? CueDetail::draft : CueDetail::still, task);
    cache_->marks.add(*plan, request, task);
    cache_->widenVoxels(*plan);
    describePlan(*plan);
    return plan;
}

void Planner::addLayers(RenderPlan& plan, Task& task) {
    for (const Layer& layer : plan.figure->layers) {
        if (!plan.figure->draws(layer) || !needsLayers(*plan.figure)) {
            continue; // no part of the picture: to keep it in would draw it
        }
        const LayerSurroundings around{*plan.figure,
                                       *plan.volume,
                                       cache_->fields.axisRanges(plan, layer, task),
                                       plan.rays.footprintMm / plan.subPixels,
                                       plan.rays,
                                       plan.kept};
        PlanLayer planned = planLayer(layer, around);
        if (plan.kept.has(LeaveOut::layers) || showsAnything(layer, planned.table)) {
            planned.stepOpacity = stepOpacity(planned.table.opacity, plan.lattice.stepMm / plan.referenceLengthMm);
            plan.layers.push_back(std::move(planned));
        }
    }
}

} // namespace limner
