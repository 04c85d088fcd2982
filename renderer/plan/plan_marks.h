#pragma once

#include "core/base/task.h"
#include "renderer/marks/mark_field.h"
#include "renderer/plan/plan_fields.h"
#include "renderer/plan/planner.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace limner {

/// False where the picture is marks alone and they read no layer: nothing of the layers is planned then.
bool needsLayers(const Figure& figure);

/// Whether the layers are drawn as well.
bool drawsLayers(const Figure& figure);

/// Keeps fields of marks by what they were made from.
class MarkFields {
  public:
    /// Fills in `plan.marks` where the figure has stipples; the layers and their fields are there. Throws
    /// Error(cancelled).
    void add(RenderPlan& plan, const PlanRequest& request, Task& task);

  private:
    struct Key {
        std::shared_ptr<const Volume> volume;
        std::shared_ptr<const Volume> labels; ///< with what follows: only where layers are the matter
        std::vector<Layer> layers;
        Clip clip;
        glm::dvec2 paperMm{0};
        MarkDetail detail;
        Stipple settings; ///< without what the field does not read
        friend bool operator==(const Key&, const Key&) = default;
    };
    RecentResults<Key, std::shared_ptr<const MarkField>> fields_{4}; ///< still and moving, and what was before
    RecentResults<std::pair<std::shared_ptr<const MarkField>, StippleInnerLines>,
                  std::shared_ptr<const std::vector<SurfaceLine>>>
        innerLines_{2};
};

} // namespace limner
