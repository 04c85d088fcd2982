#pragma once

#include "app/cli/command.h"
#include "app/cli/figure_options.h"

#include <string>

namespace limner::cli {

/// `limner new`: a project from a scan and a preset.
class NewCommand : public Command {
  public:
    void declare(CLI::App& app) override;
    int run(Console& console) override;

  private:
    FigureOptions figure_;
    std::string out_;
    bool embed_ = false;
};

} // namespace limner::cli
