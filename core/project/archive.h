#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

struct zip_stat; // of libzip

namespace limner {

/// A `.limner` file is a zip (spec figure-document.md). Internal to core/project. Nothing is ever unpacked by the names
/// inside: entries are read into memory or to files of our own naming.

/// What an entry's name says it is; every other safe name is `other`, kept through a save but never opened.
enum class EntryKind { figure, style, styleCard, background, thumbnail, volume, folder, other };

/// By the entry's name alone.
EntryKind kindOf(const std::string& name);

struct ArchiveEntry {
    std::string name;
    EntryKind kind = EntryKind::other;
    std::uint64_t size = 0; ///< unpacked
    std::uint64_t packed = 0;
    std::uint32_t crc = 0;
    std::uint64_t index = 0;
};

/// A zip opened for reading. Every name, size and ratio is checked before anything is unpacked (spec reliability.md
/// 4.2). Throws Error(badInput) with one line for anything that is not a sound project. Not thread-safe.
class Archive {
  public:
    explicit Archive(const std::filesystem::path& path);
    ~Archive();
    Archive(const Archive&) = delete;
    Archive& operator=(const Archive&) = delete;

    [[nodiscard]] const std::vector<ArchiveEntry>& entries() const { return entries_; }
    [[nodiscard]] const ArchiveEntry* find(const std::string& name) const;
    /// The unpacked bytes, their CRC checked.
    [[nodiscard]] std::string read(const ArchiveEntry& entry) const;
    /// The same in pieces, for large entries.
    void readInto(const ArchiveEntry& entry, const std::function<void(std::span<const char>)>& piece) const;
    /// The library's handle, for copying entries as they are.
    [[nodiscard]] void* handle() const { return zip_; }

  private:
    [[noreturn]] void refuse(const std::string& why, const std::string& remedy) const;
    void open();
    void checkEntries();
    [[nodiscard]] ArchiveEntry checkedEntry(const struct zip_stat& stat) const;

    std::filesystem::path path_;
    void* zip_ = nullptr;
    std::vector<ArchiveEntry> entries_;
};

/// Whether the file begins as a zip does.
bool looksLikeArchive(const std::filesystem::path& path);

/// An entry to write: from memory, from a file, or as it lies in another archive.
struct NewEntry {
    std::string name;
    std::string bytes;
    std::filesystem::path file;      ///< instead of `bytes`, where not empty
    const Archive* source = nullptr; ///< instead of both
    std::uint64_t sourceIndex = 0;
    bool compress = true;
};

/// Writes a zip to an open stream. Throws Error(noResources) naming `path`.
void writeArchive(std::FILE* stream, const std::filesystem::path& path, const std::vector<NewEntry>& entries);

/// A private folder that goes with everything in it.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

} // namespace limner
