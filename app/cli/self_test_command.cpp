#include "app/cli/self_test_command.h"

#include "app/cli/console.h"
#include "app/cli/facts.h"
#include "app/cli/words.h"
#include "core/base/error.h"
#include "renderer/accuracy/formula_vectors.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstdio>

namespace limner::cli {

namespace {

using Facts = nlohmann::ordered_json;

constexpr const char* kExamples = R"(Examples:
  limner self-test
  limner self-test --vectors vectors.jsonl --backend cpu
)";

std::string errorText(double error) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2g", error);
    return text;
}

Facts factsOf(const FormulaEngine& engine, const FormulaReport& report) {
    return {{"backend", engine.backend},
            {"target", engine.target},
            {"formula", report.formula},
            {"count", report.count},
            {"largest_absolute", report.largestAbsolute},
            {"largest_relative", report.largestRelative},
            {"worst", report.worst},
            {"bound", report.bound},
            {"passed", report.passed}};
}

} // namespace

void SelfTestCommand::declare(CLI::App& app) {
    app.description("Checks the formulas on this machine\n"
                    "Evaluates every formula in double precision (reference) and in single precision with each\n"
                    "instruction set that the processor has (cpu) and in GLSL with every OpenGL library that works\n"
                    "(gl), against values known to many digits. Prints, for each formula, the largest errors and\n"
                    "where the worst was. Bounds: 1e-12 relative in double, 2e-6 of the natural range in single\n"
                    "precision. Exit code 9 where a formula fails, 4 where --backend gl finds no OpenGL.");
    app.footer(kExamples);
    app.add_option("--vectors", vectors_, "A file of test vectors (JSON lines) instead of the built-in values")
        ->option_text("FILE");
    app.add_option("--backend", backend_, "Only this one: reference, cpu or gl")->option_text("NAME");
}

int SelfTestCommand::run(Console& console) {
    if (!backend_.empty()) {
        checkKnown({"reference", "cpu", "gl"}, backend_, "--backend");
    }
    const std::vector<FormulaEngine> engines = formulaEngines(backend_);
    if (engines.empty()) {
        throw Error(ErrorKind::noOpenGl, {"the formulas cannot be checked in GLSL", "", "no OpenGL library works here",
                                          "`limner doctor` says why"});
    }
    const std::vector<FormulaVector> vectors =
        vectors_.empty() ? publishedFormulaValues() : readFormulaVectors(vectors_);
    std::vector<std::vector<std::string>> rows = {
        {"backend", "target", "formula", "count", "absolute", "relative", "worst", ""}};
    Facts list = Facts::array();
    int failed = 0;
    for (const FormulaEngine& engine : engines) {
        for (const FormulaReport& report : checkFormulas(vectors, engine)) {
            failed += report.passed ? 0 : 1;
            rows.push_back({engine.backend, engine.target, report.formula, std::to_string(report.count),
                            errorText(report.largestAbsolute), errorText(report.largestRelative), report.worst,
                            report.passed ? "pass" : "FAIL: not within " + report.bound});
            list.push_back(factsOf(engine, report));
        }
    }
    if (console.json) {
        printFacts(console, Facts{{"passed", failed == 0}, {"formulas", list}});
    } else {
        console.print(textTable(rows));
        console.say(failed == 0 ? "every formula passed" : std::to_string(failed) + " failed");
    }
    return failed == 0 ? 0 : static_cast<int>(ErrorKind::orderFailed);
}

} // namespace limner::cli
