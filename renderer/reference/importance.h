#pragma once

#include "core/optics/importance.h"
#include "renderer/reference/layer_optics.h"

namespace limner::reference {

/// Weighted sum of the measures that are a function of place and view: all but extinction and unocclusion.
double importanceOfPlace(const RenderPlan& plan, const PlanImportance& measures, const SampleFacts& facts);

/// One ray's importance-aware composition in double (paper 001; core/optics/importance.h).
class ImportanceRay {
  public:
    /// `weight`: the global one at the ray's pixel, above 0.
    ImportanceRay(const RenderPlan& plan, double weight);

    /// Composes one layer at one sample. Gives the share of the colour so far that stays.
    double add(const PlanLayer& layer, const SampleFacts& facts, const LayerSample& sample);

    /// Share of the picture's colour that nothing behind can change.
    [[nodiscard]] double certain() const;

    /// Premultiplied, the background's importance counted.
    [[nodiscard]] optics::Accumulated<double> result() const;

    /// Of one layer at one sample, in [0, kGreatestImportance].
    [[nodiscard]] double importanceOf(const PlanLayer& layer, const SampleFacts& facts, double extinction) const;

  private:
    const RenderPlan& plan_;
    const Importance& settings_;
    double weight_;
    optics::ImportanceState<double> state_ = optics::startOfRay<double>();
    double depth_ = 0; ///< optical
};

} // namespace limner::reference
