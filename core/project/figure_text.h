#pragma once

#include <filesystem>
#include <string>

namespace limner {

/// The text of a bare figure.json, or of the one inside a `.limner` project, as it stands. Throws Error(badInput) for
/// a file that is not there, no project, or larger than any figure is.
std::string readFigureText(const std::filesystem::path& path);

} // namespace limner
