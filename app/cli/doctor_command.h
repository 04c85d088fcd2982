#pragma once

#include "app/cli/command.h"

namespace limner::cli {

/// `limner doctor`: what this machine draws with; what to put into a report of a fault.
class DoctorCommand : public Command {
  public:
    void declare(CLI::App& app) override;
    int run(Console& console) override;
};

} // namespace limner::cli
