#include "app/cli/thumbnail_command.h"

#include "app/cli/console.h"
#include "app/cli/facts.h"
#include "core/base/pending_file.h"
#include "core/project/project_thumbnail.h"
#include "renderer/backend_choice.h"
#include "renderer/export/picture_file.h"
#include "renderer/plan/planner.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace limner::cli {

namespace {

using Facts = nlohmann::ordered_json;

constexpr const char* kExamples = R"(Examples:
  limner thumbnail head.limner -o head.png
  limner thumbnail head.limner -o head.png -s 128
)";

void writeBytes(const std::filesystem::path& path, const void* bytes, std::size_t count) {
    PendingFile file(path);
    std::fwrite(bytes, 1, count, file.stream());
    file.check();
    file.commit();
}

} // namespace

std::vector<std::byte> thumbnailOf(const Figure& figure, int edge, Task& task) {
    Figure square = figure;
    square.output.widthMm = square.output.heightMm = std::max(figure.output.widthMm, figure.output.heightMm);
    PlanRequest request;
    request.size = {edge, edge};
    request.subPixels = 2; // small pictures need smooth edges most
    Planner planner;
    return renderPng(*planner.plan(square, request, task), *makeBackend("auto"), pictureOptions(figure), task);
}

void ThumbnailCommand::declare(CLI::App& app) {
    app.description("Writes the small picture of a project, for file managers\n"
                    "What the project keeps is taken; where it keeps none, and for scans, the figure is drawn.");
    app.footer(kExamples);
    figure_.declareInput(app, "FILE", "A project, a figure or a scan");
    app.add_option("-o,--output", out_, "The picture, NAME.png")->required()->option_text("FILE");
    app.add_option("-s,--size", edge_, "Pixels of the longer edge at most")
        ->option_text("PIXELS")
        ->check(CLI::Range(16, 1024));
}

int ThumbnailCommand::run(Console& console) {
    const auto kept = projectThumbnail(figure_.file(), edge_);
    if (kept) {
        writeBytes(out_, kept->data(), kept->size());
    } else {
        const Document document = figure_.openAsIs(console);
        if (!document.figure.volume || !document.figure.volume->data) {
            throw Error(ErrorKind::badInput, {"cannot draw a thumbnail", figure_.file(), "its scan is not there",
                                              "put it beside the figure"});
        }
        const std::vector<std::byte> drawn = thumbnailOf(document.figure, edge_, console.task());
        writeBytes(out_, drawn.data(), drawn.size());
    }
    if (console.json) {
        printFacts(console, Facts{{"file", out_}, {"kept", kept.has_value()}});
    }
    return 0;
}

} // namespace limner::cli
