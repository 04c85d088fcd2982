#pragma once

#include "core/base/task.h"
#include "renderer/backend.h"
#include "renderer/plan/planner.h"

#include <cstdint>
#include <string>
#include <vector>

namespace limner::accuracy {

/// What one rule of leaving out saves a picture.
struct Saving {
    LeftOut leftOut;
    double keptMs = 0;      ///< of the picture with this rule alone switched off
    double ms = 0;          ///< that over the picture with all rules; below 0: nothing but the clock's noise
    std::int64_t bytes = 0; ///< held more without the rule
};

/// What a figure's picture costs with and without leaving out (spec accuracy.md 1.10).
struct Savings {
    std::string backend;
    glm::ivec2 pixels{0}; ///< that were drawn: the picture, or its middle where it is large
    int rounds = 0;       ///< of each measurement; the least time counts
    double ms = 0;        ///< of the picture as it is drawn
    std::uint64_t bytes = 0;
    std::vector<Saving> rules; ///< those at work, each on its own
    double keptMs = 0;         ///< with none of them
    std::uint64_t keptBytes = 0;

    /// Of the rules; they overlap, so that it is not what all of them save together.
    [[nodiscard]] double sumMs() const;
    [[nodiscard]] std::int64_t sumBytes() const;
};

/// Plans the figure as it is, with each rule at work switched off, and with all of them off, and draws all of these by
/// turns for some seconds. Throws as the planner and the backend do, and Error(cancelled).
Savings measureSavings(const Figure& figure, const Backend& backend, const PlanRequest& request, Task& task);

} // namespace limner::accuracy
