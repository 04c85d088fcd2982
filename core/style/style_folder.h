#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <string>
#include <vector>

namespace limner {

/// The user's styles as files, below their cards' meaning. Internal to core/style; any thread.

/// Folder of what was removed of late, in the folder of styles.
inline constexpr const char* kRemovedStyles = "removed";

/// Throws Error(noResources) that names the folder and what to do.
[[noreturn]] void failStyleWriting(const std::filesystem::path& folder, const std::string& why);

std::filesystem::path pictureOf(const std::filesystem::path& folder, const std::string& id);
/// Whether a file or folder, or a link that leads nowhere, has that name.
bool isThere(const std::filesystem::path& path);
/// Whether any file has a name that a style with that id would give one of its own.
bool isTaken(const std::filesystem::path& folder, const std::string& id);

/// The folder for one writer at a time, of this and other programs. It is made where it is not there. Throws
/// Error(noResources).
class StyleFolderLock {
  public:
    explicit StyleFolderLock(const std::filesystem::path& folder);
    ~StyleFolderLock();
    StyleFolderLock(const StyleFolderLock&) = delete;
    StyleFolderLock& operator=(const StyleFolderLock&) = delete;

  private:
    int handle_ = -1;
};

/// Runs a change of the folder under its lock; where there is no room or leave, the error names the folder.
template <class Change>
auto changingStyles(const std::filesystem::path& folder, const Change& change) {
    const StyleFolderLock lock(folder);
    try {
        return change();
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::noResources) {
            throw;
        }
        failStyleWriting(folder, error.text().why);
    }
}

/// All files of a style get another name or place, or none does: the picture first where it leaves the folder of
/// styles, last where it comes into it, so that a style without its card is never seen there. Throws
/// Error(noResources).
enum class PictureTurn { first, last };
void moveStyle(const std::filesystem::path& from, const std::filesystem::path& to, PictureTurn turn);

/// Folders of removals, oldest first: "000012 ivory".
std::vector<std::filesystem::path> styleRemovals(const std::filesystem::path& folder);
std::string idOfRemoval(const std::filesystem::path& removal);
/// Where the next removal goes; not made yet.
std::filesystem::path nextRemoval(const std::filesystem::path& folder, const std::string& id);
/// All but the last twenty go for good.
void forgetOldRemovals(const std::filesystem::path& folder);

} // namespace limner
