#pragma once

#include "app/cli/backend_options.h"
#include "app/cli/command.h"
#include "app/cli/figure_options.h"
#include "renderer/export/picture_file.h"
#include "renderer/plan/render_plan.h"

#include <string>

namespace limner::cli {

/// `limner render`: a figure or a scan becomes a picture file.
class RenderCommand : public Command {
  public:
    void declare(CLI::App& app) override;
    int run(Console& console) override;

  private:
    void declarePicture(CLI::App& app);
    [[nodiscard]] PictureOptions optionsFor(const Figure& figure) const;
    void report(Console& console, const ExportFacts& facts, const std::string& backend, double seconds) const;

    FigureOptions figure_;
    std::string out_;
    BackendOptions backend_;
    std::string depth_;
    std::string background_;
    bool transparent_ = false;
    bool keepEverything_ = false;
    int tile_ = 0;
};

} // namespace limner::cli
