#include "core/figure/migration.h"

#include "core/base/error.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace limner {
namespace {

/// Drafts that were written by hand, before or without the version key, mean what version 1 means.
std::string versionOneFromDraft(const std::string& text) {
    auto document = nlohmann::ordered_json::parse(text);
    document["limner"] = 1;
    return document.dump();
}

constexpr MigrationStep kSteps[] = {{0, versionOneFromDraft}};

} // namespace

std::span<const MigrationStep> migrationSteps() { return kSteps; }

std::string migrated(std::string text, int version, int target, std::span<const MigrationStep> steps) {
    for (; version < target; ++version) {
        const auto step =
            std::find_if(steps.begin(), steps.end(), [&](const MigrationStep& s) { return s.from == version; });
        if (step == steps.end()) {
            throw Error(ErrorKind::badInput,
                        {"cannot read the figure", kVersionPointer,
                         "there is no document version " + std::to_string(version), "the version is 1"});
        }
        text = step->migrate(text);
    }
    return text;
}

} // namespace limner
