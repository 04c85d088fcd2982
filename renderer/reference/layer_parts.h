#pragma once

#include "renderer/reference/layer_optics.h"

namespace limner::reference {

/// A layer's parts beside its transfer function and the depth cues, in double (paper 003; core/optics/layers.h).

/// Where a sample lies in the face of a cut, its surface is the cut's.
void layOntoFace(const RenderPlan& plan, const PlanCut& cut, SampleFacts& facts);

/// Moves value and surface to the blur that depth of field gives the sample.
void blur(const RenderPlan& plan, const PlanFocus& focus, SampleFacts& facts);

/// Colours of faces, tone, opacity by gradient, line, highlight and tint of position over what the transfer function
/// gave; and what a cut of the layer leaves of the sample's length.
LayerSample withParts(const RenderPlan& plan, const PlanLayer& layer, const SampleFacts& facts,
                      const LayerSample& classified);

/// Ambient occlusion, shadow and halo over a layer's colour.
LayerSample withCues(const RenderPlan& plan, const SampleFacts& facts, LayerSample sample);

} // namespace limner::reference
