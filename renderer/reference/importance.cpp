#include "renderer/reference/importance.h"

#include "core/optics/measures.h"
#include "renderer/reference/field.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace limner::reference {

ImportanceRay::ImportanceRay(const RenderPlan& plan, double weight)
    : plan_(plan), settings_(*plan.importance->source), weight_(weight) {}

namespace {

double silhouettenessOf(const Importance& settings, const SampleFacts& facts) {
    const SilhouetteMeasure& terms = settings.silhouette;
    return optics::silhouetteness<double>(facts.surface.magnitude, std::abs(facts.surface.normalRay.z),
                                          {terms.exponent, terms.range.x, terms.range.y});
}

double lightingOf(const RenderPlan& plan, const PlanImportance& measures, const SampleFacts& facts) {
    const glm::dvec3 view = -facts.directionEye;
    const glm::dvec3 out = plan.rays.eyeFromMm * facts.surface.normalMm;
    const glm::dvec3 normal = glm::dot(out, view) < 0 ? -out : out; // two-sided
    const glm::dvec3& light = measures.lightEye;
    const auto half = optics::halfwayDirection<double>({light.x, light.y, light.z}, {view.x, view.y, view.z});
    const LightingMeasure& terms = measures.source->lighting;
    return optics::lightingImportance<double>(
        glm::dot(normal, glm::dvec3(half.x, half.y, half.z)), glm::dot(normal, light), facts.surface.magnitude,
        {static_cast<unsigned>(terms.highlight), static_cast<unsigned>(terms.diffuse),
         static_cast<unsigned>(terms.gradient)});
}

} // namespace

double importanceOfPlace(const RenderPlan& plan, const PlanImportance& measures, const SampleFacts& facts) {
    const ImportanceWeights& w = measures.source->weights;
    double sum = 0;
    const auto add = [&](double weight, const auto& measure) {
        if (weight > 0) {
            sum += weight * measure();
        }
    };
    add(w.intensity, [&] {
        const double span = measures.intensity.high - measures.intensity.low;
        return span > 0 ? optics::intensityImportance((facts.value - measures.intensity.low) / span) : 0;
    });
    add(w.gradient, [&] { return optics::gradientImportance(facts.surface.magnitude); });
    add(w.silhouette, [&] { return silhouettenessOf(*measures.source, facts); });
    add(w.lighting, [&] { return lightingOf(plan, measures, facts); });
    if (!measures.weightOfSlot.empty()) {
        for (const auto& [slot, share] : facts.membership) {
            sum += w.object * share * measures.weightOfSlot[static_cast<std::size_t>(slot)];
        }
    }
    if (measures.statistics) {
        sum += w.statistics * trilinearAt(*measures.statistics, facts.positionVoxel);
    }
    return sum;
}

double ImportanceRay::importanceOf(const PlanLayer& layer, const SampleFacts& facts, double extinction) const {
    const ImportanceWeights& w = settings_.weights;
    double sum = importanceOfPlace(plan_, *plan_.importance, facts);
    sum += w.extinction > 0 ? w.extinction * optics::extinctionImportance(extinction) : 0;
    sum += w.unocclusion > 0 ? w.unocclusion * optics::unocclusionImportance(depth_) : 0;
    const double total = optics::totalImportance(weight_ * layer.source->importanceWeight, sum);
    return optics::importanceOfVisible(std::min(total, settings_.cap), extinction, settings_.noiseFloor);
}

double ImportanceRay::add(const PlanLayer& layer, const SampleFacts& facts, const LayerSample& sample) {
    const double opacity = optics::opacityOfLength(sample.opacity, sample.lengthRatio);
    if (!(opacity > 0)) {
        return 1;
    }
    const double importance = importanceOf(layer, facts, optics::opticalDepth(sample.opacity));
    optics::Colour<double> colour = sample.colour;
    if (settings_.weights.silhouette > 0) {
        // As much as importance acts here: where a lens fades, so do its lines.
        const double acts = std::min(weight_ / settings_.global, 1.0);
        const double dark = std::exp(-settings_.silhouette.darkening * acts * silhouettenessOf(settings_, facts));
        colour = {colour.r * dark, colour.g * dark, colour.b * dark};
    }
    const double kept = optics::stepOfSample(state_, opacity, importance).kept;
    state_ = optics::withSample(state_, colour, opacity, importance);
    depth_ += optics::opticalDepth(opacity);
    return kept;
}

double ImportanceRay::certain() const {
    const double background = std::min(weight_ * settings_.background, optics::kGreatestImportance);
    return optics::certainShare(state_, std::max(std::min(settings_.cap, optics::kGreatestImportance), background));
}

optics::Accumulated<double> ImportanceRay::result() const {
    const double background = std::min(weight_ * settings_.background, optics::kGreatestImportance);
    const double alpha = optics::shareBeforeBackground(state_, background);
    return {state_.colour.r * alpha, state_.colour.g * alpha, state_.colour.b * alpha, alpha};
}

} // namespace limner::reference
