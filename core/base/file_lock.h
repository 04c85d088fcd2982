#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace limner {

/// A file that one running program holds. The system lets go of it when the program ends, however it ends, so what a
/// crash left behind never blocks anybody. The file says who holds it, in words of the holder. Not thread-safe.
class FileLock {
  public:
    /// Makes the file at need and holds it, or nothing where another program (or another FileLock) holds it. Throws
    /// Error(noResources) where the file cannot be made, or its file system knows no locks.
    static std::optional<FileLock> take(const std::filesystem::path& file, const std::string& holder);
    /// What the program that holds the file says of itself; nothing where none does.
    static std::optional<std::string> holderOf(const std::filesystem::path& file);

    FileLock(FileLock&& other) noexcept;
    FileLock& operator=(FileLock&& other) noexcept;
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;
    /// Lets go and removes the file.
    ~FileLock();

  private:
    FileLock(int file, std::filesystem::path path) : file_(file), path_(std::move(path)) {}
    void release();

    int file_ = -1;
    std::filesystem::path path_;
};

} // namespace limner
