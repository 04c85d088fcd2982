#pragma once

#include "core/style/extraction/tones.h"

#include <optional>
#include <vector>

namespace limner {

/// The edge that a form shows around an oval. Internal to the extraction.
struct Rim {
    Oval oval;
    double support = 0;  ///< share of the oval along which there is an edge
    double contrast = 0; ///< across it, in tones; the median where there is one
    double wobble = 0;   ///< root mean square distance of the edge from the oval, in radii
};

struct RimSearch {
    std::vector<double> reaches{0.2, 0.12, 0.06, 0.03}; ///< how far to look inward and outward in each round, in radii
    int rays = 256;
    bool circle = false; ///< keep it one
};

/// Follows the edge near a rough oval: along rays across it, the steps between what lies inside and outside; of those
/// the ring that is strong and smooth; to that ring an oval, robustly; and again from there, closer. Absent where the
/// rays find nothing that stands out, or the oval leaves the rough one far behind.
std::optional<Rim> followRim(const Tones& tones, const Oval& rough, const RimSearch& search);

} // namespace limner
