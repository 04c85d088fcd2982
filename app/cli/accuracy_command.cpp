#include "app/cli/accuracy_command.h"

#include "app/cli/console.h"
#include "app/cli/facts.h"
#include "app/cli/scene_test.h"
#include "core/base/pending_file.h"
#include "core/style/png_writing.h"
#include "renderer/export/thread_limit.h"

#include <CLI/CLI.hpp>
#include <glm/common.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <sstream>

namespace limner::cli {

namespace {

constexpr double kStudySize = 512; // pixels of the longer edge, where no size was asked for

constexpr const char* kExamples = R"(Examples:
  limner accuracy skull.limner -o report.html
  limner accuracy head.nii.gz --preset skull --tolerance print --apply --json
  limner accuracy --self-test
  limner accuracy skull.limner --knobs step,pre-integration --metric max -o steps.csv
)";

PlanRequest requestOf(const FigureOptions& options, const Figure& figure) {
    PlanRequest request;
    const glm::dvec2 size(figure.output.sizePixels());
    if (!options.sized()) {
        const double scale = std::min(1.0, kStudySize / std::max(size.x, size.y));
        request.size = glm::max(glm::ivec2(glm::round(size * scale)), 1);
    }
    return request;
}

std::string summary(const accuracy::Study& study) {
    std::vector<std::vector<std::string>> rows = {{"", "settings", "picture", "rmse", "max", "dE00 95 %", ""}};
    const auto row = [&](const std::string& name, const accuracy::StudyRow& r, const std::string& remark) {
        const accuracy::PictureError& e = r.measured.error;
        rows.push_back({name, r.words, numberText(r.pictureSeconds) + " s", numberText(e.rmse), numberText(e.largest),
                        numberText(e.p95Colour), remark});
    };
    row("as it is", study.rows[study.present], "");
    for (const auto& [name, choice] : study.choices) {
        for (const accuracy::StudyRow& r : study.rows) {
            if (r.method == name) {
                row(name, r, choice.reached ? "" : "not reached");
            }
        }
    }
    std::string text = textTable(rows) + "\n" + study.limiting + "\nThe reference is good to " +
                       toleranceText(study.metric, study.errorBar) + ".\n";
    for (const std::string& note : study.notes) {
        text += note + "\n";
    }
    return text;
}

} // namespace

void AccuracyCommand::declare(CLI::App& app) {
    app.description(
        "Shows how wrong a figure's picture is and what better would cost\n"
        "Measures error against run time on places that stand for the whole picture: every setting that\n"
        "trades one for the other, one at a time and together, against the figure's own model (its voxels,\n"
        "interpolation, gradients and rays per pixel) without any error of sampling. Finds the cheapest\n"
        "settings for draft, screen, print and reference. Exit code 6 where --tolerance is not reached,\n"
        "7 where the reference is not good enough for it, 8 for pixels that are no numbers.");
    app.footer(kExamples);
    figure_.declareInput(app, "FIGURE-or-VOLUME", "A .limner project, a figure.json or a scan", false);
    app.add_option("-o,--output", out_, "The report: .html with charts and error maps, .csv or .json")
        ->option_text("FILE");
    tolerance_.declare(app, "Also find the cheapest settings for this");
    app.add_flag("--apply", apply_, "Write the settings found for --tolerance into the project");
    app.add_flag("--self-test", selfTest_,
                 "No figure: draw the scenes with known results (A1 to A8) on every backend, or on --backend's");
    app.add_option("--knobs", knobs_, "Only these, by comma: step, pre-integration, early end, ... [all]")
        ->option_text("LIST");
    app.add_option("--time-budget", timeBudget_, "Seconds after which nothing new is measured [60]")
        ->option_text("S")
        ->check(CLI::Range(1.0, 1e6).description(""));
    figure_.declareLook(app);
    figure_.declareSize(app);
    backend_.declare(app);
    figure_.declareMachine(app);
}

void AccuracyCommand::checkRequest() const {
    if (figure_.file().empty()) {
        throw Error(ErrorKind::usage, {"wrong usage", "", "there is no figure", "name a figure, or add --self-test"});
    }
    const std::string ending = std::filesystem::path(out_).extension().string();
    if (!out_.empty() && ending != ".html" && ending != ".csv" && ending != ".json") {
        throw Error(ErrorKind::usage, {"cannot write the report", out_, "its name must end in .html, .csv or .json",
                                       "write for example -o report.html"});
    }
    std::error_code ignored;
    const auto folder = std::filesystem::path(out_).parent_path();
    if (!folder.empty() && !std::filesystem::is_directory(folder, ignored)) {
        throw Error(ErrorKind::usage,
                    {"cannot write the report", out_, "there is no such folder", "make the folder first"});
    }
    const std::string file = std::filesystem::path(figure_.file()).extension().string();
    if (apply_ && file != ".limner" && file != ".json") {
        throw Error(ErrorKind::usage, {"wrong usage", "--apply", "settings are written into a project, this is a scan",
                                       "make a project of it with `limner new`"});
    }
    tolerance_.check();
}

std::vector<accuracy::Knob> AccuracyCommand::knobs() const {
    std::vector<accuracy::Knob> chosen;
    std::istringstream list(knobs_);
    for (std::string word; std::getline(list, word, ',');) {
        const auto& all = accuracy::allKnobs();
        const auto found =
            std::find_if(all.begin(), all.end(), [&](accuracy::Knob k) { return word == accuracy::nameOf(k); });
        if (found == all.end()) {
            std::string known;
            for (const accuracy::Knob knob : all) {
                known += std::string(known.empty() ? "" : ", ") + accuracy::nameOf(knob);
            }
            throw Error(ErrorKind::usage,
                        {"wrong usage", "--knobs", "\"" + word.substr(0, 60) + "\" is none", "choose of " + known});
        }
        chosen.push_back(*found);
    }
    return chosen;
}

void AccuracyCommand::apply(Document& document, const accuracy::Study& study, Console& console) const {
    const auto& [name, choice] = study.choices.back();
    const Quality& found = choice.quality;
    document.figure.quality = found;
    document.figure.quality.tolerance = choice.asked.value;
    document.figure.quality.toleranceMetric = choice.asked.metric;
    saveDocument(document, document.path, {}, console.task());
    console.say(document.path.string() + ": " + choice.words);
}

int AccuracyCommand::run(Console& console) {
    if (selfTest_) {
        return runSceneTest(backend_.name(), console);
    }
    checkRequest();
    accuracy::StudyOptions options;
    options.knobs = knobs();
    options.secondsBudget = timeBudget_;
    const auto backend = backend_.make();
    std::optional<ThreadLimit> limit;
    if (figure_.threads() > 0) {
        limit.emplace(figure_.threads());
    }
    Document document = figure_.open(console);
    options.metric = tolerance_.metric(document.figure.quality);
    options.tolerance = tolerance_.asked(document.figure.quality);
    if (apply_ && !options.tolerance) {
        throw Error(ErrorKind::usage,
                    {"wrong usage", "--apply", "there is no tolerance to keep", "add for example --tolerance print"});
    }
    const accuracy::Study study =
        accuracy::runStudy(document.figure, requestOf(figure_, document.figure), *backend, options, console.task());
    if (!out_.empty()) {
        const std::string ending = std::filesystem::path(out_).extension().string();
        writeWholeFile(out_, ending == ".html"  ? accuracy::reportHtml(study, document.figure)
                             : ending == ".csv" ? accuracy::reportCsv(study)
                                                : accuracy::reportJson(study));
    }
    if (console.json) {
        printFactText(console, accuracy::reportJson(study));
    } else {
        console.print(summary(study));
    }
    const bool found = options.tolerance && !study.choices.empty() && study.choices.back().first == "as asked";
    if (options.tolerance && !found) {
        return static_cast<int>(ErrorKind::notConverged);
    }
    if (apply_ && study.choices.back().second.reached) {
        apply(document, study, console);
    }
    return !found || study.choices.back().second.reached ? 0 : static_cast<int>(ErrorKind::notToTolerance);
}

} // namespace limner::cli
