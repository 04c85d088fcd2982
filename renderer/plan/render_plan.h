#pragma once

#include "core/figure/figure.h"
#include "core/style/transfer_function.h"
#include "renderer/plan/lenses.h"
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

/// A layer's contours, ready to draw.
struct PlanContours {
    bool curvatureControlled = true;
    CurvatureEstimator curvature = CurvatureEstimator::hessian;
    double thicknessMm = 0; ///< of the pen in the target plane, on the object
    double probeMm = 1;     ///< CurvatureEstimator::normals: distance between the two
    /// Not controlled: where contours end, |n.v|: as on a ball of kUncontrolledRadiusMm on paper.
    double fixedWidth = 0;
};

/// Radius, mm on paper, of the ball on which contours that do not follow the curvature have their asked width.
inline constexpr double kUncontrolledRadiusMm = 10;

/// A style's texture, ready to draw; without a tile: none.
struct PlanTexture {
    std::shared_ptr<const TextureTile> tile; ///< no finer than a pixel
    double perMm = 1;                        ///< tiles
    double strength = 0;
};

/// How a sample chooses among the mip levels of lit spheres (core/optics/mip.h): level 0 is the atlas's finest.
struct PlanMipLevels {
    double radiusTexels = 1;    ///< R: of the picture that is right for the finest structure in the target plane
    double footprintVoxels = 1; ///< of a ray in the target plane
    double voxelMm = 1;
};

/// One visible layer, ready to draw.
struct PlanLayer {
    std::string name;
    const Layer* source = nullptr; ///< in the plan's figure: what the reference evaluates
    Shading shading = Shading::style;
    bool twoSided = true;
    bool illustrative = false; ///< transparency by the 100-percent rule
    Specular specular;         ///< Phong's
    std::optional<PlanContours> contours;
    TransferTable table;
    std::vector<float> stepOpacity; ///< of one whole step of the plan's lattice, entries as the table's
    StyleIndex styles;
    /// Parallel to `styles.styles`, at the plan's resolution; empty where none of them has one.
    std::vector<PlanTexture> textures;
    std::vector<int> atlasSlots; ///< distinct style -> slot of the atlas; empty unless shading is style with a sphere
    std::vector<std::uint8_t> shownSlots;     ///< label slot -> 1 where the label shows; empty: all show
    std::vector<std::int16_t> rowOfSlot;      ///< label slot -> row of the table, -1: none; empty: no label axis
    std::shared_ptr<const Volume> distance;   ///< axis "distance" from a label: mm; else null
    std::optional<glm::dvec3> distanceFromMm; ///< axis "distance" from a point
};

/// What a layer's evaluation reads beside the value.
bool readsNormal(const PlanLayer& layer);
/// Whether it asks how large a gradient is, beside its direction.
bool readsGradientScale(const PlanLayer& layer);
bool readsCurvature(const PlanLayer& layer);
/// Curvature by second derivatives: an axis always, contours by their choice.
bool readsSecondDerivatives(const PlanLayer& layer);
bool readsLabels(const PlanLayer& layer);
/// Whether a sample's opacity follows from its value alone, so that it is known before the sample is shaded.
bool opacityByValue(const PlanLayer& layer);
/// Whether the layer's transfer function reads an axis.
bool readsAxis(const PlanLayer& layer, TransferAxis axis);

/// Upper bounds of what samples can matter, kept for bricks of the volume.
struct ImportanceBricks;

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
    std::string reason; ///< why it is in, or why it was left out
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
    std::shared_ptr<const SkipGrid> skip;
    std::shared_ptr<const StyleAtlas> atlas;  ///< null where no layer draws a lit sphere
    std::optional<PlanImportance> importance; ///< absent: ordinary composition
    /// Absent where all samples read the atlas's finest picture: it then has no other.
    std::optional<PlanMipLevels> mipLevels;

    std::vector<PlanFeature> featuresUsed;
    std::vector<PlanFeature> featuresLeftOut;
    std::vector<std::string> notDrawn; ///< figure parts that this version keeps but does not draw, one line each
    std::size_t bytes = 0;             ///< held by the plan beyond the volume
};

/// What a picture's samples are measured for, by any layer or for their importance.
bool readsNormal(const RenderPlan& plan);
bool readsGradientScale(const RenderPlan& plan);

} // namespace limner
