#include "app/cli/list_commands.h"

#include "app/cli/console.h"
#include "app/cli/facts.h"
#include "core/figure/presets.h"
#include "core/figure/themes.h"
#include "core/project/sample_figures.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace limner::cli {

namespace {

using Facts = nlohmann::ordered_json;

} // namespace

void PresetListCommand::declare(CLI::App& app) {
    app.description("Lists the bundled presets\n"
                    "The name for --preset, the kind of scan, and what it shows.");
    app.footer("Examples:\n  limner preset list\n  limner preset list --json\n");
}

int PresetListCommand::run(Console& console) {
    std::vector<std::vector<std::string>> rows;
    Facts list = Facts::array();
    for (const PresetCard& card : bundledPresets()) {
        rows.push_back({card.id, card.modality, card.help});
        list.push_back({{"id", card.id}, {"name", card.name}, {"help", card.help}, {"modality", card.modality}});
    }
    if (console.json) {
        printFacts(console, Facts{{"presets", list}});
    } else {
        console.print(textTable(rows));
    }
    return 0;
}

void ThemeListCommand::declare(CLI::App& app) {
    app.description("Lists the bundled themes\n"
                    "The name for --theme, and what it looks like.");
    app.footer("Examples:\n  limner theme list\n  limner theme list --json\n");
}

int ThemeListCommand::run(Console& console) {
    std::vector<std::vector<std::string>> rows;
    Facts list = Facts::array();
    for (const ThemeCard& card : bundledThemes()) {
        rows.push_back({card.id, card.name, card.help});
        list.push_back({{"id", card.id}, {"name", card.name}, {"help", card.help}});
    }
    if (console.json) {
        printFacts(console, Facts{{"themes", list}});
    } else {
        console.print(textTable(rows));
    }
    return 0;
}

void FigureListCommand::declare(CLI::App& app) {
    app.description("Lists the sample figures\n"
                    "The name for --figure, the scan that it was made for (and its labels), and what it shows.");
    app.footer("Examples:\n  limner figure list\n"
               "  limner render Cranium.inv3 --figure contours-even -o skull.png\n");
}

int FigureListCommand::run(Console& console) {
    std::vector<std::vector<std::string>> rows;
    Facts list = Facts::array();
    for (const SampleFigure& card : sampleFigures()) {
        rows.push_back({card.id, card.labels.empty() ? card.scan : card.scan + ", " + card.labels, card.title});
        list.push_back({{"id", card.id}, {"title", card.title}, {"scan", card.scan}, {"labels", card.labels}});
    }
    if (console.json) {
        printFacts(console, Facts{{"figures", list}});
    } else {
        console.print(textTable(rows));
    }
    return 0;
}

} // namespace limner::cli
