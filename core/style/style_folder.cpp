#include "core/style/style_folder.h"

#include "core/style/style_files.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace limner {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kKeptRemovals = 20;
constexpr std::size_t kNumberDigits = 6; // of a removal's folder

/// All files that a style of that picture may have; the picture last.
std::vector<fs::path> filesOf(const fs::path& picture) {
    return {textureFileOf(picture), cardFileOf(picture), picture};
}

} // namespace

void failStyleWriting(const fs::path& folder, const std::string& why) {
    throw Error(ErrorKind::noResources,
                {"cannot change the styles in", folder.string(), why,
                 "free some space, allow writing there, or name another folder in LIMNER_STYLES"});
}

fs::path pictureOf(const fs::path& folder, const std::string& id) { return folder / (id + ".png"); }

bool isThere(const fs::path& path) {
    std::error_code unknown;
    return fs::exists(fs::symlink_status(path, unknown));
}

bool isTaken(const fs::path& folder, const std::string& id) {
    const std::vector<fs::path> files = filesOf(pictureOf(folder, id));
    return std::any_of(files.begin(), files.end(), isThere);
}

StyleFolderLock::StyleFolderLock(const fs::path& folder) {
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure) {
        failStyleWriting(folder, failure.message());
    }
    handle_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (handle_ < 0) {
        failStyleWriting(folder, std::strerror(errno));
    }
    while (::flock(handle_, LOCK_EX) != 0 && errno == EINTR) { // a file system without locks is no failure
    }
}

StyleFolderLock::~StyleFolderLock() { ::close(handle_); }

void moveStyle(const fs::path& from, const fs::path& to, PictureTurn turn) {
    std::vector<fs::path> old = filesOf(from);
    std::vector<fs::path> now = filesOf(to);
    if (turn == PictureTurn::first) {
        std::reverse(old.begin(), old.end());
        std::reverse(now.begin(), now.end());
    }
    for (std::size_t i = 0; i < old.size(); ++i) {
        std::error_code failure;
        if (isThere(old[i])) {
            fs::rename(old[i], now[i], failure);
        }
        if (failure) {
            for (std::size_t back = 0; back < i; ++back) {
                std::error_code ignored; // what was not there does not come back either
                fs::rename(now[back], old[back], ignored);
            }
            failStyleWriting(old[i].parent_path(), failure.message());
        }
    }
}

std::vector<fs::path> styleRemovals(const fs::path& folder) {
    std::vector<fs::path> removals;
    std::error_code missing;
    for (fs::directory_iterator at(folder / kRemovedStyles, missing), end; !missing && at != end;
         at.increment(missing)) {
        if (at->path().filename().string().find(' ') == kNumberDigits) {
            removals.push_back(at->path());
        }
    }
    std::sort(removals.begin(), removals.end());
    return removals;
}

std::string idOfRemoval(const fs::path& removal) { return removal.filename().string().substr(kNumberDigits + 1); }

fs::path nextRemoval(const fs::path& folder, const std::string& id) {
    const std::vector<fs::path> removals = styleRemovals(folder);
    const long last = removals.empty() ? 0 : std::strtol(removals.back().filename().c_str(), nullptr, 10);
    std::string number = std::to_string(last + 1);
    number.insert(0, kNumberDigits - std::min(number.size(), kNumberDigits), '0');
    return folder / kRemovedStyles / (number + " " + id);
}

void forgetOldRemovals(const fs::path& folder) {
    const std::vector<fs::path> removals = styleRemovals(folder);
    for (std::size_t i = 0; i + kKeptRemovals < removals.size(); ++i) {
        std::error_code ignored;
        fs::remove_all(removals[i], ignored);
    }
}

} // namespace limner
