#pragma once

#include "core/base/task.h"
#include "core/figure/figure.h"

#include <memory>

namespace limner {

/// The volume with the figure's clean-up steps applied: removed matter, with the partial-volume rim around it, takes
/// the volume's lowest value, so that no false wall is left. The same pointer comes back where there is no step.
/// `figureAspect`: width / height of the figure, for lassos that do not tell their own. Throws Error(cancelled).
std::shared_ptr<const Volume> applyCleanup(std::shared_ptr<const Volume> volume, const Volume* labels,
                                           const std::vector<CleanupStep>& steps, double figureAspect, Task& task);

} // namespace limner
