#include "renderer/interactive/render_thread.h"

#include <utility>

namespace limner {
namespace {

RenderThread::PlanFunction plannerFunction() {
    auto planner = std::make_shared<Planner>();
    return [planner](const Figure& figure, const PlanRequest& request, Task& task) {
        return planner->plan(figure, request, task);
    };
}

} // namespace

RenderThread::RenderThread(std::unique_ptr<const Backend> backend, RenderCallbacks callbacks, Options options)
    : RenderThread(plannerFunction(), std::move(backend), std::move(callbacks), options) {}

RenderThread::RenderThread(std::unique_ptr<const Backend> backend, RenderCallbacks callbacks)
    : RenderThread(std::move(backend), std::move(callbacks), Options{}) {}

} // namespace limner
