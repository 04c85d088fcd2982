#pragma once

#include "app/cli/backend_options.h"
#include "app/cli/command.h"
#include "app/cli/figure_options.h"

#include <string>

namespace limner::cli {

/// `limner explain`: what a figure uses, what it leaves out, and what that costs.
class ExplainCommand : public Command {
  public:
    void declare(CLI::App& app) override;
    int run(Console& console) override;

  private:
    FigureOptions figure_;
    BackendOptions backend_;
    bool visibility_ = false;
    bool savings_ = false;
};

} // namespace limner::cli
