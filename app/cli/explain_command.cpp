#include "app/cli/explain_command.h"

#include "app/cli/console.h"
#include "app/cli/facts.h"
#include "app/cli/visibility_table.h"
#include "core/figure/quantity.h"
#include "renderer/accuracy/savings.h"
#include "renderer/export/thread_limit.h"
#include "renderer/plan/explain.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <cstdlib>
#include <optional>

namespace limner::cli {

namespace {

using Facts = nlohmann::ordered_json;

constexpr const char* kExamples = R"(Examples:
  limner explain skull.limner
  limner explain head.nii.gz --preset skull --size 4096x4096 --json
  limner explain skull.limner --visibility --set /importance/weights/gradient=2
  limner explain skull.limner --savings --size 512x512
)";

Facts names(const std::vector<PlanFeature>& features) {
    Facts list = Facts::array();
    for (const PlanFeature& feature : features) {
        list.push_back(feature.name);
    }
    return list;
}

/// A rule at work.
Facts leftOutFacts(const LeftOut& out) {
    const LeaveOutRule& rule = ruleOf(out.rule);
    return {{"rule", rule.id},
            {"name", rule.name},
            {"condition", rule.condition},
            {"equality", nameOf(rule.equality)},
            {"what", out.what}};
}

Facts explanationFacts(const Explanation& e) {
    Facts reasons = Facts::object();
    Facts leftOut = Facts::array();
    Facts rules = Facts::array();
    for (const LeftOut& out : e.leftOut) {
        leftOut.push_back(ruleOf(out.rule).name);
        rules.push_back(leftOutFacts(out));
        reasons[ruleOf(out.rule).name] = ruleOf(out.rule).condition;
    }
    for (const auto* features : {&e.used, &e.notAsked}) {
        for (const PlanFeature& feature : *features) {
            reasons[feature.name] = feature.reason;
        }
    }
    Facts bytes = Facts::object();
    Facts estimated = Facts::object();
    Facts measured{{"planning", e.planningMs}};
    for (const PartCost& part : e.parts) {
        bytes[part.name] = part.bytes;
        estimated[part.name] = part.estimatedMs;
        measured[part.name] = part.measuredMs;
    }
    bytes["total"] = e.bytes();
    estimated["total"] = e.estimatedMs();
    measured["total"] = e.measuredMs();
    return {{"features_used", names(e.used)},
            {"features_left_out", leftOut},
            {"features_not_asked", names(e.notAsked)},
            {"left_out", rules},
            {"reasons", reasons},
            {"fields", e.fields},
            {"annotations", e.annotations},
            {"bytes", bytes},
            {"milliseconds", {{"estimated", estimated}, {"measured", measured}}},
            {"backend", e.backend},
            {"probe_pixels", {e.probe.x, e.probe.y}},
            {"samples_per_pixel", e.samplesPerPixel},
            {"occupied", e.occupied}};
}

Facts visibilityFacts(const VisibilityTable& table) {
    Facts parts = Facts::array();
    for (const VisibilityTable::Row& row : table.rows) {
        parts.push_back({{"kind", row.kind}, {"name", row.name}, {"shares", row.shares}});
    }
    return {{"pixels", {table.pixels.x, table.pixels.y}}, {"global_weights", table.globalWeights}, {"parts", parts}};
}

std::string explanationText(const Explanation& e) {
    std::string text = "Used\n";
    for (const PlanFeature& f : e.used) {
        text += "  " + f.name + (f.reason.empty() ? "" : ": " + f.reason) + "\n";
    }
    text += "Left out, for the picture is the same without\n";
    for (const LeftOut& out : e.leftOut) {
        text += std::string("  ") + ruleOf(out.rule).name + " (" + out.what + "): " + ruleOf(out.rule).condition + "\n";
    }
    text += "Not asked for\n";
    for (const PlanFeature& f : e.notAsked) {
        text += "  " + f.name + (f.reason.empty() ? "" : ": " + f.reason) + "\n";
    }
    text += "Read at every sample\n ";
    for (const std::string& field : e.fields) {
        text += " " + field;
    }
    if (!e.annotations.empty()) {
        text += "\nWritten over the picture";
        for (const std::string& line : e.annotations) {
            text += "\n  " + line;
        }
    }
    text += "\nCost                estimated     measured   memory\n";
    const auto row = [&](const std::string& name, double estimated, double measured, std::uint64_t bytes) {
        char line[128];
        std::snprintf(line, sizeof line, "  %-14s %9.1f ms %9.1f ms   %s\n", name.c_str(), estimated, measured,
                      bytes > 0 ? formatBytes(bytes).c_str() : "-");
        text += line;
    };
    for (const PartCost& part : e.parts) {
        row(part.name, part.estimatedMs, part.measuredMs, part.bytes);
    }
    row("total", e.estimatedMs(), e.measuredMs(), e.bytes());
    char line[160];
    std::snprintf(line, sizeof line,
                  "Rendering was measured on %d x %d pixels with the %s backend: %.1f samples a pixel; %.0f %% of the "
                  "volume holds something to see.\n",
                  e.probe.x, e.probe.y, e.backend.c_str(), e.samplesPerPixel, e.occupied * 100);
    return text + line;
}

Facts savingsFacts(const accuracy::Savings& s) {
    Facts rules = Facts::array();
    for (const accuracy::Saving& saving : s.rules) {
        Facts rule = leftOutFacts(saving.leftOut);
        rule["milliseconds"] = saving.ms;
        rule["bytes"] = saving.bytes;
        rules.push_back(rule);
    }
    return {{"backend", s.backend},
            {"pixels", {s.pixels.x, s.pixels.y}},
            {"rounds", s.rounds},
            {"picture", {{"milliseconds", s.ms}, {"bytes", s.bytes}}},
            {"rules", rules},
            {"sum", {{"milliseconds", s.sumMs()}, {"bytes", s.sumBytes()}}},
            {"without_any", {{"milliseconds", s.keptMs}, {"bytes", s.keptBytes}}}};
}

std::string savingsText(const accuracy::Savings& s) {
    std::string text = "Saved by leaving out\n";
    const auto row = [&](const std::string& name, double ms, std::int64_t bytes) {
        const std::string held = formatBytes(static_cast<std::uint64_t>(std::abs(bytes)));
        char line[160];
        std::snprintf(line, sizeof line, "  %-42s %9.1f ms   %s\n", name.c_str(), ms,
                      bytes == 0 ? "-" : ((bytes < 0 ? "-" : "") + held).c_str());
        text += line;
    };
    for (const accuracy::Saving& saving : s.rules) {
        row(ruleOf(saving.leftOut.rule).name, saving.ms, saving.bytes);
    }
    row("sum", s.sumMs(), s.sumBytes());
    row("all at once", s.keptMs - s.ms, static_cast<std::int64_t>(s.keptBytes) - static_cast<std::int64_t>(s.bytes));
    char line[200];
    std::snprintf(line, sizeof line,
                  "%d x %d pixels with the %s backend take %.1f ms, and %.1f ms with everything kept in; the least of "
                  "%d measurements by turns.\n",
                  s.pixels.x, s.pixels.y, s.backend.c_str(), s.ms, s.keptMs, s.rounds);
    return text + line;
}

} // namespace

void ExplainCommand::declare(CLI::App& app) {
    app.description("Shows what a figure uses and what that costs\n"
                    "The render plan: what is in it and why, what is left out, the memory it holds and the\n"
                    "time of each part, estimated and measured on this machine.");
    app.footer(kExamples);
    figure_.declareInput(app, "FIGURE-or-VOLUME", "A .limner project, a figure.json or a scan");
    figure_.declareLook(app);
    figure_.declareSize(app);
    backend_.declare(app);
    app.add_flag("--visibility", visibility_,
                 "How much of the picture each layer, label and range of values makes, now and\n"
                 "at other global weights of importance");
    app.add_flag("--savings", savings_,
                 "What each thing that is left out saves, measured: the picture is drawn with and\n"
                 "without it for some seconds");
    figure_.declareMachine(app);
}

int ExplainCommand::run(Console& console) {
    const auto backend = backend_.make();
    std::optional<ThreadLimit> limit;
    if (figure_.threads() > 0) {
        limit.emplace(figure_.threads());
    }
    const Document document = figure_.open(console);
    const Explanation explanation = explainFigure(document.figure, {}, *backend, console.task());
    Facts facts = explanationFacts(explanation);
    std::string text = explanationText(explanation);
    if (visibility_) {
        const VisibilityTable seen = visibilityTable(document.figure, console.task());
        facts["visibility"] = visibilityFacts(seen);
        text += visibilityText(seen);
    }
    if (savings_) {
        const accuracy::Savings saved = accuracy::measureSavings(document.figure, *backend, {}, console.task());
        facts["savings"] = savingsFacts(saved);
        text += savingsText(saved);
    }
    facts["warnings"] = console.task().warnings();
    if (console.json) {
        printFacts(console, facts);
    } else {
        console.print(text);
    }
    return 0;
}

} // namespace limner::cli
