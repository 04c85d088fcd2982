#include "core/project/project_lock.h"

#include "core/project/backup.h"

#include <array>

#include <unistd.h>

namespace limner {
namespace {

namespace fs = std::filesystem;

/// Links to one project share its lock.
fs::path lockFileOf(const fs::path& project) {
    std::error_code failure;
    fs::path file = fs::weakly_canonical(fs::absolute(project), failure);
    file = failure ? project : file;
    return folderOf(file) / ("." + file.filename().string().substr(0, 200) + ".lock"); // a legal name stays legal
}

} // namespace

std::optional<FileLock> lockProject(const fs::path& project) {
    std::array<char, 128> host{}; // longer names are cut
    if (::gethostname(host.data(), host.size() - 1) != 0) {
        host[0] = '?';
    }
    return FileLock::take(lockFileOf(project), "process " + std::to_string(::getpid()) + " on " + host.data());
}

std::optional<std::string> projectHolder(const fs::path& project) { return FileLock::holderOf(lockFileOf(project)); }

} // namespace limner
