#pragma once

#include "core/optics/shading.h"
#include "renderer/plan/render_plan.h"

namespace limner::reference {

/// The gradient at a sample, as shading reads it.
struct SurfaceSample {
    optics::Vector3<double> normalRay{0, 0, 1}; ///< unit, in the frame of the ray; before any flip to the viewer
    double definedness = 0;                     ///< 0: no normal, 1: a sound one
};

SurfaceSample surfaceSample(const RenderPlan& plan, const glm::dvec3& gradientIndex, const glm::dvec3& rayEye);

/// Colour and opacity of one layer at one sample.
struct LayerSample {
    optics::Colour<double> colour{0, 0, 0};
    double opacity = 0; ///< of the plan's reference length
};

/// Whether a layer's colour or opacity depends on the normal.
bool readsNormal(const PlanLayer& layer);

/// Opacity of the reference length at a data value, the layer's own included, before any directional one; in [0, 1].
double opacityOf(const PlanLayer& layer, double value);

/// The full law at a value: `opacity` is opacityOf(layer, value).
LayerSample shadeLayer(const PlanLayer& layer, double value, double opacity, const SurfaceSample& surface);

} // namespace limner::reference
