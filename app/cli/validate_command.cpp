#include "app/cli/validate_command.h"

#include "app/cli/console.h"
#include "app/cli/facts.h"
#include "core/figure/figure_json.h"
#include "core/project/figure_text.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace limner::cli {

namespace {

using Facts = nlohmann::ordered_json;

constexpr const char* kExamples = R"(Examples:
  limner validate figure.json
  limner validate skull.limner --json
)";

} // namespace

void ValidateCommand::declare(CLI::App& app) {
    app.description("Checks a figure and names the mend for each problem\n"
                    "Looks at types, ranges, unknown keys and what makes no sense. Each problem comes with\n"
                    "its JSON pointer. Exit code 3 where one keeps the figure from being drawn.");
    app.footer(kExamples);
    app.add_option("FIGURE", file_, "A .limner project or a figure.json")->required()->option_text(" ");
}

int ValidateCommand::run(Console& console) {
    const std::vector<Problem> problems = validateText(readFigureText(file_));
    const bool valid = std::none_of(problems.begin(), problems.end(), [](const Problem& p) { return p.fatal; });
    if (console.json) {
        Facts list = Facts::array();
        for (const Problem& p : problems) {
            list.push_back({{"pointer", p.pointer}, {"why", p.why}, {"mend", p.mend}, {"fatal", p.fatal}});
        }
        printFacts(console, Facts{{"valid", valid}, {"problems", list}});
    } else {
        for (const Problem& p : problems) {
            console.print((p.fatal ? "error: " : "note: ") + oneLine({p.pointer, "", p.why, p.mend}) + "\n");
        }
        if (problems.empty()) {
            console.say(file_ + ": no problem found");
        }
    }
    return valid ? 0 : static_cast<int>(ErrorKind::badInput);
}

} // namespace limner::cli
