#pragma once

#include "renderer/gl/program_source.h"
#include "renderer/plan/render_plan.h"
#include "renderer/scene/kernel_scene.h"

namespace limner::gl {

/// How a plan's shader is to work, beside what the plan says.
struct ProgramChoices {
    bool paged = false; ///< the picture comes in several passes, the state of the rays handed on
    /// Composition by importance, for a plan that has it: not where no lens reaches.
    bool byImportance = false;
    /// Shading waits until all rays of a vector have a sample: for programs that draw on the processor.
    bool marchThenShade = false;
    bool lenses = false; ///< global weights differ from place to place
};

/// The ray caster for one plan: which features it has. No number of the plan is in it, so edits of numbers and tables
/// never compile.
ProgramSource castingProgram(const RenderPlan& plan, const KernelScene& scene, const ProgramChoices& choices);

/// Draws over the whole target.
ProgramSource wholeTarget();

/// Sub-pixels along an edge of a tile: rays are worked out from its middle, so tiles lie on multiples of this.
inline constexpr int kTile = 512;

} // namespace limner::gl
