#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace limner::testing {

/// Path of a file or folder of the test scans, or nothing (and one more counted and printed skip) where it is absent.
std::optional<std::filesystem::path> testData(const std::string& relative);

} // namespace limner::testing
