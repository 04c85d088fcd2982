#pragma once

#include "core/figure/figure.h"

#include <functional>
#include <string>
#include <vector>

namespace limner::testing {

/// Small smooth scenes for comparing backends: every transfer function, contour and estimator that a figure may ask
/// for. The fields have no edge finer than some voxels, so that what differs is the backends' own doing.

/// How a smooth scene keeps its voxels and how it is seen.
struct SmoothScene {
    VoxelType type = VoxelType::float32;
    Projection projection = Projection::orthographic;
    glm::ivec3 dims{30, 34, 32};
    bool falling = false; ///< stored numbers rise where values fall; integer voxels only
};

/// A lumpy ball with values from 0 to 1.15 on an oblique grid of 1 x 1.25 x 0.8 mm, labels 0, 3 and 7 on the same grid,
/// a second scan on a coarser straight one, styles "a", "b" and "c" (with transparent directions), and one flat layer.
Figure smoothFigure(const SmoothScene& scene);

/// The same scan's labels on a grid of their own, coarser and turned.
void moveLabelsToAnotherGrid(Figure& figure);

/// Makes the layer two-dimensional: a node grid over both axes, styles and colours mixed where it is shaded by styles,
/// and one soft trapezoid over the axes' usual ranges.
void makePlane(Layer& layer, const std::string& first, const std::string& second);
/// Makes the layer one-dimensional over the axis: nodes and curve over its usual range.
void makeLine(Layer& layer, const std::string& axis);

/// One thing that a figure may ask for, alone.
struct TransferFeature {
    std::string name;
    std::function<void(Figure&)> apply;
    bool onEntries = true; ///< opacity is linear between knots, so that tables with these as entries are exact
};
const std::vector<TransferFeature>& transferFeatures();

/// A figure of one to three layers that asks for much at a time; the same for the same seed.
Figure randomFigure(unsigned seed);

/// A random soft shape over the usual ranges of two axes.
OpacityShape randomShape(unsigned seed, const std::string& first, const std::string& second);

} // namespace limner::testing
