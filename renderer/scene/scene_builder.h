#pragma once

#include "renderer/plan/importance_bricks.h"
#include "renderer/plan/render_plan.h"
#include "renderer/scene/kernel_scene.h"

#include <deque>
#include <optional>
#include <vector>

namespace limner {

inline constexpr glm::dvec3 kCellFromVoxel{1}; ///< cell coordinate = voxel coordinate + 1

/// A vector as the kernel keeps it.
template <typename Number>
void copyTo(const glm::dvec3& from, Number* to) {
    for (int i = 0; i < 3; ++i) {
        to[i] = static_cast<Number>(from[i]);
    }
}

/// A KernelScene with the tables it points into. Refers to the plan, which must outlive it.
class BuiltScene {
  public:
    explicit BuiltScene(const RenderPlan& plan);
    BuiltScene(const BuiltScene&) = delete;
    BuiltScene& operator=(const BuiltScene&) = delete;

    [[nodiscard]] const KernelScene& scene() const { return scene_; }
    /// With importance-aware composition only.
    [[nodiscard]] const std::optional<ImportanceAhead>& ahead() const { return ahead_; }

  private:
    void setVolume(const RenderPlan& plan);
    void setRays(const RenderPlan& plan);
    void addPlane(const RenderPlan& plan, const ClipPlane& plane);
    void setClip(const RenderPlan& plan);
    void setTables(const RenderPlan& plan);
    void setGradients(const RenderPlan& plan);
    void setBends(const RenderPlan& plan);
    void setMeasures(const PlanImportance& from, KernelImportance& out) const;
    void setImportance(const RenderPlan& plan);
    void setGap(const std::vector<float>& visibility);
    void setValueTable(const RenderPlan& plan, std::vector<float> visibility);
    /// Range and number of a table's entries along an axis.
    struct AxisEntries {
        double low;
        double high;
        std::int64_t count;
    };
    [[nodiscard]] KernelAxis axis(const RenderPlan& plan, const PlanLayer& layer, TransferAxis which,
                                  const AxisEntries& entries) const;
    void addTransfer(const RenderPlan& plan, const PlanLayer& layer, KernelLayer& out);
    void addLook(const RenderPlan& plan, const PlanLayer& layer, KernelLayer& out);
    void addColours(const PlanLayer& layer, KernelLayer& out);
    void addParts(const RenderPlan& plan, const PlanLayer& layer, KernelLayer& out);
    const KernelCut* addCut(const RenderPlan& plan, const PlanCut& cut);
    void setBlurs(const RenderPlan& plan);
    void setCues(const RenderPlan& plan);
    const float* keepColours(const std::vector<glm::vec4>& table);
    const float* keep(std::vector<float> table);

    KernelScene scene_;
    std::int64_t valueEntries_ = 2; ///< of the table that `KernelScene::visibility` is
    double firstValue_ = 0;         ///< of that table, in the data's unit
    double valuePerEntry_ = 0;
    std::optional<ImportanceAhead> ahead_;
    std::vector<KernelLayer> layers_;
    std::deque<std::vector<float>> tables_; // a deque: addresses stay
    std::deque<std::vector<std::int32_t>> slots_;
    std::deque<std::vector<KernelTexture>> textures_;
    struct alignas(16) Colour {
        float rgba[4];
    };
    std::deque<std::vector<Colour>> colours_;
    std::deque<KernelCut> cuts_;
    std::vector<float> means_;
};

} // namespace limner
