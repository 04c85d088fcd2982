#include "renderer/plan/plan_marks.h"

#include "renderer/marks/inner_lines.h"

namespace limner {

namespace {

/// The settings that a field is made by.
Stipple fieldSettings(const Stipple& stipple) {
    Stipple kept;
    kept.threshold = stipple.threshold;
    kept.sizeMm = stipple.sizeMm;
    kept.matter = stipple.matter;
    kept.gradient = stipple.gradient;
    if (stipple.curves) {
        kept.curves.emplace(); // the Laplacian and the surface's curvature
    } else if (stipple.innerLines || stipple.hatching) {
        kept.hatching.emplace(); // its curvature
    }
    return kept;
}

} // namespace

bool drawsLayers(const Figure& figure) { return !figure.stipple || figure.stipple->layerOpacity != "alone"; }

bool needsLayers(const Figure& figure) {
    return drawsLayers(figure) || figure.stipple->matter == "layers" || figure.stipple->fromStyle;
}

void MarkFields::add(RenderPlan& plan, const PlanRequest& request, Task& task) {
    const Figure& figure = *plan.figure;
    if (!figure.stipple) {
        return;
    }
    Key key{plan.volume,
            nullptr,
            {},
            {},
            {figure.output.widthMm, figure.output.heightMm},
            {markZoom(plan), request.moving},
            fieldSettings(*figure.stipple)};
    if (figure.stipple->matter == "layers") {
        key.labels = plan.labels;
        key.layers = figure.layers;
        key.clip = figure.clip;
    }
    auto marks = std::make_shared<PlanMarks>();
    marks->field = fields_.get(key, [&] {
        task.beginPhase("Preparing marks");
        return computeMarkField(plan, key.detail, task);
    });
    if (const auto& inner = figure.stipple->innerLines) {
        StippleInnerLines shape = *inner;
        shape.widthMm = 0; // the pen's affair
        marks->innerLines = innerLines_.get({marks->field, shape}, [&] {
            task.throwIfCancelled();
            return std::make_shared<const std::vector<SurfaceLine>>(traceInnerLines(*marks->field, *inner));
        });
    }
    marks->moving = request.moving;
    marks->layersDrawn = drawsLayers(figure) && !plan.layers.empty();
    plan.marks = marks;
}

} // namespace limner
