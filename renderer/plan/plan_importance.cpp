#include "renderer/plan/plan_importance.h"

#include "core/base/error.h"
#include "renderer/plan/depth_cues.h"
#include "renderer/plan/importance_bricks.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace limner {

namespace {

bool weighsAnything(const Importance& importance) {
    const ImportanceWeights& w = importance.weights;
    const bool measured = w.intensity > 0 || w.extinction > 0 || readsNormal(importance) || w.unocclusion > 0 ||
                          weighsObjects(importance) || w.statistics > 0;
    return importance.global > 0 && ((measured && importance.cap > 0) || importance.background > 0);
}

/// Outlines darken whatever matters.
bool darkens(const Importance& importance) {
    return importance.weights.silhouette > 0 && importance.silhouette.darkening > 0;
}

bool anyWeighs(const std::vector<PlanLayer>& layers) {
    return std::any_of(layers.begin(), layers.end(),
                       [](const PlanLayer& layer) { return layer.source->importanceWeight > 0; });
}

bool weighsNoLayer(const std::vector<PlanLayer>& layers, const Importance& importance) {
    return !anyWeighs(layers) && !(importance.background > 0) && !darkens(importance);
}

PlanImportance measuresOf(const RenderPlan& plan, const Importance& figures) {
    PlanImportance importance;
    importance.source = &figures;
    const glm::dvec3 light = figures.lighting.direction;
    importance.lightEye = glm::length(light) > 0 ? glm::normalize(light) : glm::dvec3(0, 0, 1);
    importance.intensity = plan.volume->range();
    return importance;
}

} // namespace

bool readsNormal(const Importance& importance) {
    const ImportanceWeights& w = importance.weights;
    return w.gradient > 0 || w.silhouette > 0 || w.lighting > 0;
}

bool weighsObjects(const Importance& importance) {
    return importance.weights.object > 0 && std::any_of(importance.objects.begin(), importance.objects.end(),
                                                        [](const auto& o) { return o.weight > 0; });
}

std::optional<PlanImportance> planImportance(const RenderPlan& plan) {
    const auto& figures = plan.figure->importance;
    const bool kept = plan.kept.has(LeaveOut::importance);
    if (!figures || (!kept && (!weighsAnything(*figures) || weighsNoLayer(plan.layers, *figures)))) {
        return std::nullopt;
    }
    PlanImportance importance = measuresOf(plan, *figures);
    for (const Lens& lens : figures->lenses) {
        importance.lenses.push_back(placeLens(lens, plan));
    }
    return importance;
}

bool mattersNowhere(const PlanImportance& importance, const std::vector<PlanLayer>& layers) {
    const Importance& figures = *importance.source;
    if (figures.background > 0 || darkens(figures) || (figures.weights.unocclusion > 0 && anyWeighs(layers))) {
        return false;
    }
    const std::vector<float>& bounds = importance.bricks->greatest;
    return std::none_of(bounds.begin(), bounds.end(), [](float greatest) { return greatest > 0; });
}

bool settlesImportance(const RenderPlan& plan) {
    return plan.importance && !(plan.importance->source->weights.unocclusion > 0);
}

double greatestOfPlace(const Importance& importance) {
    const ImportanceWeights& w = importance.weights;
    double object = 0;
    for (const ObjectImportance& o : importance.objects) {
        object = std::max(object, o.weight);
    }
    constexpr double kLighting = 3; // core/optics/measures.h
    return w.intensity + w.gradient + w.silhouette + kLighting * w.lighting + w.object * object + w.statistics;
}

std::optional<PlanImportance> planAxisMeasures(const RenderPlan& plan) {
    const auto reads = [](const PlanLayer& layer) { return readsAxis(layer, TransferAxis::importance); };
    if (std::none_of(plan.layers.begin(), plan.layers.end(), reads)) {
        return std::nullopt;
    }
    if (!plan.figure->importance) {
        throw Error(ErrorKind::badInput, {"the figure cannot be drawn", "/importance",
                                          "an axis of a layer is importance and the figure weighs nothing",
                                          "weigh some measures, or take another axis"});
    }
    return measuresOf(plan, *plan.figure->importance);
}

double globalWeightAt(const RenderPlan& plan, glm::dvec2 place) {
    return plan.importance ? plan.importance->source->global *
                                 lensFactor(plan.importance->lenses, place / static_cast<double>(plan.size.y))
                           : 0;
}

namespace {

bool measuresReadNormal(const RenderPlan& plan) {
    return (plan.importance && readsNormal(*plan.importance->source)) ||
           (plan.axisMeasures && readsNormal(*plan.axisMeasures->source));
}

} // namespace

bool readsNormal(const RenderPlan& plan) {
    return plan.kept.has(LeaveOut::normals) ||
           std::any_of(plan.layers.begin(), plan.layers.end(), [](const auto& layer) { return readsNormal(layer); }) ||
           measuresReadNormal(plan) || readNormals(plan.figure->depthCues);
}

bool readsGradientScale(const RenderPlan& plan) {
    // Normals that are mixed with others go by how far they are trusted.
    const auto mixes = [](const PlanLayer& layer) { return (layer.cut && layer.cut->faces) || layer.focus; };
    const bool mixed = plan.faces || std::any_of(plan.layers.begin(), plan.layers.end(), mixes);
    return plan.kept.has(LeaveOut::normals) || (mixed && readsNormal(plan)) ||
           std::any_of(plan.layers.begin(), plan.layers.end(),
                       [](const auto& layer) { return readsGradientScale(layer); }) ||
           measuresReadNormal(plan) || readNormals(plan.figure->depthCues);
}

} // namespace limner
