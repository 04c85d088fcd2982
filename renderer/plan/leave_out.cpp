#include "renderer/plan/leave_out.h"

#include "renderer/marks/ink.h"
#include "renderer/plan/mip_levels.h"
#include "renderer/plan/plan_importance.h"
#include "renderer/plan/plan_layer.h"
#include "renderer/plan/plan_marks.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace limner {

namespace {

using enum LeaveOutEquality;

// Why each is sound:
// - layers: a sample of opacity 0 is a no-op of composition; but one layer of two is summed in another order.
// - importance: then no sample takes from what lies in front of it: composition is "over".
// - importanceOutsideLenses: the global weight is 0 there; the rest as before.
// - importanceOfRest: a sample of no more importance than its ray composes as if it had none.
// - normals, curvature: nobody reads what is not measured.
// - emptySpace: opacity 0 again, by an interval of values that holds all that a sample in the block can read.
// - restOfRay: what is left of the light, or of the retention bound, is below the figure's early termination.
// - wideVoxels: eight bits are blended by the same whole weights as sixteen.
// - mipLevels: the level's formula gives 0 everywhere.
// - dotFactors: x^0 is 1, and a product by 1 is exact.
// - colourLookups: the blend of equal colours is that colour.
constexpr std::array<LeaveOutRule, kLeaveOutRules> kRules{{
    {LeaveOut::layers, "layers", "layers that show nothing", "their opacity is 0 at every value", rounding},
    {LeaveOut::importance, "importance", "importance-aware composition",
     "nothing that can show matters more than anything else, nor the background", rounding},
    {LeaveOut::importanceOutsideLenses, "importance-outside-lenses", "importance where no lens reaches",
     "every lens has the factor 0 in all of a block of rays", rounding},
    {LeaveOut::importanceOfRest, "importance-of-rest", "importance of what cannot claim any",
     "nothing from here on is more important than what the ray has met", sameBits},
    {LeaveOut::normals, "normals", "gradients and normals",
     "no layer is lit, drawn in styles, contoured, or transparent by them, and no importance is measured on them",
     sameBits},
    {LeaveOut::curvature, "curvature", "curvature of contours", "the contours' thickness is 0", sameBits},
    {LeaveOut::emptySpace, "empty-space", "samples of empty blocks",
     "the greatest opacity over the values that samples in a block can have is 0", sameBits},
    {LeaveOut::restOfRay, "rest-of-ray", "rays behind what hides all",
     "all that lies behind can change no more than the early termination", tolerance},
    {LeaveOut::wideVoxels, "wide-voxels", "wider voxels", "the scan has eight bits", sameBits},
    {LeaveOut::mipLevels, "mip-levels", "mip levels of styles", "no ray is wider than a voxel", sameBits},
    {LeaveOut::dotFactors, "dot-factors", "factors of dots", "their exponent is 0: they are 1 everywhere", sameBits},
    {LeaveOut::colourLookups, "colour-lookups", "look-ups of colours",
     "all nodes of a layer have the same style or plain colour", rounding},
}};

bool isDrawn(const RenderPlan& plan, const Layer& layer) {
    return plan.figure->draws(layer) && needsLayers(*plan.figure);
}

std::string share(double part) { return std::to_string(static_cast<int>(std::floor(100 * part))) + " %"; }

std::string names(const std::vector<std::string>& all) {
    std::string text;
    for (const std::string& name : all) {
        text += (text.empty() ? "" : ", ") + (name.empty() ? std::string("a layer") : name);
    }
    return text;
}

std::string layersOf(const RenderPlan& plan) {
    std::vector<std::string> gone;
    for (const Layer& layer : plan.figure->layers) {
        const auto planned = [&](const PlanLayer& one) { return one.source == &layer; };
        if (isDrawn(plan, layer) && std::none_of(plan.layers.begin(), plan.layers.end(), planned)) {
            gone.push_back(layer.name);
        }
    }
    return names(gone);
}

std::string importanceOf(const RenderPlan& plan) {
    return plan.figure->importance && !plan.importance ? "the figure's weights come to nothing" : "";
}

/// Of the picture, in parts of a 16th along each edge.
std::string outsideLensesOf(const RenderPlan& plan) {
    if (!plan.importance || plan.importance->lenses.empty()) {
        return "";
    }
    constexpr int kParts = 16;
    const glm::dvec2 part = glm::dvec2(plan.size) / (static_cast<double>(plan.size.y) * kParts);
    int missed = 0;
    for (int i = 0; i < kParts * kParts; ++i) {
        const glm::dvec2 low = glm::dvec2(i % kParts, i / kParts) * part;
        missed += lensesMiss(plan.importance->lenses, low, low + part) ? 1 : 0;
    }
    return missed > 0 ? share(static_cast<double>(missed) / (kParts * kParts)) + " of the picture" : "";
}

std::string importanceOfRestOf(const RenderPlan& plan) {
    return settlesImportance(plan) ? "behind the most important thing on a ray" : "";
}

std::string normalsOf(const RenderPlan& plan) {
    return !plan.layers.empty() && !readsNormal(plan) ? "at every sample" : "";
}

std::string curvatureOf(const RenderPlan& plan) {
    std::vector<std::string> flat;
    for (const PlanLayer& layer : plan.layers) {
        if (layer.source->contours && layer.source->contours->curvatureControlled && !layer.contours) {
            flat.push_back(layer.name);
        }
    }
    return names(flat);
}

std::string emptySpaceOf(const RenderPlan& plan) {
    return !plan.layers.empty() && plan.skip && plan.skip->occupied < 1
               ? share(1 - plan.skip->occupied) + " of the blocks"
               : "";
}

std::string restOfRayOf(const RenderPlan& plan) {
    return !plan.layers.empty() && plan.earlyTermination > 0 ? "behind opaque matter" : "";
}

std::string wideVoxelsOf(const RenderPlan& plan) { return samplesEightBits(plan) ? "half of sixteen bits" : ""; }

std::string mipLevelsOf(const RenderPlan& plan) {
    return plan.atlas && !plan.mipLevels && !oneLevelServesAll(plan) ? "all levels but the finest" : "";
}

std::string dotFactorsOf(const RenderPlan& plan) {
    if (!plan.marks) {
        return "";
    }
    const IdleFactors idle = idleFactors(*plan.figure->stipple);
    std::vector<std::string> all;
    if (idle.distance) {
        all.emplace_back("by distance");
    }
    if (idle.interior) {
        all.emplace_back("by interior");
    }
    return names(all);
}

std::string colourLookupsOf(const RenderPlan& plan) {
    std::vector<std::string> plain;
    for (const PlanLayer& layer : plan.layers) {
        if (hasOneColour(layer)) {
            plain.push_back(layer.name);
        }
    }
    return names(plain);
}

/// What a rule leaves out of a plan; empty: its condition does not hold.
std::string whatOf(LeaveOut rule, const RenderPlan& plan) {
    switch (rule) {
    case LeaveOut::layers: return layersOf(plan);
    case LeaveOut::importance: return importanceOf(plan);
    case LeaveOut::importanceOutsideLenses: return outsideLensesOf(plan);
    case LeaveOut::importanceOfRest: return importanceOfRestOf(plan);
    case LeaveOut::normals: return normalsOf(plan);
    case LeaveOut::curvature: return curvatureOf(plan);
    case LeaveOut::emptySpace: return emptySpaceOf(plan);
    case LeaveOut::restOfRay: return restOfRayOf(plan);
    case LeaveOut::wideVoxels: return wideVoxelsOf(plan);
    case LeaveOut::mipLevels: return mipLevelsOf(plan);
    case LeaveOut::dotFactors: return dotFactorsOf(plan);
    case LeaveOut::colourLookups: return colourLookupsOf(plan);
    }
    return "";
}

} // namespace

std::span<const LeaveOutRule> leaveOutRules() { return kRules; }

const LeaveOutRule& ruleOf(LeaveOut what) { return kRules[static_cast<std::size_t>(what)]; }

const char* nameOf(LeaveOutEquality equality) {
    switch (equality) {
    case sameBits: return "same bits";
    case rounding: return "rounding";
    case tolerance: return "early termination";
    }
    return "";
}

KeptIn KeptIn::allOf(LeaveOutEquality equality) {
    KeptIn kept;
    for (const LeaveOutRule& rule : kRules) {
        kept.rules_.set(static_cast<std::size_t>(rule.what), rule.equality == equality);
    }
    return kept;
}

bool samplesEightBits(const RenderPlan& plan) {
    return plan.volume->type() == VoxelType::uint8 && plan.figure->quality.precision == VoxelPrecision::full &&
           (plan.field == plan.volume || plan.gradientField == plan.volume);
}

std::vector<LeftOut> rulesAtWork(const RenderPlan& plan) {
    std::vector<LeftOut> all;
    for (const LeaveOutRule& rule : kRules) {
        const std::string what = plan.kept.has(rule.what) ? "" : whatOf(rule.what, plan);
        if (!what.empty()) {
            all.push_back({rule.what, what});
        }
    }
    return all;
}

} // namespace limner
