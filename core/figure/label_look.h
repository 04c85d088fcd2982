#pragma once

#include "core/figure/figure.h"

#include <cstddef>
#include <string>
#include <vector>

namespace limner {

/// Colours "#rrggbb" that tell neighbours in the list apart and go well together: hues a golden angle apart, in turn
/// light, dark and between, of even saturation (OKLCH, Ottosson 2020), inside sRGB. The first colours of a longer list
/// are those of a shorter one.
std::vector<std::string> distinctColours(std::size_t count);

/// Most labels that get a row of their own: with the row of all others they fit the 256 rows of a baked table.
inline constexpr std::size_t kMostLabelRows = 200;

/// The figure with these labels and one layer that draws each label that occurs in a colour of its own, the file's or
/// else one of `distinctColours`; matter without a label does not show. Of more than `kMostLabelRows` labels the
/// largest are drawn, which is noted. Camera, clips, styles and output stay. Throws Error(badInput) where the labels'
/// numbers are not loaded or none but 0 occurs.
Figure withLabels(const Figure& figure, const LabelReference& labels, std::vector<std::string>& notes);

/// Whether any layer that shows is drawn by label.
bool drawsByLabel(const Figure& figure);

} // namespace limner
