#include "renderer/plan/describe_plan.h"

#include "core/figure/figure_json.h"

#include <algorithm>

namespace limner {

namespace {

std::size_t tableBytes(const PlanLayer& layer) {
    return (layer.table.opacity.size() + layer.table.index.size() + layer.stepOpacity.size()) * sizeof(float);
}

std::size_t atlasBytes(const StyleAtlas& atlas) {
    return atlas.texels.size() * sizeof(std::int16_t) + atlas.mean.size() * sizeof(Rgba);
}

bool anyLayer(const RenderPlan& plan, Shading shading) {
    return std::any_of(plan.layers.begin(), plan.layers.end(),
                       [&](const PlanLayer& l) { return l.shading == shading; });
}

} // namespace

void describePlan(RenderPlan& plan, const PlanRequest& request) {
    plan.notDrawn = partsNotDrawn(*plan.figure);
    const auto feature = [&](bool used, const char* name, const char* why, const char* whyNot) {
        (used ? plan.featuresUsed : plan.featuresLeftOut).push_back({name, used ? why : whyNot});
    };
    const bool style = anyLayer(plan, Shading::style);
    const bool phong = anyLayer(plan, Shading::phong);
    feature(style, "lit-sphere styles", "a layer is drawn in styles", "no layer is drawn in styles");
    feature(style && plan.atlas && plan.atlas->directionalOpacity, "directional opacity",
            "a style has transparent directions", "every style is opaque in all directions");
    feature(phong, "Phong shading", "a layer asks for it", "no layer asks for it");
    feature(style || phong, "gradients", "shading needs normals", "nothing drawn needs normals");
    feature(plan.layers.size() > 1, "several layers", "more than one layer shows", "one layer at most shows");
    feature(plan.rays.perspective, "perspective", "the camera has it", "the camera is orthographic");
    feature(plan.subPixels > 1, "supersampling", "several rays for each pixel", "one ray for each pixel");
    feature(plan.clip.boxMm || !plan.clip.planes.empty(), "clipping", "a box or planes cut the volume",
            "nothing is cut away");
    feature(!plan.figure->cleanup.empty(), "clean-up", "steps remove matter from the volume", "no clean-up steps");
    feature(request.omit, "empty-space skipping", "blocks that show nothing are passed over", "switched off");
    const std::size_t hidden = plan.figure->layers.size() - plan.layers.size();
    if (hidden > 0) {
        plan.featuresLeftOut.push_back(
            {std::to_string(hidden) + (hidden == 1 ? " layer" : " layers"), "hidden, or without any opacity"});
    }
    for (const PlanLayer& layer : plan.layers) {
        plan.bytes += tableBytes(layer);
    }
    plan.bytes += plan.atlas ? atlasBytes(*plan.atlas) : 0;
    plan.bytes +=
        plan.skip ? plan.skip->distance.size() * (1 + 2 * sizeof(float)) : 0; // with the min-max grid behind it
    plan.bytes += plan.volume != plan.figure->volume->data ? plan.volume->bytes() : 0;
}

} // namespace limner
