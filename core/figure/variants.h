#pragma once

#include "core/figure/figure.h"

#include <string>
#include <vector>

namespace limner {

/// A figure beside others that differ from it in one thing, for a sheet to choose from.
struct Variant {
    std::string name; ///< short, for people
    Figure figure;
};

/// A number of the figure that is there now and may be varied.
struct VariedSetting {
    std::string pointer; ///< "/layers/0/contours/thickness_mm"
    std::string label;   ///< "Bone: Thickness"
    std::string unit;
    double now = 0;
    double from = 0; ///< a range worth trying, around what it is now; legal
    double to = 1;
};

/// The figure's numbers that make a difference to the picture, those of layers with the layer's name. Positions in
/// space, sizes of the output and what stands in lists inside lists (curves, polygons) are left out.
std::vector<VariedSetting> variedSettings(const Figure& figure);

/// `count` >= 2 figures with the setting at even steps from `from` to `to`, both included.
std::vector<Variant> variantsOf(const Figure& figure, const VariedSetting& setting, int count);

} // namespace limner
