#pragma once

#include "app/cli/backend_options.h"
#include "app/cli/command.h"
#include "app/cli/figure_options.h"
#include "app/cli/tolerance_options.h"
#include "renderer/export/picture_file.h"
#include "renderer/plan/render_plan.h"

#include <optional>
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
    /// Puts the cheapest settings for the tolerance asked for, if any, into the figure.
    [[nodiscard]] std::optional<accuracy::ToleranceChoice> keepTolerance(Figure& figure, const Backend& backend,
                                                                         Task& task) const;
    /// What there is to say of a picture.
    struct Result {
        ExportFacts facts;
        std::optional<accuracy::ToleranceChoice> choice;
        std::string backend;
        double seconds = 0;
    };
    void report(Console& console, const Result& result) const;

    FigureOptions figure_;
    std::string out_;
    BackendOptions backend_;
    ToleranceOptions tolerance_;
    std::string depth_;
    std::string background_;
    bool transparent_ = false;
    bool keepEverything_ = false;
    int tile_ = 0;
};

} // namespace limner::cli
