#pragma once

#include "core/base/task.h"
#include "renderer/plan/render_plan.h"

#include <map>
#include <string>
#include <vector>

namespace limner {

/// How much of a picture each part of a figure makes: the weight that its samples have in the pixels, as a mean over
/// the picture. With the paper's the layers' shares add up to 1; so do the labels' and the ranges'.
struct VisibilityShares {
    struct Range {
        double low;
        double high; ///< in the data's unit
        double share;
    };
    std::vector<std::pair<std::string, double>> layers; ///< by name, as the plan's
    std::map<int, double> labels;                       ///< where the figure has labels; 0: none of them
    std::vector<Range> ranges;                          ///< of the data's values, low to high
    double paper = 0;
};

/// Measured in double on the plan's own pixels: ask for a picture of some 64. Throws Error(cancelled).
VisibilityShares measureVisibility(const RenderPlan& plan, Task& task);

} // namespace limner
