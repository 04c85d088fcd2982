#include "app/cli/figure_options.h"

#include "app/cli/console.h"
#include "app/cli/words.h"
#include "core/figure/figure_json.h"
#include "core/figure/label_look.h"
#include "core/figure/output_size.h"
#include "core/figure/quantity.h"
#include "core/figure/style_edits.h"
#include "core/figure/themes.h"
#include "core/project/label_volume.h"
#include "core/project/sample_figures.h"
#include "core/style/style_library.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace limner::cli {

namespace {

struct NamedView {
    const char* name;
    StandardView view;
};
constexpr NamedView kViews[] = {
    {"anterior", StandardView::anterior},
    {"posterior", StandardView::posterior},
    {"left", StandardView::left},
    {"right", StandardView::right},
    {"superior", StandardView::superior},
    {"inferior", StandardView::inferior},
    {"three-quarter", StandardView::threeQuarter},
};

/// What counts as matter where a preset cleaned the scan up: its own threshold.
std::optional<double> matterAbove(const Figure& figure) {
    for (const CleanupStep& step : figure.cleanup) {
        if (step.kind == CleanupKind::keepLargest) {
            return step.above;
        }
    }
    return std::nullopt;
}

/// Throws where the option was given and names none of the cards.
template <typename Card>
void checkCard(const std::vector<Card>& cards, const std::string& id, const std::string& option) {
    std::vector<std::string> names;
    for (const Card& card : cards) {
        names.push_back(card.id);
    }
    if (!id.empty()) {
        checkKnown(names, id, option);
    }
}

/// Everything else is a scan.
bool namesProject(const std::filesystem::path& path) {
    return path.extension() == ".limner" || path.extension() == ".json";
}

} // namespace

void FigureOptions::declareInput(CLI::App& app, const std::string& name, const std::string& help, bool required) {
    app.add_option(name, file_, help)->required(required)->option_text(" ");
    app.add_option("--raw", raw_,
                   "Read headerless bytes: WxHxD:TYPE:le|be:SX,SY,SZ (voxels, number type, byte order, spacing in mm)")
        ->option_text("LAYOUT");
    app.add_option("--series", series_,
                   "Of a folder with several DICOM series: the UID, or the number that info shows [the largest]")
        ->option_text("SERIES");
    app.add_flag("--first-component", firstComponent_, "Of colour, vector or 4D data take the first component");
    app.add_option("--labels", labels_,
                   "A volume of label numbers that belongs to the scan, on any grid; its names and colours are read "
                   "from it or from a text file beside it. Replaces a project's labels")
        ->option_text("FILE");
}

void FigureOptions::declareLook(CLI::App& app) {
    auto* preset = app.add_option("--preset", preset_, "Look to start from; `limner preset list` shows them [auto]")
                       ->option_text("NAME");
    app.add_option("--figure", sample_,
                   "Lay a sample figure over the scan: look, camera, labels and clean-up; `limner figure list` shows "
                   "them and the scan each was made for")
        ->option_text("NAME")
        ->excludes(preset);
    app.add_option("--theme", theme_, "Exchange all styles and the paper; `limner theme list` shows them")
        ->option_text("NAME");
    app.add_option("--view", view_,
                   "Look from: anterior, posterior, left, right, superior, inferior or three-quarter (the patient's "
                   "sides)")
        ->option_text("SIDE");
    app.add_option("--set", settings_,
                   "Set any value of the figure by its JSON pointer, for example /camera/height_mm=120 or "
                   "/layers/0/transfer/nodes/0/style=ivory-bone (one of your styles, a bundled one, or a style's "
                   "picture); VALUE is JSON, else text; null removes a part; repeatable")
        ->option_text("KEY=VALUE")
        ->expected(1)
        ->take_all();
}

void FigureOptions::declareSize(CLI::App& app) {
    app.add_option("--size", size_, "Size in pixels, for example 2126x1417")->option_text("WxH");
    app.add_option("--width-mm", widthMm_, "Width on paper in mm; the height follows [180]")->option_text("MM");
    app.add_option("--height-mm", heightMm_, "Height on paper in mm; the width follows [180]")->option_text("MM");
    app.add_option("--dpi", dpi_, "Dots per inch [300]")->option_text("DPI");
}

void FigureOptions::declareMachine(CLI::App& app) {
    app.add_option("--threads", threads_, "Most threads to use [all]")
        ->option_text("N")
        ->check(CLI::Range(1, 4096).description("")); // more threads than any machine has
    app.add_option("--memory", memory_,
                   "Most memory to use, the scan included, for example 4G [3/4 of the machine's for the scan, 1G for "
                   "the picture]")
        ->option_text("BYTES");
}

std::optional<std::uint64_t> FigureOptions::memory() const {
    return memory_.empty() ? std::nullopt : std::optional(parseBytes(memory_, "--memory"));
}

ImportOptions FigureOptions::importOptions() const {
    ImportOptions options;
    options.raw = raw_;
    options.series = series_;
    options.firstComponent = firstComponent_;
    options.memoryBudget = memory().value_or(0);
    return options;
}

OpenOptions FigureOptions::openOptions() const { return {preset_, labels_, importOptions(), sample_}; }

Document FigureOptions::openAsIs(Console& console) const {
    Document document;
    if (namesProject(file_)) {
        document = openDocument(file_, openOptions(), console.task());
    } else {
        ImportedVolume imported = importVolume(file_, importOptions(), console.task());
        if (!labels_.empty()) {
            const LabelRequest request{imported.volume, memory().value_or(0)};
            document.figure.labels = openLabels(labels_, request, document.notes, console.task());
        }
        document.figure.volume.emplace().data = std::move(imported.volume);
        document.volumeReport = std::move(imported.report);
    }
    for (const std::string& note : document.volumeReport.warnings) {
        console.task().warn(note);
    }
    for (const std::string& note : document.notes) {
        console.task().warn(note);
    }
    return document;
}

Document FigureOptions::open(Console& console) const {
    // Everything that can be judged without the scan is judged before it is read.
    static_cast<void>(resized(Output{}, {size_.empty() ? std::nullopt : std::optional(parsePixelSize(size_, "--size")),
                                         widthMm_, heightMm_, dpi_}));
    if (!view_.empty()) {
        chosen(kViews, view_, "--view");
    }
    checkCard(bundledPresets(), preset_, "--preset");
    checkCard(sampleFigures(), sample_, "--figure");
    checkCard(bundledThemes(), theme_, "--theme");
    Document document = openDocument(file_, openOptions(), console.task());
    for (const std::string& note : document.volumeReport.warnings) {
        console.task().warn(note);
    }
    if (!preset_.empty() && !document.path.empty()) {
        document.figure = withPreset(document.figure, preset_, document.notes);
    }
    if (!theme_.empty()) {
        document.figure = withTheme(document.figure, theme_, document.notes);
    }
    for (const std::string& note : document.notes) {
        console.task().warn(note);
    }
    applySize(document);
    applyView(document);
    applySettings(document, console);
    return document;
}

void FigureOptions::applySize(Document& document) const {
    SizeRequest request{std::nullopt, widthMm_, heightMm_, dpi_};
    if (!size_.empty()) {
        request.pixels = parsePixelSize(size_, "--size");
    }
    document.figure.output = resized(document.figure.output, request);
    if (document.path.empty() && view_.empty()) { // a project's camera was chosen for its own shape
        document.figure.camera = fittedTo(document.figure.output, document.figure.camera);
    }
}

void FigureOptions::applyView(Document& document) const {
    Figure& figure = document.figure;
    if (view_.empty()) {
        return;
    }
    if (!figure.volume || !figure.volume->data) {
        throw Error(ErrorKind::badInput,
                    {"cannot choose a view", file_, "the figure has no scan to look at", "find the scan first"});
    }
    const StandardView view = chosen(kViews, view_, "--view").view;
    const bool byLabel = drawsByLabel(figure) && figure.labels && figure.labels->data;
    Camera camera = byLabel ? standardView(*figure.labels->data, view, 0)
                            : standardView(*figure.volume->data, view, matterAbove(figure));
    camera.projection = figure.camera.projection;
    camera.fovDeg = figure.camera.fovDeg;
    figure.camera = fittedTo(figure.output, camera);
}

void FigureOptions::applySettings(Document& document, Console& console) const {
    for (const std::string& setting : settings_) {
        document.figure = withSetting(document.figure, setting);
    }
    if (settings_.empty()) {
        return;
    }
    joinNamedStyles(document.figure, StyleLibrary(StyleLibrary::userFolder()));
    const Background& background = document.figure.background;
    const auto unresolved = [](const StyleEntry& style) {
        return style.sphere == nullptr || (style.texture && style.texture->tile == nullptr);
    };
    if (std::any_of(document.figure.styles.begin(), document.figure.styles.end(), unresolved) ||
        (background.kind == "image" && background.picture == nullptr)) {
        const std::size_t known = document.notes.size();
        resolveFigure(document, document.path.parent_path(), importOptions(), console.task());
        for (std::size_t i = known; i < document.notes.size(); ++i) {
            console.task().warn(document.notes[i]);
        }
    }
    for (const Problem& problem : validateFigure(document.figure)) {
        if (problem.fatal) {
            throw Error(ErrorKind::usage, {"the figure cannot be drawn", problem.pointer, problem.why, problem.mend});
        }
        console.task().warn(problem.pointer + ": " + problem.why);
    }
}

} // namespace limner::cli
