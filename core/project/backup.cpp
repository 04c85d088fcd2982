#include "core/project/backup.h"

#include "core/base/error.h"

#include <random>
#include <string>

#include <fcntl.h>
#include <unistd.h>

namespace limner {
namespace {

namespace fs = std::filesystem;

void syncFolder(const fs::path& folder) {
    if (const int handle = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); handle >= 0) {
        ::fsync(handle);
        ::close(handle);
    }
}

} // namespace

fs::path folderOf(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

Backup::Backup(fs::path path) : path_(std::move(path)) {
    std::error_code ignored;
    if (!fs::is_regular_file(path_, ignored)) {
        return;
    }
    held_ = path_.parent_path() /
            ("." + path_.filename().string().substr(0, 200) + "." + std::to_string(std::random_device()()) + ".part");
    // A link costs nothing and the old file never lacks a name; a file system without links gets a copy.
    if (::link(path_.c_str(), held_.c_str()) != 0) {
        std::error_code failure;
        if (!fs::copy_file(path_, held_, failure)) {
            fs::remove(held_, ignored);
            throw Error(ErrorKind::noResources,
                        {"cannot save the project", path_.string(), "the backup cannot be made: " + failure.message(),
                         "free some space or choose another folder"});
        }
    }
}

Backup::~Backup() {
    std::error_code ignored;
    if (!held_.empty()) {
        fs::remove(held_, ignored);
    }
}

void Backup::rotate(Task& task) {
    if (held_.empty()) {
        return;
    }
    const std::string newest = path_.string() + "~";
    std::error_code failure;
    if (fs::exists(newest, failure)) {
        fs::rename(newest, newest + "~", failure);
    }
    fs::rename(held_, newest, failure);
    if (failure) {
        task.warn("the backup " + newest + " could not be kept: " + failure.message());
        return;
    }
    held_.clear();
    syncFolder(folderOf(path_));
}

} // namespace limner
