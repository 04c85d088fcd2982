#pragma once

#include "core/base/task.h"
#include "core/figure/figure.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace limner::cli {

/// How much of the picture each layer, label and range of values makes, at the figure's importance and at other global
/// weights; from a small picture. Throws as the planner does.
nlohmann::ordered_json visibilityFacts(const Figure& figure, Task& task);

/// The same facts as a table.
std::string visibilityText(const nlohmann::ordered_json& facts);

} // namespace limner::cli
