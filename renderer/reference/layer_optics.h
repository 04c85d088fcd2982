#pragma once

#include "core/optics/shading.h"
#include "renderer/plan/render_plan.h"
#include "renderer/reference/ray.h"

#include <utility>
#include <vector>

namespace limner::reference {

/// The surface at a sample, as shading reads it.
struct SurfaceSample {
    optics::Vector3<double> normalRay{0, 0, 1}; ///< unit, in the frame of the ray; before any flip to the viewer
    glm::dvec3 normalMm{0};                     ///< unit, in patient coordinates
    double definedness = 0;                     ///< 0: no normal, 1: a sound one
    double magnitude = 0;                       ///< of the gradient, over the plan's gradientMax
    double bend = 0;                            ///< curvature along the view by the Hessian, 1/mm
};

/// What the layers read at one sample.
struct SampleFacts {
    double value = 0;
    glm::dvec3 positionVoxel{0};       ///< past an axis' last centre: moved onto it, as for the fields
    glm::dvec3 directionEye{0, 0, -1}; ///< of the ray, unit
    glm::dvec3 directionMm{0, 1, 0};   ///< the same in patient coordinates
    double lengthMm = 0;               ///< that the sample stands for
    double depth = 1; ///< distance along the view over the target's; 1 throughout in orthographic views
    SurfaceSample surface;
    std::vector<std::pair<double, double>> turns; ///< by their distance, mm: curvature by two normals on the ray, 1/mm
    std::vector<std::pair<int, double>>
        membership; ///< label slot and its trilinear weight; empty: no layer reads labels
    /// Faces of cuts that the sample lies in and that have a colour of their own: how far, and the colour.
    std::vector<std::pair<double, glm::dvec3>> faces;
};

/// Measures what the plan's layers read, and nothing else.
SampleFacts sampleFacts(const RenderPlan& plan, const Ray& ray, const Segment& segment, double value);

/// The surface where the gradient is the given one, in eye space.
SurfaceSample surfaceOf(const RenderPlan& plan, const glm::dvec3& directionEye, const glm::dvec3& gradientEye);

/// Colour and opacity of one layer at one sample.
struct LayerSample {
    optics::Colour<double> colour{0, 0, 0};
    double opacity = 0;     ///< of the plan's reference length
    double lengthRatio = 0; ///< that the layer has of the sample, over the reference length
};

/// Opacity of the reference length at a data value, the layer's own included, before any directional one; in [0, 1].
/// For layers whose transfer function has one dimension, over the value.
double opacityOf(const PlanLayer& layer, double value);

/// Nodes of the layer's transfer function at a sample, counted as `StyleIndex::nodeToStyle` counts them, with their
/// shares of the colour. They add up to 1; nothing where the layer is clear because of a label.
std::vector<std::pair<int, double>> nodesAt(const RenderPlan& plan, const PlanLayer& layer, const SampleFacts& facts);

/// The full law.
LayerSample shadeLayer(const RenderPlan& plan, const PlanLayer& layer, const SampleFacts& facts);

} // namespace limner::reference
