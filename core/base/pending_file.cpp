#include "core/base/pending_file.h"

#include "core/base/error.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <random>

#include <fcntl.h>
#include <unistd.h>

namespace limner {

namespace {

/// What a signal handler may read: fixed memory and lock-free flags.
struct Slot {
    enum State { unused, filling, armed };
    std::atomic<int> state{unused};
    std::array<char, 4096> path{}; // PATH_MAX
};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may not lock");

constexpr int kSlots = 16; // files written at one time; a file beyond that is only not removed by a signal
std::array<Slot, kSlots> slots;

int arm(const std::string& path) {
    if (path.size() >= slots[0].path.size()) {
        return -1;
    }
    for (int i = 0; i < kSlots; ++i) {
        int expected = Slot::unused;
        Slot& slot = slots[static_cast<std::size_t>(i)];
        if (slot.state.compare_exchange_strong(expected, Slot::filling)) {
            std::memcpy(slot.path.data(), path.c_str(), path.size() + 1);
            slot.state.store(Slot::armed);
            return i;
        }
    }
    return -1;
}

void disarm(int slot) {
    if (slot >= 0) {
        slots[static_cast<std::size_t>(slot)].state.store(Slot::unused);
    }
}

/// The file that a chain of links ends at.
std::filesystem::path followed(const std::filesystem::path& path) {
    std::error_code ignored;
    if (!std::filesystem::is_symlink(path, ignored)) {
        return path;
    }
    auto target = std::filesystem::weakly_canonical(path, ignored);
    return ignored ? path : target;
}

std::string remedyFor(int systemError) {
    switch (systemError) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG: return "free some space or choose another folder";
    case ENOENT:
    case ENOTDIR: return "make the folder first";
    default: return "choose another place";
    }
}

} // namespace

PendingFile::PendingFile(const std::filesystem::path& finalPath) : final_(followed(finalPath)) {
    std::random_device random;
    int file = -1;
    for (int attempt = 0; attempt < 100 && file < 0; ++attempt) { // 100: names are random, a second try is rare
        // The name is cut so that it stays legal beside a final name of the greatest legal length.
        const std::string stem = final_.filename().string().substr(0, 200);
        temporary_ = final_.parent_path() / ("." + stem + "." + std::to_string(random()) + ".part");
        file = ::open(temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file < 0 && errno != EEXIST) {
            fail(errno);
        }
    }
    if (file < 0) {
        fail(EEXIST);
    }
    slot_ = arm(temporary_.string());
    stream_ = ::fdopen(file, "w+b");
    if (stream_ == nullptr) {
        const int systemError = errno;
        ::close(file);
        ::unlink(temporary_.c_str());
        disarm(slot_);
        fail(systemError);
    }
    std::setvbuf(stream_, nullptr, _IOFBF,
                 std::size_t{1} << 20); // few large writes, whatever the format's library does
}

PendingFile::~PendingFile() {
    if (stream_ != nullptr) {
        std::fclose(stream_);
        ::unlink(temporary_.c_str());
        disarm(slot_);
    }
}

void PendingFile::fail(int systemError) const {
    throw Error(ErrorKind::noResources,
                {"cannot write the file", final_.string(), std::strerror(systemError), remedyFor(systemError)});
}

void PendingFile::check() {
    if (std::ferror(stream_) == 0) {
        return;
    }
    // The reason is long overwritten: the same write fails for the same reason again.
    std::clearerr(stream_);
    errno = 0;
    const char zero = 0;
    const bool passes =
        std::fseek(stream_, 0, SEEK_END) == 0 && std::fwrite(&zero, 1, 1, stream_) == 1 && std::fflush(stream_) == 0;
    fail(passes || errno == 0 ? EIO : errno);
}

void PendingFile::commit() {
    check();
    if (std::fflush(stream_) != 0 || ::fsync(::fileno(stream_)) != 0) {
        fail(errno);
    }
    if (::rename(temporary_.c_str(), final_.c_str()) != 0) {
        fail(errno);
    }
    disarm(slot_);
    std::fclose(stream_); // everything is synced already
    stream_ = nullptr;
    const auto folder = final_.has_parent_path() ? final_.parent_path() : std::filesystem::path(".");
    if (const int handle = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); handle >= 0) {
        ::fsync(handle); // the name too; a file system that cannot is no failure
        ::close(handle);
    }
}

void removePendingFiles() noexcept {
    for (Slot& slot : slots) {
        if (slot.state.load() == Slot::armed) {
            ::unlink(slot.path.data());
        }
    }
}

void removeStaleParts(const std::filesystem::path& finalPath) {
    namespace fs = std::filesystem;
    const std::string start = "." + finalPath.filename().string().substr(0, 200) + ".";
    std::error_code ignored;
    for (const auto& entry :
         fs::directory_iterator(finalPath.has_parent_path() ? finalPath.parent_path() : ".", ignored)) {
        const std::string name = entry.path().filename().string();
        const auto age = fs::file_time_type::clock::now() - entry.last_write_time(ignored);
        if (name.starts_with(start) && name.ends_with(".part") && age > std::chrono::minutes(10)) {
            fs::remove(entry.path(), ignored);
        }
    }
}

} // namespace limner
