#pragma once

#include "core/base/task.h"
#include "renderer/plan/plan_fields.h"

#include <tuple>

namespace limner {

/// Occlusion of every cell of an opacity field by what lies in the direction `towardsMm` (unit, patient coordinates),
/// beyond the cell itself; what is at a distance s counts exp(-s / reachMm) (infinite reach: all the same). One sweep
/// over the slices along the direction's main axis. One channel.
std::vector<float> occlusionTowards(const CueField& opacity, const Grid& grid, const glm::dvec3& towardsMm,
                                    double reachMm);

/// Whether a figure's depth cues go by the direction of surfaces.
bool readNormals(const std::optional<DepthCues>& cues);

/// How finely halos and shadows are measured: a draft must not wait for them.
enum class CueDetail { draft, still };

/// Fills in a plan's depth cues and keeps what their fields were made from.
class DepthCueFields {
  public:
    /// Absent where the figure has none with any strength. After the plan's layers, fields and gradient scale.
    void add(RenderPlan& plan, CueDetail detail, Task& task);

  private:
    using Field = std::shared_ptr<const CueField>;
    /// What opacity depends on: the scan, labels, layers, what is cut away, the view where layers fade along it, the
    /// cell.
    using OpacityKey = std::tuple<std::shared_ptr<const Volume>, std::shared_ptr<const Volume>, std::vector<Layer>,
                                  Clip, glm::dvec3, int>;
    const Field& opacity(const RenderPlan& plan, int mostCells, Task& task);

    RecentResults<OpacityKey, Field> opacities_{3}; ///< sizes of cells
    RecentResults<std::pair<Field, double>, Field> ambient_;
    RecentResults<std::tuple<Field, glm::dvec3, double, double>, Field> shadow_{2}; ///< of draft and still
    RecentResults<std::tuple<Field, glm::dvec3, double, double>, Field> halo_{2};
};

} // namespace limner
