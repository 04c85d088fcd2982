#pragma once

#include "core/figure/annotation_layout.h"

namespace limner::label_places {

/// The ways of laying labels out. Internal to annotation_layout.cpp.

struct Scene {
    const LabelSheet& sheet;
    std::span<const LabelBox> labels;
};

/// The box of a label whose leader ends at `port`, to the left or the right of it.
PlacedLabel besidePort(const LabelBox& label, const glm::dvec2& port, bool toTheLeft);

/// Columns at the left and right edges for the labels in `free`; `placed` holds the places of the others already.
void layColumns(const Scene& scene, std::span<const std::size_t> free, std::vector<PlacedLabel>& placed);

/// An ellipse as large as the sheet allows. False where boxes overlap or leaders cross.
bool layRing(const Scene& scene, std::span<const std::size_t> free, std::vector<PlacedLabel>& placed);

/// Each label beside its point, as near as it can be without overlaps and crossings. False where one found no place.
bool layFree(const Scene& scene, std::span<const std::size_t> free, std::vector<PlacedLabel>& placed);

/// Whether a label at its place overlaps with or crosses any of `others`, or what is taken.
bool disturbs(const Scene& scene, std::size_t label, std::span<const std::size_t> others,
              const std::vector<PlacedLabel>& placed);

} // namespace limner::label_places
