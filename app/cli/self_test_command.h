#pragma once

#include "app/cli/command.h"

#include <string>

namespace limner::cli {

/// `limner self-test`: the formulas on this machine's backends, against printed values or a file of test vectors.
class SelfTestCommand : public Command {
  public:
    void declare(CLI::App& app) override;
    int run(Console& console) override;

  private:
    std::string vectors_;
    std::string backend_;
};

} // namespace limner::cli
