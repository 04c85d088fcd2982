#pragma once

#include "renderer/plan/render_plan.h"

namespace limner {

/// What a layer's plan depends on beside the layer.
struct LayerSurroundings {
    const Figure& figure;
    const Volume& volume; ///< after clean-up
    AxisRanges ranges;
    double sampleMm = 1; ///< between neighbouring rays, in the target plane
    const RayFrame& rays;
    const KeptIn& kept;
};

/// One layer, ready to draw but for its place in the atlas, the opacity of a step and the fields it reads.
PlanLayer planLayer(const Layer& source, const LayerSurroundings& around);

bool showsAnything(const Layer& layer, const TransferTable& table);

/// Whether any of the layer's styles is a picture; the others are plain colours.
bool drawsSpheres(const PlanLayer& layer);

/// Whether its mip levels go by the curvature.
bool bendsLevels(const PlanLayer& layer);

/// Whether all nodes of its transfer function have one style, or one plain colour.
bool hasOneColour(const PlanLayer& layer);

/// Where, over the volume's stored range, any of the layers can show.
VisibleRange visibleRange(const std::vector<PlanLayer>& layers, const Volume& volume);

} // namespace limner
