#pragma once

#include "core/base/task.h"
#include "core/figure/figure.h"
#include "core/volume/import.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace limner {

/// Looking for files that are not where a project says: scans that moved, were renamed, or came along on another disc.

/// Where to look: the project's folder, its two parents, and the folders of other files that were open lately; each
/// once, none that lies at the root of the disc.
std::vector<std::filesystem::path> searchFolders(const std::filesystem::path& project,
                                                 const std::vector<std::filesystem::path>& recent);

struct FoundVolume {
    std::filesystem::path path;
    ImportedVolume imported;
};

/// The scan of a reference, below these folders: what has its name and size first, then its size, then its name; what
/// is taken has its numbers' SHA-256. A reference without a checksum is content with name and size. Three folders deep,
/// twenty thousand files at most. Nothing where it is not found. Throws Error(cancelled, noResources).
std::optional<FoundVolume> findVolume(const VolumeReference& reference,
                                      const std::vector<std::filesystem::path>& folders, Task& task);

/// The first file or folder of that name below the folders, nearest first.
std::optional<std::filesystem::path> findByName(const std::string& name,
                                                const std::vector<std::filesystem::path>& folders, Task& task);

} // namespace limner
