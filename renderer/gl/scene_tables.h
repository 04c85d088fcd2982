#pragma once

#include "renderer/plan/render_plan.h"
#include "renderer/scene/kernel_scene.h"

#include <glm/vec4.hpp>

#include <string>
#include <utility>
#include <vector>

namespace limner::gl {

/// All tables of a plan one after the other, for two buffer textures, and the uniforms that say where each begins.
struct SceneTables {
    std::vector<float> numbers;
    std::vector<glm::vec4> colours;
    std::vector<std::pair<std::string, int>> places;
};

SceneTables sceneTables(const RenderPlan& plan, const KernelScene& scene);

} // namespace limner::gl
