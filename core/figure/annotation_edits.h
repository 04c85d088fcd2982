#pragma once

#include "core/figure/figure.h"

#include <cstddef>

namespace limner {

/// Most annotations that a figure may have.
inline constexpr std::size_t kMostAnnotations = 256;

/// An annotation of a kind as it is when it is new: what can be found out by itself is left open.
Annotation newAnnotation(const std::string& kind);

/// Gives an annotation a place of its own, in figure coordinates; held on the sheet, so that it can be found again.
void placeAnnotation(Figure& figure, std::size_t index, const glm::dvec2& at);

} // namespace limner
