#pragma once

#include "core/figure/figure.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace limner::testing {

/// Names of the folders of tests/golden that hold a case, in order.
std::vector<std::string> goldenCases();

std::filesystem::path goldenFolder(const std::string& name);

/// The figure of a case with everything in place; nothing, and a counted word about it, where its scan is absent.
std::optional<Figure> loadGolden(const std::string& name);

} // namespace limner::testing
