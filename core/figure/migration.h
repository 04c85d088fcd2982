#pragma once

#include <span>
#include <string>

namespace limner {

/// Version of figure.json that this program writes.
inline constexpr int kFigureVersion = 1;

/// Where the version stands in a document.
inline constexpr const char* kVersionPointer = "/limner";

/// Makes a document of version `from` one of version `from + 1`; JSON text in and out. Throws Error(badInput).
struct MigrationStep {
    int from = 0;
    std::string (*migrate)(const std::string& text) = nullptr;
};

/// The steps of this program, by rising version. Version 0 is a document without a version.
std::span<const MigrationStep> migrationSteps();

/// Takes the text of a document through the steps from `version` to `target`. Throws Error(badInput) where a step is
/// missing.
std::string migrated(std::string text, int version, int target, std::span<const MigrationStep> steps);

} // namespace limner
