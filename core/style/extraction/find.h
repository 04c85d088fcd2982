#pragma once

#include "core/style/extraction/artwork.h"
#include "core/style/extraction/forms.h"

#include <optional>
#include <vector>

namespace limner {

/// Finding things on an artwork. All functions take a cut and give places on the artwork; none throws but
/// Error(cancelled).

struct RoundThing {
    Ellipse ellipse;
    double score = 0; ///< 0..1: how round, how well edged and how shaded it is
};

/// Round shaded things, best first, at most `most`, none much inside another: Hough circles, and ellipses fitted to
/// closed contours, each snapped to the edge.
std::vector<RoundThing> findRoundThings(const ArtCut& cut, Task& task, std::size_t most = 12);

/// The ellipse that follows the picture's edge near the rough one (within a fifth of its size); absent where there is
/// no edge to follow.
std::optional<Ellipse> snapEllipse(const ArtCut& cut, const Ellipse& rough);

/// The form that a rough lasso means, by GrabCut: over the cut's own pixels, at most the lasso's inside and a little
/// more. Empty where nothing stands out.
Mask refineRegion(const ArtCut& cut, const ArtPath& lasso, Task& task);

/// Printed letters and leader lines over a plate, over the cut's own pixels: thin strokes of the darkest (or, on dark
/// grounds, lightest) ink in rows of like-sized marks, and long straight lines that stand alone. Hatching stays.
Mask findLettering(const ArtCut& cut);

} // namespace limner
