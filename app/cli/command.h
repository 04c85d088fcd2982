#pragma once

#include <string>

namespace CLI {
class App;
}

namespace limner::cli {

class Console;

/// One command of the program: declares its options, then runs with what was given.
class Command {
  public:
    virtual ~Command() = default;
    /// Adds options, help and examples to the command's own parser.
    virtual void declare(CLI::App& app) = 0;
    /// Returns the exit code. Throws Error.
    virtual int run(Console& console) = 0;
};

} // namespace limner::cli
