#pragma once

#include "renderer/interactive/render_thread.h"

#include <functional>
#include <memory>

namespace limner {

/// What draws: one way of planning, shared by screen and export so that both use the same preparations.
struct Engine {
    RenderThread::PlanFunction plan;
    std::function<std::unique_ptr<const Backend>()> makeBackend;
};

/// A planner and the backend of the user's choice.
Engine makeEngine();

} // namespace limner
