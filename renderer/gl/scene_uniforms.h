#pragma once

#include "renderer/gl/program.h"
#include "renderer/plan/render_plan.h"
#include "renderer/scene/kernel_scene.h"

namespace limner::gl {

/// Sets what holds for the whole picture. The program is in use.
void setScene(Program& program, const RenderPlan& plan, const KernelScene& scene);

/// Sets the rays of a tile, worked out from its middle in double. `corner`: sub-pixels of the whole picture, a multiple
/// of kTile.
void setTile(Program& program, const KernelScene& scene, const glm::ivec2& corner);

} // namespace limner::gl
