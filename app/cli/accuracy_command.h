#pragma once

#include "app/cli/backend_options.h"
#include "app/cli/command.h"
#include "app/cli/figure_options.h"
#include "app/cli/tolerance_options.h"
#include "renderer/accuracy/study.h"

#include <string>

namespace limner::cli {

/// `limner accuracy`: error against run time of a figure, or the scenes with known results.
class AccuracyCommand : public Command {
  public:
    void declare(CLI::App& app) override;
    int run(Console& console) override;

  private:
    void checkRequest() const;
    [[nodiscard]] std::vector<accuracy::Knob> knobs() const;
    void apply(Document& document, const accuracy::Study& study, Console& console) const;

    FigureOptions figure_;
    BackendOptions backend_;
    ToleranceOptions tolerance_;
    std::string out_;
    std::string knobs_;
    double timeBudget_ = 60;
    bool apply_ = false;
    bool selfTest_ = false;
};

} // namespace limner::cli
