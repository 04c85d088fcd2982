#include "renderer/plan/eight_bits.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace limner {

namespace {

/// Empty: codes will do.
std::string whyFull(const RenderPlan& plan) {
    if (plan.volume->type() == VoxelType::uint8) {
        return "the scan has eight bits already";
    }
    if (plan.field != plan.volume || plan.gradientField != plan.volume) {
        return "splines and smoothed slices are computed from full voxels";
    }
    const auto blurs = [&](const Layer& layer) {
        return plan.figure->draws(layer) && layer.depthOfField && layer.depthOfField->strength > 0;
    };
    if (std::any_of(plan.figure->layers.begin(), plan.figure->layers.end(), blurs)) {
        return "depth of field blurs full voxels";
    }
    return plan.figure->importance ? "importance weighs full voxels" : "";
}

} // namespace

void EightBits::apply(RenderPlan& plan, Task& task) {
    if (plan.figure->quality.precision != VoxelPrecision::eightBits) {
        return;
    }
    plan.eightBits.emplace();
    plan.eightBits->whyFull = whyFull(plan);
    if (!plan.eightBits->whyFull.empty()) {
        return;
    }
    const Kept& kept = kept_.get(plan.volume, [&] {
        const QuantisedVolume best = quantiseLloydMax(*plan.volume, task);
        const QuantisedVolume even = quantiseUniformly(*plan.volume, task);
        return Kept{best.volume,
                    {std::sqrt(best.meanSquareError),
                     best.largestError,
                     std::sqrt(even.meanSquareError),
                     even.largestError,
                     {}}};
    });
    plan.volume = plan.field = plan.gradientField = kept.volume;
    plan.eightBits = kept.facts;
}

std::string describeEightBits(const RenderPlan& plan) {
    const PlanEightBits& facts = *plan.eightBits;
    const std::string& unit = plan.volume->contents().unit;
    const auto error = [&](const char* name, double best, double even) {
        std::ostringstream text;
        text.precision(3);
        text << name << ' ' << best << (unit.empty() ? "" : " ") << unit << " (even levels: " << even << "), ";
        return text.str();
    };
    const VoxelType full = plan.figure->volume->data->type();
    return error("RMS error", facts.rmsError, facts.rmsErrorOfEven) +
           error("largest", facts.largestError, facts.largestErrorOfEven) +
           (full == VoxelType::float32 ? "a quarter of what full ones take, beside the scan"
                                       : "half of what full ones take, beside the scan");
}

} // namespace limner
