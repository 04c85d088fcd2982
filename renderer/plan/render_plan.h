#pragma once

#include "core/figure/figure.h"
#include "core/style/transfer_function.h"
#include "renderer/plan/leave_out.h"
#include "renderer/plan/lenses.h"
#include "renderer/plan/planned_layer.h"
#include "renderer/plan/skip_grid.h"
#include "renderer/plan/style_atlas.h"

#include <glm/mat3x3.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace limner {

/// Rays of the whole picture in voxel coordinates (voxel centres at integers), in double. (px, py) count pixels from
/// the picture's top left corner, so pixel (x, y) has its middle at (x + 0.5, y + 0.5). The ray of (px, py) is
///   orthographic:  originVoxel + px * rightVoxel + py * downVoxel + t * forwardVoxel          (t in mm)
///   perspective:   originVoxel + s * (forwardVoxel + px * rightVoxel + py * downVoxel)        (s without unit, s > 0)
/// Orthographic rays reach behind their origin as well: there is no eye to be in front of.
struct RayFrame {
    bool perspective = false;
    glm::dvec3 originVoxel{
        0}; ///< perspective: the eye; orthographic: the picture's top left corner in the target plane
    glm::dvec3 forwardVoxel{
        0}; ///< perspective: from the eye to the top left corner in the target plane; orthographic: 1 mm along the view
    glm::dvec3 rightVoxel{0};  ///< one pixel to the right in the target plane
    glm::dvec3 downVoxel{0};   ///< one pixel down in the target plane
    glm::dmat3 eyeFromMm{1};   ///< rows: right, up, towards the viewer
    glm::dmat3 mmFromVoxel{1}; ///< the grid's matrix, to measure lengths along a ray
    glm::dmat3 eyeFromGradient{
        1}; ///< eye-space gradient (data's unit per mm) from the index gradient (stored units per voxel)
    double footprintMm = 1; ///< of one pixel in the target plane
};

/// Where samples lie on a ray: t_k = t0 + (k + phase) * step, t0 = entry of the ray into the volume's box. Sample k
/// stands for [t0 + k*step, t0 + (k+1)*step], cut at the exit and at clip planes: the last, partial one is taken.
struct SampleLattice {
    double stepMm = 0.5;
    double phase = 0.5;  ///< midpoint rule; others only for convergence studies and for comparison with peers
    double boxInset = 0; ///< voxels taken off every face of the box: 0.5 starts rays at the outermost voxel centres
};

/// How a sample chooses among the mip levels of lit spheres (core/optics/mip.h): level 0 is the atlas's finest.
struct PlanMipLevels {
    double radiusTexels = 1;    ///< R: of the picture that is right for the finest structure in the target plane
    double footprintVoxels = 1; ///< of a ray in the target plane
    double voxelMm = 1;
};

/// Upper bounds of what samples can matter, kept for bricks of the volume.
struct ImportanceBricks;

/// Marks of ink, see renderer/marks/mark_field.h.
struct PlanMarks;

/// Importance-aware composition (paper 001), ready to draw.
struct PlanImportance {
    const Importance* source = nullptr;       ///< in the plan's figure
    glm::dvec3 lightEye{0, 0, 1};             ///< unit: right, up, towards the viewer
    ValueRange intensity;                     ///< 0 and 1 of the measure
    std::vector<float> weightOfSlot;          ///< label slot -> weight of the object; empty: objects are not weighed
    std::shared_ptr<const Volume> statistics; ///< 0..1 on the volume's grid; null: not weighed
    std::vector<PlanLens> lenses;
    std::shared_ptr<const ImportanceBricks> bricks;
};

/// Numbers on a coarser grid than the scan's; cell c has its middle at voxel (c + 1/2) voxelsPerCell - 1/2. Between
/// cells trilinear, outside as at the border.
struct CueField {
    glm::ivec3 dims{0};
    int voxelsPerCell = 1;
    int channels = 1;
    std::vector<float> values; ///< x fastest, the channels of a cell side by side
};

/// Depth cues, ready to draw (core/optics/layers.h); absent fields are not drawn.
/// Ambient and shadow are read a cell out of the surface: matter must not shade the place that it is at.
struct PlanDepthCues {
    const DepthCues* source = nullptr; ///< in the plan's figure
    /// Occlusion over all directions: its mean, and the mean of occlusion times direction (patient coordinates).
    std::shared_ptr<const CueField> ambient;
    std::shared_ptr<const CueField> shadow; ///< occlusion towards the shadow's light
    glm::dvec3 lightEye{0, 0, 1};           ///< the shadow's, unit
    std::shared_ptr<const CueField> halo;   ///< 0..1
};

/// What voxels in 256 levels lose, in the data's unit, beside as many even levels.
struct PlanEightBits {
    double rmsError = 0;
    double largestError = 0;
    double rmsErrorOfEven = 0;
    double largestErrorOfEven = 0;
    std::string whyFull; ///< not empty: asked for, but the voxels are full
};

/// A part of the renderer that a figure may need.
struct PlanFeature {
    std::string name;   ///< "style", "phong", "perspective", "contours", ...
    std::string reason; ///< why it is in, or why it is not
};

/// Everything a backend needs for one figure at one size, derived by `Planner`. Immutable and shareable: what several
/// plans have in common (bricks, skip grid, atlas) is shared. What the figure does not use is not here.
struct RenderPlan {
    std::shared_ptr<const Figure> figure;
    std::shared_ptr<const Volume> volume;   ///< after clean-up; in eight bits where the figure asks for it
    std::optional<PlanEightBits> eightBits; ///< absent: not asked for
    glm::ivec2 size{0};                     ///< of the picture in pixels
    int subPixels = 1;                      ///< per axis: 1, 2 or 4
    RayFrame rays;
    SampleLattice lattice;
    double referenceLengthMm = 1; ///< d0: the smallest voxel spacing
    double earlyTermination = 0.001;
    double gradientFloor = 0; ///< data's unit per mm: below it a normal is undefined (numerics 2a)
    /// Stored units of `gradientField` per voxel: what single precision leaves of the weighted sums of equal voxels. A
    /// component up to this of Sobel's, Neumann's or the B-spline's gradient counts as 0.
    double gradientRounding = 0;
    double gradientMax = 1; ///< data's unit per mm: 99.9th percentile of |gradient|, for normalised magnitudes
    /// How values lie between voxels, never automatic; what is interpolated: the volume, or its spline coefficients.
    Interpolation interpolation = Interpolation::linear;
    std::shared_ptr<const Volume> field;
    /// How gradients are measured, never automatic, and on what: the field, the volume's spline coefficients, or thick
    /// slices blurred.
    GradientEstimator gradient = GradientEstimator::central;
    std::shared_ptr<const Volume> gradientField;
    /// The scan, smoothed, as steering points of a cubic B-spline whose derivatives give the curvature along the view;
    /// null where no layer reads it.
    std::shared_ptr<const Volume> bendField;
    std::shared_ptr<const Volume> labels;       ///< label slots on the volume's grid; null where no layer reads them
    std::shared_ptr<const Volume> secondVolume; ///< on the volume's grid; null where no layer reads it
    Clip clip;
    std::vector<PlanLayer> layers; ///< visible ones with any opacity, in drawing order
    /// A sample stands for the slab of its stretch, by integrals over the values between its ends
    /// (core/optics/preintegration.h); the lattice's phase is not asked.
    bool preintegrated = false;
    std::shared_ptr<const SkipGrid> skip;
    std::shared_ptr<const StyleAtlas> atlas;  ///< null where no layer draws a lit sphere
    std::optional<PlanImportance> importance; ///< absent: ordinary composition
    /// What the axis "importance" of transfer functions adds up: the measures of the figure's importance, whether it
    /// composes or not, but extinction and unocclusion, which opacity itself makes. Absent where no layer reads it.
    std::optional<PlanImportance> axisMeasures;
    std::optional<PlanCut> faces; ///< of the figure's cuts, where they are drawn flat; rays end at them
    std::optional<PlanDepthCues> cues;
    /// Blurred copies of the volume for depth of field (optics::kBlurLevels), int16; empty where no layer has any.
    std::vector<std::shared_ptr<const Volume>> blurs;
    std::shared_ptr<const PlanMarks> marks; ///< null: no ink
    /// Absent where all samples read the atlas's finest picture: it then has no other.
    std::optional<PlanMipLevels> mipLevels;

    KeptIn kept; ///< what stays in though it need not
    std::vector<LeftOut> leftOut;
    std::vector<PlanFeature> featuresUsed;
    std::vector<PlanFeature> featuresNotAsked; ///< the figure has no such part
    std::size_t bytes = 0;                     ///< held by the plan beyond the volume
};

/// What a picture's samples are measured for, by any layer or for their importance; or because it is kept in.
bool readsNormal(const RenderPlan& plan);
bool readsGradientScale(const RenderPlan& plan);

} // namespace limner
