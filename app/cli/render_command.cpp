#include "app/cli/render_command.h"

#include "app/cli/console.h"
#include "app/cli/facts.h"
#include "app/cli/words.h"
#include "core/base/process.h"
#include "core/figure/quantity.h"
#include "core/style/background_picture.h"
#include "renderer/export/thread_limit.h"
#include "renderer/plan/planner.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>

namespace limner::cli {

namespace {

using Facts = nlohmann::ordered_json;

struct NamedDepth {
    const char* name;
    SampleDepth depth;
};
constexpr NamedDepth kDepths[] = {
    {"8", SampleDepth::eight}, {"16", SampleDepth::sixteen}, {"float", SampleDepth::floating}};

constexpr const char* kExamples = R"(Examples:
  limner render head.nii.gz -o head.png
  limner render dicom-folder -o skull.tif --preset skull --view left --width-mm 120 --dpi 600 --depth 16
  limner render skull.limner -o poster.png --size 16384x16384 --transparent --set /camera/height_mm=150
)";

/// What is left of --memory for the picture.
std::size_t pictureBudget(std::uint64_t memory, const RenderPlan& plan) {
    const std::uint64_t held = plan.figure->volume->data->bytes() +
                               (plan.volume == plan.figure->volume->data ? 0 : plan.volume->bytes()) + plan.bytes;
    if (held >= memory) {
        throw Error(ErrorKind::noResources,
                    {"the picture does not fit the memory budget", "--memory",
                     "the scan and the plan alone take " + formatBytes(held), "allow more memory"});
    }
    return static_cast<std::size_t>(memory - held);
}

} // namespace

void RenderCommand::declare(CLI::App& app) {
    app.description("Renders a figure, a project or a scan to a picture\n"
                    "A scan needs nothing else: the preset auto makes a figure of it.");
    app.footer(kExamples);
    figure_.declareInput(app, "FIGURE-or-VOLUME",
                         "A .limner project, a figure.json, or a scan: DICOM folder or file, .nii(.gz), .hdr/.img, "
                         ".nrrd, .nhdr, .mha, .mhd, .vti, .vtk, a TIFF or PNG stack, .inv3; builtin:head is a head "
                         "that comes with Limner");
    declarePicture(app);
    figure_.declareLook(app);
    figure_.declareSize(app);
    backend_.declare(app);
    tolerance_.declare(app, "Choose the cheapest step and other settings whose error stays below this");
    app.add_option("--tile", tile_, "Edge of the tiles that are rendered at a time, in pixels [from the budget]")
        ->option_text("N")
        ->check(CLI::Range(1, 1'000'000).description(""));
    app.add_flag("--no-omit", keepEverything_, "Leave nothing out of the plan: to prove that this changes nothing");
    figure_.declareMachine(app);
}

void RenderCommand::declarePicture(CLI::App& app) {
    app.add_option(
           "-o,--output", out_,
           "The picture; its ending picks the format: png, tif, exr, jpg or webp; svg or pdf draws marks of ink as "
           "circles and paths")
        ->required()
        ->option_text("FILE");
    app.add_option("--depth", depth_, "Numbers in the file: 8, 16 (half in exr) or float [8; float in exr]")
        ->option_text("DEPTH");
    app.add_flag("--transparent", transparent_, "Leave the background out (png, tif, exr, webp)");
    app.add_option(
           "--background", background_,
           "What lies behind the figure: a colour (#rrggbb, r,g,b from 0 to 1, white, grey or black), or a picture "
           "file, scaled to cover")
        ->option_text("COLOUR-or-FILE");
}

PictureOptions RenderCommand::optionsFor(const Figure& figure) const {
    PictureOptions options = pictureOptions(figure);
    options.depth = depth_.empty() ? SampleDepth::automatic : chosen(kDepths, depth_, "--depth").depth;
    std::error_code ignored;
    if (std::filesystem::is_regular_file(background_, ignored)) {
        options.backgroundPicture = std::make_shared<const BackgroundPicture>(background_);
    } else if (!background_.empty()) {
        options.background = parseColour(background_, "--background");
        options.backgroundPicture = nullptr;
    }
    options.transparent = transparent_ || (figure.output.transparent && background_.empty());
    options.tile = tile_;
    options.memoryBudget = figure_.memory().value_or(options.memoryBudget);
    return options;
}

int RenderCommand::run(Console& console) {
    const auto start = std::chrono::steady_clock::now();
    // What is wrong with the request is said before a scan of a gigabyte is read.
    checkExport(out_, {0, 0}, optionsFor(Figure{}));
    tolerance_.check();
    const auto backend = backend_.make();
    std::optional<ThreadLimit> limit;
    if (figure_.threads() > 0) {
        limit.emplace(figure_.threads());
    }
    Task& task = console.task();
    Document document = figure_.open(console);
    PictureOptions options = optionsFor(document.figure);
    checkExport(out_, document.figure.output.sizePixels(), options);

    const auto choice = keepTolerance(document.figure, *backend, task);
    task.beginPhase("Planning");
    Planner planner;
    PlanRequest request;
    request.omit = !keepEverything_;
    const auto plan = planner.plan(document.figure, request, task);
    if (const auto memory = figure_.memory()) {
        options.memoryBudget = pictureBudget(*memory, *plan);
    }
    const ExportFacts facts = exportPicture(*plan, *backend, out_, options, task);
    report(console, {facts, choice, backend->name(),
                     std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()});
    return facts.notFinite > 0          ? static_cast<int>(ErrorKind::notFinite)
           : choice && !choice->reached ? static_cast<int>(ErrorKind::notToTolerance)
                                        : 0;
}

std::optional<accuracy::ToleranceChoice> RenderCommand::keepTolerance(Figure& figure, const Backend& backend,
                                                                      Task& task) const {
    const auto asked = tolerance_.asked(figure.quality);
    if (!asked) {
        return std::nullopt;
    }
    task.beginPhase("Finding the settings for the tolerance");
    accuracy::Bench bench(figure, {}, backend, task);
    bench.makeReference(*asked, nullptr);
    auto choice = accuracy::chooseQuality(bench, *asked);
    figure.quality = choice.quality;
    if (!choice.reached) {
        task.warn("the picture is not to the tolerance of " + toleranceText(asked->metric, asked->value) + ": " +
                  choice.limiting);
    }
    return choice;
}

void RenderCommand::report(Console& console, const Result& result) const {
    const ExportFacts& facts = result.facts;
    std::error_code ignored;
    const auto fileBytes = std::filesystem::file_size(out_, ignored);
    if (console.json) {
        Facts object{{"file", out_},
                     {"width", facts.size.x},
                     {"height", facts.size.y},
                     {"backend", result.backend},
                     {"seconds", result.seconds},
                     {"render_seconds", facts.seconds},
                     {"samples", facts.samples},
                     {"shaded", facts.shaded},
                     {"dots", facts.dots},
                     {"strokes", facts.strokes},
                     {"annotations", facts.annotations},
                     {"layers_embedded", facts.layersEmbedded},
                     {"non_finite_pixels", facts.notFinite},
                     {"file_bytes", fileBytes},
                     {"peak_bytes", peakResidentBytes()},
                     {"warnings", console.task().warnings()}};
        if (result.choice) {
            object["tolerance"] = {{"metric", accuracy::nameOf(result.choice->asked.metric)},
                                   {"asked", result.choice->asked.value},
                                   {"delivered", result.choice->heldOutError},
                                   {"error_bar", result.choice->errorBar},
                                   {"reached", result.choice->reached},
                                   {"settings", result.choice->words},
                                   {"limiting_knob", result.choice->limiting}};
        }
        printFacts(console, object);
        return;
    }
    char text[160];
    std::snprintf(text, sizeof text, "%d x %d pixels, %s, %s backend, %.1f s", facts.size.x, facts.size.y,
                  formatBytes(fileBytes).c_str(), result.backend.c_str(), result.seconds);
    std::string marks;
    if (facts.dots + facts.strokes > 0)
        marks = ", " + std::to_string(facts.dots) + " dots, " + std::to_string(facts.strokes) + " strokes";
    if (facts.layersEmbedded)
        marks += ", the layers embedded as one picture";
    console.say(out_ + ": " + text + marks);
    if (result.choice) {
        const accuracy::ToleranceChoice& choice = *result.choice;
        console.say("error " + toleranceText(choice.asked.metric, choice.heldOutError) + " where " +
                    numberText(choice.asked.value) + " was asked for, by " + choice.words);
    }
}

} // namespace limner::cli
