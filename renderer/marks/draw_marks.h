#pragma once

#include "core/base/task.h"
#include "renderer/marks/marks.h"
#include "renderer/plan/render_plan.h"

namespace limner {

MarkOrder orderOf(const Stipple& stipple);

/// Which of a figure's marks are asked for.
struct MarkKinds {
    bool dots = true;
    bool strokes = true;
};

/// The marks of a plan's figure in its view; none where it has no stipples. The same for every size of the picture, on
/// every machine and any number of threads. Throws Error(cancelled).
Marks drawMarks(const RenderPlan& plan, Task& task, const MarkKinds& kinds = {});

} // namespace limner
