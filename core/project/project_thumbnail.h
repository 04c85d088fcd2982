#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace limner {

/// The small picture inside a project, as the bytes of a PNG of at most `edge` pixels an edge (it holds 256). Nothing
/// where the file is no project or holds none. Reads nothing else of it. Throws Error(badInput) for a project that is
/// damaged.
std::optional<std::string> projectThumbnail(const std::filesystem::path& project, int edge);

} // namespace limner
