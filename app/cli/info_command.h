#pragma once

#include "app/cli/command.h"
#include "app/cli/figure_options.h"

namespace limner::cli {

/// `limner info`: what a scan or a project holds.
class InfoCommand : public Command {
  public:
    void declare(CLI::App& app) override;
    int run(Console& console) override;

  private:
    FigureOptions figure_;
};

} // namespace limner::cli
