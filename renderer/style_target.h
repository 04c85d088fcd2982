#pragma once

#include "renderer/plan/render_plan.h"

#include <cstddef>
#include <optional>

namespace limner {

/// What a style that is laid down at a place of the picture would go onto.
struct StyleTarget {
    std::size_t layer = 0; ///< of the plan's figure: the one that makes most of what is seen there
    /// Whose look makes most of that layer there: a node of its transfer function, or a cell of its grid counted row by
    /// row. Absent where the layer has neither.
    std::optional<std::size_t> node;
    double value = 0; ///< the data's, in its unit: half of what is seen there of the node lies below
    /// The data's values that are meant. A line over the value: from the middle between the node and the one before to
    /// that between it and the next, no farther than the layer is visible. Else those that are seen there.
    ValueRange range;
    double share = 0; ///< of the pixel that is the layer's, importance counted; 0..1
    friend bool operator==(const StyleTarget&, const StyleTarget&) = default;
};

/// Decides by the ray through a point of the plan's picture (pixels from the top left corner). Nothing where hardly
/// anything is seen but paper. In double: some milliseconds, through much haze some tens of them; thread-safe.
std::optional<StyleTarget> styleTarget(const RenderPlan& plan, const glm::dvec2& positionPixel);

/// How many nodes, or cells, a layer's style can be told for. 0: it has none yet.
std::size_t styleNodes(const Transfer& transfer);

/// The figure as a map of where a layer is seen, or one of its nodes: those are red, all other matter is green, with
/// the figure's own opacities and light left out. In its picture r / (r + g) is the share that is meant.
Figure targetMap(const Figure& figure, std::size_t layer, std::optional<std::size_t> node);

} // namespace limner
