#pragma once

#include <cstdio>
#include <filesystem>

namespace limner {

/// A file in the making: written beside its final name (same folder, so that the rename is atomic), synced and renamed
/// by `commit`. Destroyed without a commit it leaves nothing, and neither does a program that calls
/// `removePendingFiles` when a signal ends it. Not thread-safe.
class PendingFile {
  public:
    /// A link as the final name is followed. Throws Error(noResources) where the file cannot be made.
    explicit PendingFile(const std::filesystem::path& finalPath);
    ~PendingFile();
    PendingFile(const PendingFile&) = delete;
    PendingFile& operator=(const PendingFile&) = delete;

    /// For reading and writing, buffered.
    [[nodiscard]] std::FILE* stream() const { return stream_; }
    [[nodiscard]] const std::filesystem::path& temporaryPath() const { return temporary_; }
    /// Throws Error(noResources), with the system's reason, when a write to the stream has failed.
    void check();
    /// Flushes, syncs, closes, renames, syncs the folder. Throws Error(noResources); then the old file is as it was.
    void commit();

  private:
    [[noreturn]] void fail(int systemError) const;

    std::filesystem::path final_;
    std::filesystem::path temporary_;
    std::FILE* stream_ = nullptr;
    int slot_ = -1; ///< in the table that `removePendingFiles` reads
};

/// Deletes every pending file of the process. Async-signal-safe: for a signal handler that is about to end the process.
void removePendingFiles() noexcept;

/// Removes what a program that was killed while it wrote that file has left beside it. None writes for ten minutes
/// without a pause.
void removeStaleParts(const std::filesystem::path& finalPath);

} // namespace limner
