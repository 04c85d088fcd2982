#include "app/studio/engine.h"

#include "app/studio/studio_backend.h"

namespace limner {

Engine makeEngine() {
    auto planner = std::make_shared<Planner>();
    return {[planner](const Figure& figure, const PlanRequest& request, Task& task) {
                return planner->plan(figure, request, task);
            },
            [] { return makeStudioBackend(); }};
}

} // namespace limner
