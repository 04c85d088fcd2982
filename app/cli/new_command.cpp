#include "app/cli/new_command.h"

#include "app/cli/console.h"
#include "app/cli/facts.h"
#include "app/cli/thumbnail_command.h"
#include "renderer/export/thread_limit.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <optional>

namespace limner::cli {

namespace {

using Facts = nlohmann::ordered_json;

constexpr int kThumbnail = 256; // pixels an edge, as figure-document.md says

constexpr const char* kExamples = R"(Examples:
  limner new head.nii.gz -o head.limner
  limner new dicom-folder -o skull.limner --preset skull --view three-quarter --embed
)";

} // namespace

void NewCommand::declare(CLI::App& app) {
    app.description("Makes a project from a scan and a preset\n"
                    "The project refers to the scan by its path and checksum, or holds it with --embed.");
    app.footer(kExamples);
    figure_.declareInput(app, "VOLUME", "A scan of any format that `limner render` reads");
    app.add_option("-o,--output", out_, "The project, NAME.limner; an old one is kept as NAME.limner~")
        ->required()
        ->option_text("FILE");
    app.add_flag("--embed", embed_, "Put the scan into the project, so that it can be moved and sent alone");
    figure_.declareLook(app);
    figure_.declareSize(app);
    figure_.declareMachine(app);
}

int NewCommand::run(Console& console) {
    const std::filesystem::path path = out_;
    if (path.extension() != ".limner" && path.extension() != ".json") {
        throw Error(ErrorKind::usage, {"cannot make the project", out_, "its name must end in .limner or .json",
                                       "write for example -o figure.limner"});
    }
    std::error_code ignored;
    if (path.has_parent_path() && !std::filesystem::is_directory(path.parent_path(), ignored)) {
        throw Error(ErrorKind::usage,
                    {"cannot make the project", out_, "there is no such folder", "make the folder first"});
    }
    std::optional<ThreadLimit> limit;
    if (figure_.threads() > 0) {
        limit.emplace(figure_.threads());
    }
    Task& task = console.task();
    const Document document = figure_.open(console);
    if (!document.figure.volume || !document.figure.volume->data) {
        throw Error(ErrorKind::badInput,
                    {"cannot make a project", figure_.file(), "there is no scan in it", "name a scan"});
    }
    task.beginPhase("Thumbnail");
    SaveOptions options;
    options.embedVolume = embed_;
    options.thumbnailPng = thumbnailOf(document.figure, kThumbnail, task);
    saveDocument(document, path, options, task);
    if (console.json) {
        printFacts(console, Facts{{"file", out_},
                                  {"embedded", embed_},
                                  {"file_bytes", std::filesystem::file_size(path, ignored)},
                                  {"layers", document.figure.layers.size()},
                                  {"warnings", task.warnings()}});
    }
    console.say(out_ + ": a project with " + std::to_string(document.figure.layers.size()) +
                (document.figure.layers.size() == 1 ? " layer" : " layers"));
    return 0;
}

} // namespace limner::cli
