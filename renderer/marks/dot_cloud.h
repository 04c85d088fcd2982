#pragma once

#include "core/base/task.h"
#include "renderer/marks/mark_view.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace limner {

/// A dot on the volume that a view may draw: whether it does is a matter of its rank and of the count of its voxel.
struct DotCandidate {
    glm::vec2 onFace{0};     ///< in edges of the voxel's face from its middle (volume_dots.h)
    std::uint32_t voxel = 0; ///< of DotCloud::voxels
    std::uint32_t order = 0; ///< its rank times 65536 in the upper half, its chance (FacePoint::random) in the lower
};

/// All dots on the volume that any view from no nearer than `headroom` says may draw: what a graphics card is given
/// once and draws from as the volume turns. Immutable, thread-safe.
struct DotCloud {
    std::vector<std::uint32_t> voxels;           ///< of the field's, those that draw a surface
    std::vector<std::vector<DotCandidate>> dots; ///< in parts, voxel by voxel
    double headroom = 1; ///< factor on the field's own scale up to which there are enough of them

    [[nodiscard]] std::size_t dotCount() const;
};

/// The headroom that a view needs: powers of the fourth root of 2, the same for every direction in which parallel rays
/// or a camera that circles the volume looks. 0: the eye is too near.
double dotHeadroom(const RenderPlan& plan, const MarkField& field, const MarkView& view);

/// `density`: of InkView. Null where there are more than `most` dots. Parallel, deterministic. Throws Error(cancelled).
std::shared_ptr<const DotCloud> makeDotCloud(const Stipple& stipple, const MarkField& field, double density,
                                             double headroom, std::size_t most, Task& task);

} // namespace limner
