#pragma once

#include "core/base/file_lock.h"

#include <filesystem>
#include <optional>
#include <string>

namespace limner {

/// Who has a project open: `.NAME.lock` beside it, held as long as its document is open.

/// Holds the project for this program; nothing where another one has it. Where the folder cannot be written or its
/// file system knows no locks, nobody can hold it: Error(noResources).
std::optional<FileLock> lockProject(const std::filesystem::path& project);
/// "process 4711 on anna's-machine" of the program that has it open; nothing where none has.
std::optional<std::string> projectHolder(const std::filesystem::path& project);

} // namespace limner
