#pragma once

#include "core/base/task.h"

#include <filesystem>

namespace limner {

/// What keeps an old project while a new one takes its place. Internal to core/project.

/// The folder that a file is in, "." for a bare name.
std::filesystem::path folderOf(const std::filesystem::path& file);

/// The old file under a second name until the new one stands; then it becomes the newest of two backups, NAME~. Throws
/// Error(noResources).
class Backup {
  public:
    explicit Backup(std::filesystem::path path);
    ~Backup();
    Backup(const Backup&) = delete;
    Backup& operator=(const Backup&) = delete;

    /// Warns where it cannot be kept.
    void rotate(Task& task);

  private:
    std::filesystem::path path_;
    std::filesystem::path held_;
};

} // namespace limner
