#pragma once

#include "app/cli/command.h"
#include "app/cli/style_words.h"

#include <string>
#include <vector>

namespace limner::cli {

/// `limner style add`: pictures of shaded balls join the user's styles.
class StyleAddCommand : public Command {
  public:
    void declare(CLI::App& app) override;
    int run(Console& console) override;

  private:
    std::vector<std::string> files_;
    CardOptions card_;
};

/// `limner style show`: what is known of a style, and a picture of its ball.
class StyleShowCommand : public Command {
  public:
    void declare(CLI::App& app) override;
    int run(Console& console) override;

  private:
    std::string style_;
    std::string out_;
    int size_ = 512;
};

/// `limner style list`: the bundled styles and the user's own.
class StyleListCommand : public Command {
  public:
    void declare(CLI::App& app) override;
    int run(Console& console) override;

  private:
    bool mine_ = false;
    bool bundled_ = false;
};

/// `limner style remove`: puts styles of the user's own aside, or brings them back.
class StyleRemoveCommand : public Command {
  public:
    void declare(CLI::App& app) override;
    int run(Console& console) override;

  private:
    std::vector<std::string> ids_;
    bool restore_ = false;
};

} // namespace limner::cli
