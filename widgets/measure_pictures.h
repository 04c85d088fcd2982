#pragma once

#include "core/base/task.h"
#include "renderer/plan/render_plan.h"

#include <QImage>

#include <string>
#include <utility>
#include <vector>

namespace limner {

/// Small pictures of what each measure of importance brings forward, by the pointer of its weight
/// ("/importance/weights/gradient"): the shown figure with that measure alone, everywhere. Measures that need a field
/// of their own (objects without labels, local statistics that the figure does not weigh) have none. Takes some tens
/// of milliseconds each; for a thread of its own. Throws Error(cancelled).
std::vector<std::pair<std::string, QImage>> measurePictures(const RenderPlan& shown, int edgePixels, Task& task);

} // namespace limner
