#include "renderer/marks/draw_marks.h"

#include "renderer/marks/curves.h"
#include "renderer/marks/hatching.h"
#include "renderer/marks/ink.h"
#include "renderer/marks/inner_lines.h"

#include <algorithm>
#include <iterator>

namespace limner {

namespace {

void append(Marks& marks, std::vector<MarkGroup> groups) {
    std::move(groups.begin(), groups.end(), std::back_inserter(marks.groups));
}

/// Lines lie over dots: they hold a drawing together.
void addLines(const MarkScene& scene, const PlanMarks& plan, Marks& marks, Task& task) {
    const LineScene lines{scene.field, scene.view, scene.depth, scene.plain, scene.moving};
    if (const auto& hatching = scene.stipple.hatching) {
        std::vector<float> tone(scene.ink.size());
        std::transform(scene.ink.begin(), scene.ink.end(), tone.begin(), [](const VoxelInk& ink) { return ink.tone; });
        append(marks,
               drawHatching(lines, *hatching, tone, scene.colours, static_cast<std::uint32_t>(scene.stipple.seed)));
    }
    task.throwIfCancelled();
    if (const auto& inner = scene.stipple.innerLines; inner && plan.innerLines) {
        append(marks, drawInnerLines(lines, *plan.innerLines, *inner));
    }
    task.throwIfCancelled();
    if (const auto& curves = scene.stipple.curves) {
        append(marks, drawSilhouettes(lines, *curves));
    }
    task.throwIfCancelled();
}

} // namespace

bool Marks::empty() const {
    return std::all_of(groups.begin(), groups.end(),
                       [](const MarkGroup& group) { return group.dots.empty() && group.strokes.empty(); });
}

std::size_t Marks::dotCount() const {
    std::size_t count = 0;
    for (const MarkGroup& group : groups) {
        count += group.dots.size();
    }
    return count;
}

std::size_t Marks::strokeCount() const {
    std::size_t count = 0;
    for (const MarkGroup& group : groups) {
        count += group.strokes.size();
    }
    return count;
}

MarkOrder orderOf(const Stipple& stipple) {
    return stipple.layerOpacity == "over" ? MarkOrder::overLayers : MarkOrder::underLayers;
}

Marks drawMarks(const RenderPlan& plan, Task& task, const MarkKinds& kinds) {
    Marks marks;
    marks.paperMm = {plan.figure->output.widthMm, plan.figure->output.heightMm};
    if (!plan.marks) {
        return marks;
    }
    const Stipple& stipple = *plan.figure->stipple;
    marks.order = orderOf(stipple);
    marks.layersDrawn = plan.marks->layersDrawn;
    for (const std::string& warning : plan.marks->field->warnings) {
        task.warn(warning);
    }
    const bool dots = kinds.dots && stipple.kMax > 0 && stipple.sizeMm > 0;
    const bool strokes = kinds.strokes && (stipple.hatching || stipple.curves || plan.marks->innerLines);
    if (!dots && !strokes) {
        return marks;
    }
    const MarkScene scene = makeMarkScene(plan, *plan.marks->field, plan.marks->moving, task);
    if (dots) {
        if (scene.moving || stipple.placing == "volume") {
            addDotsOnVolume(scene, marks, task);
        } else {
            addDotsOnPaper(scene, marks, task);
        }
    }
    if (strokes) {
        addLines(scene, *plan.marks, marks, task);
    }
    return marks;
}

} // namespace limner
