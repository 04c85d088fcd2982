#pragma once

#include "app/cli/command.h"
#include "app/cli/figure_options.h"

#include <cstddef>
#include <vector>

namespace limner {
class Task;
}

namespace limner::cli {

/// The picture in file managers and in the studio's list of projects: square, as a PNG.
std::vector<std::byte> thumbnailOf(const Figure& figure, int edge, Task& task);

/// `limner thumbnail`: the small picture of a project, or of a scan.
class ThumbnailCommand : public Command {
  public:
    void declare(CLI::App& app) override;
    int run(Console& console) override;

  private:
    FigureOptions figure_;
    std::string out_;
    int edge_ = 256; // as the project keeps it
};

} // namespace limner::cli
