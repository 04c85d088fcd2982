#include "renderer/plan/plan_importance.h"

#include "renderer/plan/depth_cues.h"

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
    if (!figures || !weighsAnything(*figures)) {
        return std::nullopt;
    }
    PlanImportance importance;
    importance.source = &*figures;
    const glm::dvec3 light = figures->lighting.direction;
    importance.lightEye = glm::length(light) > 0 ? glm::normalize(light) : glm::dvec3(0, 0, 1);
    importance.intensity = plan.volume->range();
    for (const Lens& lens : figures->lenses) {
        importance.lenses.push_back(placeLens(lens, plan));
    }
    return importance;
}

double globalWeightAt(const RenderPlan& plan, glm::dvec2 place) {
    return plan.importance ? plan.importance->source->global *
                                 lensFactor(plan.importance->lenses, place / static_cast<double>(plan.size.y))
                           : 0;
}

bool readsNormal(const RenderPlan& plan) {
    return std::any_of(plan.layers.begin(), plan.layers.end(), [](const auto& layer) { return readsNormal(layer); }) ||
           (plan.importance && readsNormal(*plan.importance->source)) || readNormals(plan.figure->depthCues);
}

bool readsGradientScale(const RenderPlan& plan) {
    // Normals that are mixed with others go by how far they are trusted.
    const auto mixes = [](const PlanLayer& layer) { return (layer.cut && layer.cut->faces) || layer.focus; };
    const bool mixed = plan.faces || std::any_of(plan.layers.begin(), plan.layers.end(), mixes);
    return (mixed && readsNormal(plan)) ||
           std::any_of(plan.layers.begin(), plan.layers.end(),
                       [](const auto& layer) { return readsGradientScale(layer); }) ||
           (plan.importance && readsNormal(*plan.importance->source)) || readNormals(plan.figure->depthCues);
}

} // namespace limner
