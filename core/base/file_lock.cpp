#include "core/base/file_lock.h"

#include "core/base/error.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace limner {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path) {
    throw Error(ErrorKind::noResources, {"cannot lock the file", path.string(), std::strerror(errno), ""});
}

/// Whether the open file is still the one of that name: its last holder may have removed it between our opening and
/// our locking.
bool stillNamed(int file, const std::filesystem::path& path) {
    struct stat open {};
    struct stat named {};
    return ::fstat(file, &open) == 0 && ::stat(path.c_str(), &named) == 0 && open.st_ino == named.st_ino &&
           open.st_dev == named.st_dev;
}

std::string textOf(int file) {
    std::array<char, 256> text{}; // a holder's name is one short line
    const ssize_t length = ::pread(file, text.data(), text.size(), 0);
    return {text.data(), static_cast<std::size_t>(length < 0 ? 0 : length)};
}

} // namespace

std::optional<FileLock> FileLock::take(const std::filesystem::path& path, const std::string& holder) {
    while (true) {
        const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
        if (file < 0) {
            fail(path);
        }
        FileLock lock(-1, path);
        if (::flock(file, LOCK_EX | LOCK_NB) != 0) {
            const int reason = errno;
            ::close(file);
            errno = reason;
            if (reason == EWOULDBLOCK) {
                return std::nullopt;
            }
            fail(path);
        }
        if (!stillNamed(file, path)) {
            ::close(file);
            continue;
        }
        lock.file_ = file;
        // A name that cannot be written (a full disk) is only not told to others.
        if (::ftruncate(file, 0) != 0 || ::pwrite(file, holder.data(), holder.size(), 0) < 0) {
            static_cast<void>(::ftruncate(file, 0));
        }
        return lock;
    }
}

std::optional<std::string> FileLock::holderOf(const std::filesystem::path& path) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) {
        return std::nullopt;
    }
    std::optional<std::string> holder;
    if (::flock(file, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        holder = textOf(file);
    }
    ::close(file);
    return holder;
}

FileLock::FileLock(FileLock&& other) noexcept : file_(std::exchange(other.file_, -1)), path_(std::move(other.path_)) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
    if (this != &other) {
        release();
        file_ = std::exchange(other.file_, -1);
        path_ = std::move(other.path_);
    }
    return *this;
}

FileLock::~FileLock() { release(); }

void FileLock::release() {
    if (file_ < 0) {
        return;
    }
    ::unlink(path_.c_str()); // while it is still held: whoever opened it meanwhile sees that it is gone
    ::close(file_);
    file_ = -1;
}

} // namespace limner
