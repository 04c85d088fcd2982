#pragma once

#include "core/base/task.h"
#include "renderer/plan/render_plan.h"

#include <memory>
#include <mutex>

namespace limner {

struct PlanRequest {
    glm::ivec2 size{0};   ///< pixels; 0: the figure's output size
    double stepScale = 1; ///< > 1: coarser steps for a draft
    int subPixels = 0;    ///< per axis; 0: the figure's quality
    bool omit = true; ///< false: keep all but hidden layers in (`--no-omit`), to prove that leaving out changes nothing
    KeptIn kept;      ///< with `omit`: single rules that are switched off
    bool moving = false;                  ///< a frame of a drag: marks stay on the volume
    std::optional<SampleLattice> lattice; ///< instead of the figure's, for convergence studies
};

/// Derives plans from figures and keeps what successive plans share: cleaned volumes, min-max grids, atlases, distance
/// maps. One planner serves one document; calls are serialised inside.
class Planner {
  public:
    Planner();
    ~Planner();

    /// The figure's volume and styles must be resolved. Throws Error(badInput) for a figure that cannot be drawn
    /// (no volume, zero-length view direction, ...), Error(cancelled).
    std::shared_ptr<const RenderPlan> plan(const Figure& figure, const PlanRequest& request, Task& task);

  private:
    void addLayers(RenderPlan& plan, Task& task);

    struct Cache;
    std::mutex mutex_;
    std::unique_ptr<Cache> cache_;
};

} // namespace limner
