#include "app/cli/scene_test.h"

#include "app/cli/console.h"
#include "app/cli/facts.h"
#include "core/base/error.h"
#include "renderer/accuracy/self_test.h"
#include "renderer/backend_choice.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <memory>
#include <vector>

namespace limner::cli {

namespace {

using Facts = nlohmann::ordered_json;

/// The backends that are asked for; without a name those that work here.
std::vector<std::unique_ptr<Backend>> backendsFor(const std::string& name) {
    std::vector<std::unique_ptr<Backend>> backends;
    for (const char* each : {"reference", "cpu", "gl"}) {
        if (!name.empty() && name != "auto" && name != each) {
            continue;
        }
        try {
            backends.push_back(makeBackend(each, "auto"));
        } catch (const Error& error) {
            if (name == each || error.kind() != ErrorKind::noOpenGl) {
                throw;
            }
        }
    }
    return backends;
}

std::string digits(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.10g", value);
    return text;
}

std::string size(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2g", value);
    return text;
}

} // namespace

int runSceneTest(const std::string& backend, Console& console) {
    std::vector<std::vector<std::string>> rows = {
        {"backend", "scene", "quantity", "expected", "observed", "error", "bound", ""}};
    Facts list = Facts::array();
    int failed = 0;
    for (const auto& one : backendsFor(backend)) {
        for (const accuracy::SceneReport& report : accuracy::selfTest(*one, console.task())) {
            failed += report.passed ? 0 : 1;
            rows.push_back({one->name(), report.scene, report.quantity, digits(report.expected),
                            digits(report.observed), size(report.error), size(report.bound),
                            report.passed ? "pass" : "FAIL: " + report.reason});
            list.push_back({{"backend", one->name()},
                            {"scene", report.scene},
                            {"quantity", report.quantity},
                            {"expected", report.expected},
                            {"observed", report.observed},
                            {"error", report.error},
                            {"bound", report.bound},
                            {"reason", report.reason},
                            {"passed", report.passed}});
        }
    }
    if (console.json) {
        printFacts(console, Facts{{"passed", failed == 0}, {"scenes", list}});
    } else {
        console.print(textTable(rows));
        console.say(failed == 0 ? "every scene passed" : std::to_string(failed) + " failed");
    }
    return failed == 0 ? 0 : static_cast<int>(ErrorKind::orderFailed);
}

} // namespace limner::cli
