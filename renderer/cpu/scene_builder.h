#pragma once

#include "renderer/cpu/kernel_scene.h"
#include "renderer/plan/render_plan.h"

#include <deque>
#include <vector>

namespace limner {

/// A KernelScene with the tables it points into. Refers to the plan, which must outlive it.
class BuiltScene {
  public:
    explicit BuiltScene(const RenderPlan& plan);
    BuiltScene(const BuiltScene&) = delete;
    BuiltScene& operator=(const BuiltScene&) = delete;

    [[nodiscard]] const KernelScene& scene() const { return scene_; }

  private:
    void setVolume(const RenderPlan& plan);
    void setRays(const RenderPlan& plan);
    void addPlane(const RenderPlan& plan, const ClipPlane& plane);
    void setClip(const RenderPlan& plan);
    void setTables(const RenderPlan& plan);
    void addLayer(const RenderPlan& plan, const PlanLayer& layer);
    static glm::dvec3 nodeColour(const PlanLayer& layer, double index);
    void addColours(const PlanLayer& layer, KernelLayer& out);
    const float* keep(std::vector<float> table);

    KernelScene scene_;
    std::vector<KernelLayer> layers_;
    std::deque<std::vector<float>> tables_; // a deque: addresses stay
    std::deque<std::vector<std::int32_t>> slots_;
    struct alignas(16) Colour {
        float rgba[4];
    };
    std::deque<std::vector<Colour>> colours_;
    std::vector<float> means_;
};

} // namespace limner
