#pragma once

#include "app/cli/command.h"

namespace limner::cli {

/// `limner preset list`: the bundled presets.
class PresetListCommand : public Command {
  public:
    void declare(CLI::App& app) override;
    int run(Console& console) override;
};

/// `limner theme list`: the bundled themes.
class ThemeListCommand : public Command {
  public:
    void declare(CLI::App& app) override;
    int run(Console& console) override;
};

/// `limner figure list`: the sample figures.
class FigureListCommand : public Command {
  public:
    void declare(CLI::App& app) override;
    int run(Console& console) override;
};

} // namespace limner::cli
