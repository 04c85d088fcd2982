#pragma once

#include "renderer/accuracy/tolerance.h"

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace limner::cli {

/// How far a picture may be from the figure's own model: `--tolerance` and `--metric`.
class ToleranceOptions {
  public:
    /// `what`: what the command does with a tolerance.
    void declare(CLI::App& app, const std::string& what);

    /// What was asked for on the command line, or else by the figure. Throws Error(usage).
    [[nodiscard]] std::optional<accuracy::Tolerance> asked(const Quality& figure) const;
    /// The metric of `--metric`, or the tolerance's, or the figure's.
    [[nodiscard]] ErrorMetric metric(const Quality& figure) const;
    /// Throws Error(usage) for words and numbers that are none; before a scan is read.
    void check() const;

  private:
    std::string tolerance_;
    std::string metric_;
};

/// "CIEDE2000 0.7", "largest error 0.002", "root mean square error 0.001".
std::string toleranceText(ErrorMetric metric, double value);

} // namespace limner::cli
