#pragma once

#include "core/base/task.h"
#include "core/figure/figure.h"

#include <glm/vec2.hpp>

#include <string>
#include <vector>

namespace limner::cli {

/// How much of a small picture each part of a figure makes, at its importance and at other global weights.
struct VisibilityTable {
    struct Row {
        std::string kind; ///< "layer", "label", "values", "paper"
        std::string name;
        std::vector<double> shares; ///< one for each weight; the layers' and the paper's add up to 1
    };
    glm::ivec2 pixels{0};
    std::vector<double> globalWeights; ///< 0 alone for a figure without importance
    std::vector<Row> rows;
};

/// Throws as the planner does.
VisibilityTable visibilityTable(const Figure& figure, Task& task);

std::string visibilityText(const VisibilityTable& table);

} // namespace limner::cli
