#pragma once

#include "core/base/task.h"
#include "renderer/backend.h"

#include <string>
#include <vector>

namespace limner::accuracy {

/// One number of an analytic scene (spec accuracy.md 1.5) or one order of convergence (1.6), as a backend has it.
struct SceneReport {
    std::string scene;    ///< "A1" to "A8"
    std::string quantity; ///< what was measured, and at which step
    double expected = 0;
    double observed = 0; ///< where several pictures give one row: the one that is farthest off
    /// |observed - expected|; of a quantity with a limit, how far beyond it. No number where there is no picture.
    double error = 0;
    double bound = 0;
    std::string reason; ///< why the bound is what it is
    bool passed = false;
};

/// Draws the scenes A1 to A8 and compares each with its closed form; a few seconds. Bounds are those of the backend's
/// arithmetic: the reference's are float32 pixels, all others' single precision along the ray. Throws Error(cancelled),
/// and what the backend throws.
std::vector<SceneReport> selfTest(const Backend& backend, Task& task);

} // namespace limner::accuracy
