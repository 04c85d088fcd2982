#pragma once

#include <string>

namespace limner::cli {

class Console;

/// `limner accuracy --self-test`: the analytic scenes A1 to A8 with what is expected and observed, on every backend
/// that works here or on the one that is named. Returns the exit code: 9 where one fails, 4 where gl is asked for and
/// is not here.
int runSceneTest(const std::string& backend, Console& console);

} // namespace limner::cli
