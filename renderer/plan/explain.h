#pragma once

#include "core/base/task.h"
#include "renderer/backend.h"
#include "renderer/plan/planner.h"

#include <cstdint>
#include <string>
#include <vector>

namespace limner {

/// What one part of making a picture costs.
struct PartCost {
    std::string name; ///< "clean-up", "tables", "skip grid", "styles", "rendering"
    double estimatedMs = 0;
    double measuredMs = 0;
    std::uint64_t bytes = 0; ///< held
};

/// What a figure uses and what that costs, on this machine.
struct Explanation {
    std::vector<PlanFeature> used;
    std::vector<PlanFeature> notAsked;    ///< parts that the figure has not
    std::vector<LeftOut> leftOut;         ///< what the picture does not need
    std::vector<std::string> fields;      ///< read per sample: "value", "gradient", "labels"
    std::vector<std::string> annotations; ///< what is written over the picture, one line each
    std::vector<PartCost> parts;
    double planningMs = 0;      ///< the first plan as a whole, measured
    double occupied = 0;        ///< share of the blocks that rays cannot skip
    glm::ivec2 probe{0};        ///< pixels of the probe that rendering was measured on
    double samplesPerPixel = 0; ///< of the probe
    std::string backend;

    [[nodiscard]] std::uint64_t bytes() const;
    [[nodiscard]] double estimatedMs() const;
    [[nodiscard]] double measuredMs() const;
};

/// Plans the figure, times each part once, and renders a small probe from the middle of the picture.
Explanation explainFigure(const Figure& figure, const PlanRequest& request, const Backend& backend, Task& task);

} // namespace limner
