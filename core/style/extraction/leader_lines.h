#pragma once

#include "core/style/extraction/ink_marks.h"

#include <vector>

namespace limner {

/// Pixels of the plane, ends on the line's middle.
struct LeaderLine {
    glm::dvec2 from{0, 0};
    glm::dvec2 to{0, 0};
    double width = 0; ///< of its ink
};

/// Long straight thin lines of ink with nothing beside them, as far as they go on over a form, dashes too. Hatching has
/// more of its kind beside it; an outline has its form. On paper a line needs less to be one where it begins beside a
/// letter (places in `letters`) or comes in from beyond the picture. Internal to the extraction.
std::vector<LeaderLine> leaderLinesOf(const InkPlane& plane, const std::vector<glm::dvec2>& letters);

} // namespace limner
