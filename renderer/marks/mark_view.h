#pragma once

#include "core/figure/view_frame.h"
#include "renderer/marks/mark_field.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <vector>

namespace limner {

/// A place of the volume as the figure's paper shows it.
struct PlaceOnPaper {
    glm::vec2 mm{0};   ///< from the top left corner
    float depthMm = 0; ///< before the target plane: larger is nearer
    float scale = 1;   ///< mm on paper per mm of the volume there; 0: behind the eye
};

/// The view that marks are drawn in, and what hides them. Immutable once made, thread-safe.
class MarkView {
  public:
    explicit MarkView(const RenderPlan& plan);

    [[nodiscard]] PlaceOnPaper place(const glm::dvec3& pointMm) const;
    /// Unit direction from a point to the eye.
    [[nodiscard]] glm::vec3 towardsEye(const glm::dvec3& pointMm) const;
    /// A direction of patient coordinates as the viewer sees it: right, up, towards the viewer.
    [[nodiscard]] glm::vec3 seen(const glm::vec3& directionMm) const;
    [[nodiscard]] const ViewFrame& frame() const { return frame_; }
    [[nodiscard]] const glm::dvec2& paperMm() const { return paperMm_; }
    /// mm on paper per mm of the volume in the target plane.
    [[nodiscard]] double scale() const { return scale_; }
    /// Whether `place` is linear in its point.
    [[nodiscard]] bool linear() const { return !(perEyeDistance_ > 0); }
    /// False for what the figure's clip cuts away.
    [[nodiscard]] bool kept(const glm::dvec3& pointMm) const;

  private:
    ViewFrame frame_;
    glm::dvec2 paperMm_;
    double scale_;
    double perEyeDistance_; ///< 0: parallel rays
    Clip clip_;
};

/// How near matter is at every place of the paper: tangent discs of the field's voxels. Independent of the picture's
/// pixels. For figures that show what is hidden it is empty, and all is visible.
class MarkDepth {
  public:
    /// Nothing hides anything.
    MarkDepth() = default;
    MarkDepth(const MarkField& field, const MarkView& view, bool matterOfLayers);

    /// 1 in front of all matter and on it, 0 some voxels behind; a smooth step between, so that a mark which goes
    /// behind something fades. `facing`: |n.e| of the surface that the mark lies on.
    [[nodiscard]] float visible(const PlaceOnPaper& place, float facing = 1) const;
    /// Whether all marks of a voxel with its middle there are out of sight.
    [[nodiscard]] bool hidesVoxel(const PlaceOnPaper& middle, float facing) const;
    /// False where all is visible.
    [[nodiscard]] bool hides() const { return !nearest_.empty(); }

    /// The cells of the paper, and what a voxel of the field does to them.
    struct Shape {
        double cellMm = 1;
        glm::ivec2 size{0};
        float toleranceMm = 1; ///< of the volume: how far behind matter is still on it, seen face-on
        float discMm = 1;      ///< radius of a voxel's disc
        float least = 0;       ///< v of matter that hides
    };
    static Shape shapeOf(const MarkField& field, const MarkView& view, bool matterOfLayers);
    /// How much the tolerance grows with a surface's slant: times 1 / |n.e| - 1, |n.e| counting as `kLeastFacing` at
    /// least.
    static constexpr float kSlantTolerance = 0.4F;
    static constexpr float kLeastFacing = 0.1F;

  private:
    [[nodiscard]] float tolerance(float facing) const;
    void addDisc(const MarkField& field, const MarkView& view, const MarkVoxel& voxel,
                 std::vector<std::uint32_t>& near);

    Shape shape_;
    std::vector<float> nearest_; ///< depth, empty: nothing hides
    float reachMm_ = 1;          ///< of a voxel's marks from its middle
};

} // namespace limner
