#pragma once

#include "core/style/extraction/extract.h"

#include <string>
#include <vector>

namespace limner {

/// What an extraction's figures mean, in plain words.
struct Verdict {
    std::string form;                ///< one clause: "the outline sits on the edge"; empty where nothing is known
    std::vector<std::string> advice; ///< a sentence for each figure that is bad, with what to do about it
};
/// `region`: the form is a region, not a ball.
Verdict verdictOf(const ExtractionFigures& figures, bool region);

} // namespace limner
