#include "renderer/plan/describe_plan.h"

#include "core/figure/figure_json.h"
#include "renderer/marks/mark_field.h"
#include "renderer/plan/coarse_opacity.h"
#include "renderer/plan/eight_bits.h"
#include "renderer/plan/mip_levels.h"
#include "renderer/plan/plan_parts.h"
#include "renderer/plan/slab_table.h"

#include <algorithm>
#include <functional>

namespace limner {

namespace {

std::size_t tableBytes(const PlanLayer& layer) {
    const TransferTable& table = layer.table;
    return (table.opacity.size() + table.index.size() + table.rowIndex.size() + table.opacity2d.size() +
            layer.stepOpacity.size() + layer.slabs.size()) *
           sizeof(float);
}

std::size_t atlasBytes(const StyleAtlas& atlas) {
    std::size_t bytes = atlas.texels.size() * sizeof(std::int16_t) + atlas.mean.size() * sizeof(Rgba);
    for (const auto& level : atlas.pictures) {
        for (const auto& picture : level) {
            bytes += picture->pixels().size_bytes();
        }
    }
    return bytes;
}

/// Of local statistics: one field for composition and axes.
std::size_t statisticsBytes(const RenderPlan& plan) {
    for (const auto* measures : {&plan.importance, &plan.axisMeasures}) {
        if (*measures && (*measures)->statistics) {
            return (*measures)->statistics->bytes();
        }
    }
    return 0;
}

template <typename Test>
bool anyLayer(const RenderPlan& plan, const Test& test) {
    return std::any_of(plan.layers.begin(), plan.layers.end(), test);
}

const char* gradientName(GradientEstimator estimator) {
    switch (estimator) {
    case GradientEstimator::sobel: return "Sobel gradients";
    case GradientEstimator::neumann: return "Neumann gradients";
    case GradientEstimator::fourthOrder: return "fourth-order gradients";
    case GradientEstimator::bspline: return "B-spline gradients";
    case GradientEstimator::automatic:
    case GradientEstimator::central: break;
    }
    return "central gradients";
}

using AddFeature = std::function<void(bool used, const char* name, const char* why, const char* whyNot)>;

/// What transfer functions, contours and transparency ask for.
void describeTransfers(const RenderPlan& plan, const AddFeature& feature) {
    const auto axis = [&](TransferAxis which) {
        return anyLayer(plan, [which](const PlanLayer& layer) { return readsAxis(layer, which); });
    };
    feature(anyLayer(plan, [](const PlanLayer& l) { return l.table.rows > 0; }), "two-dimensional transfer functions",
            "a layer has two axes", "every layer has one axis");
    feature(plan.labels != nullptr, "labels", "a layer tells labels apart", "no layer asks for labels");
    feature(axis(TransferAxis::distance), "distances", "a layer's axis is a distance", "no layer measures distances");
    feature(plan.secondVolume != nullptr, "second volume", "a layer's axis reads it", "no layer reads one");
    feature(anyLayer(plan, [](const PlanLayer& l) { return l.contours.has_value(); }), "contours", "a layer draws them",
            "no layer draws them");
    feature(anyLayer(plan, readsCurvature), "curvature", "contours keep their width, or an axis reads it",
            "no layer reads it");
    feature(anyLayer(plan, [](const PlanLayer& l) { return l.illustrative; }), "illustrative transparency",
            "a layer clears flat regions first", "every layer is uniformly transparent");
    feature(anyLayer(plan, [](const PlanLayer& l) { return !l.textures.empty(); }), "textures", "a style carries one",
            "no style carries one");
    feature(plan.interpolation == Interpolation::tricubic, "tricubic interpolation", "the quality asks for it",
            "voxels are joined otherwise");
    feature(plan.interpolation == Interpolation::smooth, "smooth interpolation",
            "the quality asks for it, or the slices are thick", "voxels are joined otherwise");
    const int entries = plan.figure->quality.tableEntries;
    const std::string asked = "the quality asks for " + std::to_string(entries) + " entries";
    feature(entries > 0, "tables of a chosen size", asked.c_str(), "tables are as fine as the data need");
    const std::string whyNot = whyNoSlabs(plan);
    feature(plan.preintegrated, "pre-integration", "the quality asks for it", whyNot.c_str());
}

/// What the layers' parts and depth cues ask for.
void describeParts(const RenderPlan& plan, const AddFeature& feature) {
    const auto part = [&](bool (*has)(const PlanParts&), const char* name) {
        const bool used = anyLayer(plan, [has](const PlanLayer& l) { return l.parts && has(*l.parts); });
        feature(used, name, "a layer has it", "no layer has it");
    };
    part([](const PlanParts& p) { return p.tone.has_value(); }, "tone");
    part([](const PlanParts& p) { return p.silhouette.has_value(); }, "silhouettes");
    part([](const PlanParts& p) { return p.specular.has_value(); }, "highlights");
    part([](const PlanParts& p) { return p.gradientOpacity || p.lineGradientOpacity; }, "opacity by gradient");
    part([](const PlanParts& p) { return p.position.has_value(); }, "colour by position");
    feature(!plan.blurs.empty(), "depth of field", "a layer blurs away from its focus", "no layer blurs");
    feature(anyLayer(plan, [](const PlanLayer& l) { return l.cut.has_value(); }), "clipping of layers",
            "a layer is cut by itself", "no layer is cut by itself");
    feature(plan.faces || anyLayer(plan, [](const PlanLayer& l) { return l.cut && l.cut->faces; }), "flat cut faces",
            "a cut asks for them", "no cut asks for them");
    feature(plan.cues && plan.cues->ambient, "ambient occlusion", "the figure asks for it", "the figure has none");
    feature(plan.cues && plan.cues->shadow, "contact shadow", "the figure asks for it", "the figure has none");
    const bool asked = plan.figure->depthCues && plan.figure->depthCues->halo;
    feature(plan.cues && plan.cues->halo, "halos", "the figure asks for them",
            asked && plan.rays.perspective ? "they follow parallel rays, and the camera has perspective"
                                           : "the figure has none");
    if (plan.cues && !std::all_of(plan.layers.begin(), plan.layers.end(), countsInCues)) {
        feature(false, "depth cues of a layer", "", "curvature or importance tells what it shows, along rays only");
    }
}

/// Ink: each factor and each kind of mark on its own.
void describeMarks(const RenderPlan& plan, const AddFeature& feature) {
    const auto& stipple = plan.figure->stipple;
    feature(plan.marks != nullptr, "marks of ink", "the figure has stipples", "the figure has none");
    if (!stipple) {
        return;
    }
    const auto part = [&](bool used, const char* name) {
        feature(used, name, "the stipples have it", "the stipples have it not");
    };
    const bool dots = stipple->kMax > 0 && stipple->sizeMm > 0;
    part(dots, "dots");
    feature(dots && plan.marks->moving && !stipple->fromStyle, "dots by the graphics card, where it draws",
            "the view moves and there is one ink",
            !dots                ? "the stipples have none"
            : plan.marks->moving ? "the ink takes the styles' colours: the processor lays the dots"
                                 : "the view stands still: the processor lays its dots");
    part(stipple->boundary.has_value(), "dots by boundary");
    part(stipple->silhouette.has_value(), "dots by silhouette");
    part(stipple->resolution.has_value(), "dots by resolution");
    part(stipple->distance.has_value(), "dots by distance");
    part(stipple->interior.has_value(), "dots by interior");
    part(stipple->lighting.has_value(), "dots by lighting");
    part(stipple->curves.has_value(), "silhouette curves");
    part(stipple->innerLines.has_value(), "ridges and valleys");
    part(stipple->hatching.has_value(), "hatching");
    feature(plan.marks->layersDrawn, "layers under or over the ink", "layers are drawn", "the ink is alone");
}

/// Each measure on its own: one without a weight is not taken.
void describeImportance(const RenderPlan& plan, const AddFeature& feature) {
    feature(plan.importance.has_value(), "importance-aware composition", "the figure weighs what matters",
            "the figure has none");
    if (!plan.importance) {
        return;
    }
    const ImportanceWeights& w = plan.importance->source->weights;
    const std::pair<double, const char*> measures[] = {
        {w.intensity, "importance of intensity"},
        {w.extinction, "importance of extinction"},
        {w.gradient, "importance of gradients"},
        {w.silhouette, "importance of silhouettes"},
        {w.unocclusion, "importance of unocclusion"},
        {w.lighting, "importance of lighting"},
        {plan.importance->weightOfSlot.empty() ? 0 : w.object, "importance of objects"},
        {w.statistics, "importance of local statistics"},
    };
    for (const auto& [weight, name] : measures) {
        feature(weight > 0, name, "it has a weight", "it has no weight");
    }
    feature(!plan.importance->lenses.empty(), "focus lenses", "importance acts in places",
            "importance acts everywhere");
}

void countBytes(RenderPlan& plan) {
    for (const PlanLayer& layer : plan.layers) {
        plan.bytes += tableBytes(layer);
    }
    plan.bytes += plan.atlas ? atlasBytes(*plan.atlas) : 0;
    plan.bytes +=
        plan.skip ? plan.skip->distance.size() * (1 + 2 * sizeof(float)) : 0; // with the min-max grid behind it
    plan.bytes += plan.volume != plan.figure->volume->data ? plan.volume->bytes() : 0;
    plan.bytes += plan.field != plan.volume ? plan.field->bytes() : 0;
    plan.bytes += plan.gradientField != plan.field ? plan.gradientField->bytes() : 0;
    plan.bytes += plan.bendField ? plan.bendField->bytes() : 0;
    for (const auto& blur : plan.blurs) {
        plan.bytes += blur->bytes();
    }
    if (plan.cues) {
        for (const auto& field : {plan.cues->ambient, plan.cues->shadow, plan.cues->halo}) {
            plan.bytes += field ? field->values.size() * sizeof(float) : 0;
        }
    }
    plan.bytes += plan.labels ? plan.labels->bytes() : 0;
    plan.bytes += plan.secondVolume ? plan.secondVolume->bytes() : 0;
    plan.bytes += plan.marks ? plan.marks->field->bytes() : 0;
    plan.bytes += statisticsBytes(plan);
}

} // namespace

void describePlan(RenderPlan& plan) {
    plan.leftOut = rulesAtWork(plan);
    const auto leavesOut = [&](LeaveOut rule) {
        return std::any_of(plan.leftOut.begin(), plan.leftOut.end(),
                           [rule](const LeftOut& out) { return out.rule == rule; });
    };
    const AddFeature feature = [&](bool used, const char* name, const char* why, const char* whyNot) {
        (used ? plan.featuresUsed : plan.featuresNotAsked).push_back({name, used ? why : whyNot});
    };
    const bool style = anyLayer(plan, [](const PlanLayer& l) { return l.shading == Shading::style; });
    const bool phong = anyLayer(plan, [](const PlanLayer& l) { return l.shading == Shading::phong; });
    feature(style, "lit-sphere styles", "a layer is drawn in styles", "no layer is drawn in styles");
    feature(style && plan.atlas && plan.atlas->directionalOpacity, "directional opacity",
            "a style has transparent directions", "every style is opaque in all directions");
    if (!leavesOut(LeaveOut::mipLevels)) {
        feature(plan.mipLevels.has_value(), "mip levels of styles",
                "pixels are wider than voxels, here more and there less", whyNoMipLevels(plan));
    }
    feature(phong, "Phong shading", "a layer asks for it", "no layer asks for it");
    if (!leavesOut(LeaveOut::normals)) {
        feature(readsNormal(plan), gradientName(plan.gradient), "layers or importance need normals",
                "nothing is drawn that could need normals");
    }
    describeTransfers(plan, feature);
    describeParts(plan, feature);
    if (!leavesOut(LeaveOut::importance)) {
        describeImportance(plan, feature);
    }
    describeMarks(plan, feature);
    feature(plan.layers.size() > 1, "several layers", "more than one layer shows", "one layer at most shows");
    feature(plan.rays.perspective, "perspective", "the camera has it", "the camera is orthographic");
    feature(plan.subPixels > 1, "supersampling", "several rays for each pixel", "one ray for each pixel");
    feature(cutsAnything(plan.clip), "clipping", "a box or planes cut the volume", "nothing is cut away");
    feature(!plan.figure->cleanup.empty(), "clean-up", "steps remove matter from the volume", "no clean-up steps");
    const bool codes = plan.eightBits && plan.eightBits->whyFull.empty();
    const std::string codesCost = codes ? describeEightBits(plan) : "";
    feature(codes, "eight-bit voxels", codesCost.c_str(),
            plan.eightBits ? plan.eightBits->whyFull.c_str() : "the voxels are as they are");
    feature(!plan.kept.has(LeaveOut::emptySpace), "empty-space skipping", "blocks that show nothing are passed over",
            "switched off");
    const auto hidden = std::count_if(plan.figure->layers.begin(), plan.figure->layers.end(),
                                      [&](const Layer& layer) { return !plan.figure->draws(layer); });
    if (hidden > 0) {
        plan.featuresNotAsked.push_back({std::to_string(hidden) + (hidden == 1 ? " layer" : " layers"), "hidden"});
    }
    countBytes(plan);
}

} // namespace limner
