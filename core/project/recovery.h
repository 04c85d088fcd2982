#pragma once

#include "core/base/file_lock.h"
#include "core/project/project.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace limner {

/// What is kept of unsaved work, for the case that the program or the machine ends without warning. Each running
/// session has a folder of its own below the recovery folder: the figure as figure.json with its styles and two older
/// generations, the scan only where it came from no file of its own, a thumbnail, and session.json that says what it
/// is. The folder is held by a lock that goes with the program.

/// LIMNER_RECOVERY, else $XDG_DATA_HOME/limner/recovery, else ~/.local/share/limner/recovery.
std::filesystem::path recoveryFolder();

/// Unsaved work of a session that has ended.
struct RecoveryEntry {
    std::filesystem::path folder;
    std::string name;                ///< of the document, for people
    std::filesystem::path project;   ///< empty: it was never saved
    std::int64_t savedAt = 0;        ///< seconds since 1970
    std::int64_t process = 0;        ///< id of the program that wrote it
    std::filesystem::path thumbnail; ///< a PNG; empty: none
};

/// All of them, newest first. Sessions that still run are not among them. Does not throw: what cannot be read is left
/// where it is and not listed.
std::vector<RecoveryEntry> unsavedWork(const std::filesystem::path& folder);

/// Deletes it for good; does nothing where a running session has taken it.
void discardWork(const RecoveryEntry& entry);

/// Work of another session that has been opened, and is held so that nobody else takes it. Let go of, it stays where it
/// was.
struct RestoredWork {
    Document document; ///< its path is the project's
    std::filesystem::path folder;
    std::optional<FileLock> lock;
    std::weak_ptr<const Volume> keptVolume; ///< that lies in the folder
    std::string keptSum;                    ///< of its numbers as written
};

/// Opens it. A newest generation that is damaged gives way to an older one, with a note. Throws Error: another session
/// has taken it, or no generation can be read.
RestoredWork openWork(const RecoveryEntry& entry, Task& task);

/// A document as it is to be kept.
struct UnsavedDocument {
    Document document; ///< its path is the project's
    std::string name;
    std::vector<std::byte> thumbnailPng; ///< empty: none
};

/// The autosaves of one running session. One thread at a time.
class RecoverySession {
  public:
    /// Makes nothing yet. Destroyed, it leaves what it wrote: `clear` is what removes it.
    explicit RecoverySession(std::filesystem::path folder) : root_(std::move(folder)) {}

    /// Keeps the document; what was kept before stays until this is whole. Throws Error(noResources, cancelled).
    void write(const UnsavedDocument& unsaved, Task& task);
    /// Nothing is unsaved any more.
    void clear();
    /// Restored work is this session's from now on: it stays where it lies, so that a second crash loses nothing. What
    /// this session kept of its own goes.
    void adopt(RestoredWork work);

    /// Where this session writes; empty: nothing is kept.
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

  private:
    void begin();
    void keepVolume(Document& document, Task& task);

    std::filesystem::path root_;
    std::filesystem::path folder_;
    std::optional<FileLock> lock_;
    std::weak_ptr<const Volume> keptVolume_; ///< that lies in the folder
    std::string keptSum_;                    ///< of its numbers as written
};

} // namespace limner
