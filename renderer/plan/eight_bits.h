#pragma once

#include "core/volume/quantise.h"
#include "renderer/plan/plan_fields.h"
#include "renderer/plan/render_plan.h"

namespace limner {

/// Keeps a plan's voxels in the 256 levels that fit them best, where the figure asks for it and what is drawn can be
/// read off codes. Between voxels codes are interpolated, and gradients are differences of codes: surfaces keep their
/// direction and move within a voxel, magnitudes are relative to the density of levels.
class EightBits {
  public:
    /// Replaces the plan's volume and its fields, or says in `eightBits` why not. After the choice of estimators.
    void apply(RenderPlan& plan, Task& task);

  private:
    struct Kept {
        std::shared_ptr<const Volume> volume;
        PlanEightBits facts;
    };
    RecentResults<std::shared_ptr<const Volume>, Kept> kept_;
};

/// "RMS error 3.1 HU (even levels: 8), largest 40 HU (even levels: 14), half the memory".
std::string describeEightBits(const RenderPlan& plan);

} // namespace limner
