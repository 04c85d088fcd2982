#pragma once

#include "app/cli/command.h"

#include <string>

namespace limner::cli {

/// `limner validate`: every problem of a figure, with its place and the mend.
class ValidateCommand : public Command {
  public:
    void declare(CLI::App& app) override;
    int run(Console& console) override;

  private:
    std::string file_;
};

} // namespace limner::cli
