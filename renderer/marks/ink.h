#pragma once

#include "core/base/task.h"
#include "renderer/marks/mark_view.h"
#include "renderer/marks/marks.h"

#include <vector>

namespace limner {

/// What a mark voxel asks for in one view (core/optics/stipple.h).
struct VoxelInk {
    PlaceOnPaper at;
    float tone = 0;     ///< product of the factors, in [0, 1]; 0: nothing is drawn
    float dots = 0;     ///< expected number
    float radiusMm = 0; ///< of the dots, on paper
    float facing = 0;   ///< |n.e|
};

/// Factors that a figure has but that are 1 at every voxel.
struct IdleFactors {
    bool distance = false;
    bool interior = false;
};
IdleFactors idleFactors(const Stipple& stipple);

/// A figure's marks at work in one view.
struct MarkScene {
    const RenderPlan& plan;
    const Stipple& stipple;
    const MarkField& field;
    MarkView view;
    MarkDepth depth;
    std::vector<VoxelInk> ink;      ///< parallel to the field's voxels
    std::vector<InkColour> colours; ///< the same where ink takes the styles' colours; else empty
    bool moving = false;

    [[nodiscard]] InkColour colourOf(std::size_t voxel) const { return colours.empty() ? plain : colours[voxel]; }
    InkColour plain{0};
};

/// Everything but the marks themselves. `field`, `plan` and the figure in it outlive the scene.
MarkScene makeMarkScene(const RenderPlan& plan, const MarkField& field, bool moving, Task& task);

/// What the dots of all voxels have in common in one view.
struct InkView {
    float wholeScale = 1;  ///< mm on paper per mm of the volume from where all of it just shows
    float halfDepth = 0;   ///< of the volume along the view, mm
    float centreDepth = 0; ///< of the volume's middle
    glm::vec3 light{0};    ///< as the viewer sees it; 0: the figure's dots are not lit
    double density =
        0; ///< dots of a surface that faces the viewer and asks for full tone, by their areas: k_max, or less
    double perFace = 0; ///< dots' areas in a voxel's face, were a mm of it one on paper
    bool facingOnly = true;
    IdleFactors idle;
};
InkView inkView(const RenderPlan& plan, const MarkField& field, const MarkView& view, Task& task);

/// Opacity of layers from which there are marks, and from which marks are whole: what hardly shows is not drawn.
inline constexpr float kFaintMatter = 0.2F;
inline constexpr float kFullMatter = 0.6F;
/// A tone of 1 would ask for dots without end.
inline constexpr double kFullestTone = 0.985;

/// The colour of ink that has one.
InkColour plainInk(const Stipple& stipple);

/// Area of the largest dot, mm^2 of paper.
double largestDotArea(const Stipple& stipple);

/// What a figure's seed makes of chance.
inline std::uint32_t seedBits(const Stipple& stipple) { return static_cast<std::uint32_t>(stipple.seed) * 0x9e3779b9U; }

/// The dots of all voxels, one group a layer: on the volume, or evenly on paper.
void addDotsOnVolume(const MarkScene& scene, Marks& marks, Task& task);
void addDotsOnPaper(const MarkScene& scene, Marks& marks, Task& task);

/// Dots are no smaller than this share of the largest: there are fewer of them instead.
inline constexpr float kSmallestDot = 0.6F;

} // namespace limner
