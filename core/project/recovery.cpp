#include "core/project/recovery.h"

#include "core/base/error.h"
#include "core/base/pending_file.h"
#include "core/base/user_folder.h"
#include "core/figure/figure_json.h"
#include "core/project/embedded_volume.h"
#include "core/project/figure_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <fstream>
#include <random>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace limner {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr const char* kFigure = "figure.json";
constexpr const char* kSession = "session.json";
constexpr const char* kThumbnail = "thumbnail.png";
constexpr const char* kVolume = "volume.nrrd";
constexpr const char* kLock = "lock";
constexpr const char* kGenerations[] = {"", "~", "~~"}; // as saving a bare figure keeps them
constexpr auto kAbandoned = std::chrono::hours(1); // a session without a word for so long never got to its first save

std::int64_t secondsNow() {
    return std::chrono::duration_cast<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch())
        .count();
}

void writeWhole(const fs::path& path, const void* bytes, std::size_t count) {
    PendingFile file(path);
    std::fwrite(bytes, 1, count, file.stream());
    file.check();
    file.commit();
}

/// Throws nlohmann's errors.
Json sessionOf(const fs::path& folder) {
    std::ifstream file(folder / kSession);
    return Json::parse(file);
}

Json toJson(const VolumeReference& volume) {
    return {{"path", volume.path},    {"absolute_path", volume.absolutePath}, {"sha256", volume.sha256},
            {"bytes", volume.bytes},  {"embedded", volume.embedded},          {"raw", volume.raw},
            {"series", volume.series}};
}

/// Whether nothing but this session's memory, or a project that may be replaced, holds the scan.
bool needsKeeping(const std::optional<VolumeReference>& volume) {
    return volume && volume->data && (volume->path.empty() || volume->embedded);
}

void setReference(VolumeReference& volume, const Json& from) {
    volume.path = from.value("path", "");
    volume.absolutePath = from.value("absolute_path", "");
    volume.sha256 = from.value("sha256", "");
    volume.bytes = from.value("bytes", std::int64_t{0});
    volume.embedded = from.value("embedded", false);
    volume.raw = from.value("raw", "");
    volume.series = from.value("series", "");
}

/// The newest generation that can be read.
Document openNewest(const fs::path& folder, Task& task) {
    std::optional<Error> first;
    for (const char* generation : kGenerations) {
        const fs::path file = folder / (std::string(kFigure) + generation);
        std::error_code ignored;
        if (!fs::is_regular_file(file, ignored)) {
            continue;
        }
        try {
            Document document;
            document.path = file;
            document.figure = readFigure(readFigureText(file), file.string());
            resolveFigure(document, folder, {}, task);
            if (first) {
                document.notes.insert(document.notes.begin(),
                                      "the newest autosave is damaged; this is the one before it");
            }
            return document;
        } catch (const Error& error) {
            if (error.kind() == ErrorKind::cancelled) {
                throw;
            }
            first = first ? first : error;
        }
    }
    if (first) {
        throw *first;
    }
    throw Error(ErrorKind::badInput, {"cannot restore the unsaved work", folder.string(), "it holds no figure", ""});
}

/// The pictures stay findable once the document has its project's path.
void makeAbsolute(std::string& file, const fs::path& folder) {
    std::error_code ignored;
    if (!file.empty() && fs::path(file).is_relative() && fs::is_regular_file(folder / file, ignored)) {
        file = (folder / file).string();
    }
}

std::optional<RecoveryEntry> entryIn(const fs::path& folder) {
    try {
        std::error_code failure;
        if (!fs::is_regular_file(folder / kSession, failure)) {
            if (fs::file_time_type::clock::now() - fs::last_write_time(folder) > kAbandoned) {
                fs::remove_all(folder, failure);
            }
            return std::nullopt;
        }
        const Json session = sessionOf(folder);
        RecoveryEntry entry;
        entry.folder = folder;
        entry.name = session.at("name").get<std::string>();
        entry.project = session.value("project", "");
        entry.savedAt = session.value("saved_at", std::int64_t{0});
        entry.process = session.value("process", std::int64_t{0});
        if (fs::is_regular_file(folder / kThumbnail, failure)) {
            entry.thumbnail = folder / kThumbnail;
        }
        return entry;
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

} // namespace

fs::path recoveryFolder() { return userFolder("LIMNER_RECOVERY", "recovery"); }

std::vector<RecoveryEntry> unsavedWork(const fs::path& folder) {
    std::vector<RecoveryEntry> entries;
    std::error_code failure;
    for (fs::directory_iterator at(folder, failure), end; !failure && at != end; at.increment(failure)) {
        std::error_code ignored;
        if (!at->is_directory(ignored) || FileLock::holderOf(at->path() / kLock)) {
            continue;
        }
        if (auto entry = entryIn(at->path())) {
            entries.push_back(std::move(*entry));
        }
    }
    std::sort(entries.begin(), entries.end(), [](const RecoveryEntry& a, const RecoveryEntry& b) {
        return std::pair(-a.savedAt, a.folder) < std::pair(-b.savedAt, b.folder);
    });
    return entries;
}

void discardWork(const RecoveryEntry& entry) {
    try {
        if (const auto lock = FileLock::take(entry.folder / kLock, "")) {
            std::error_code ignored;
            fs::remove(entry.folder / kSession, ignored); // first: half of it must not be offered
            fs::remove_all(entry.folder, ignored);
        }
    } catch (const Error&) { // the folder is gone already, or stays
        return;
    }
}

void RecoverySession::begin() {
    if (lock_) {
        return;
    }
    std::error_code failure;
    fs::create_directories(root_, failure);
    std::random_device random;
    const fs::path folder = root_ / ("session-" + std::to_string(::getpid()) + "-" + std::to_string(random()));
    if (failure || !fs::create_directory(folder, failure)) {
        throw Error(ErrorKind::noResources,
                    {"cannot keep the unsaved work", folder.string(), failure.message(), "save the project by hand"});
    }
    fs::permissions(folder, fs::perms::owner_all, failure); // scans are nobody else's business
    lock_ = FileLock::take(folder / kLock, std::to_string(::getpid()));
    folder_ = folder;
}

void RecoverySession::keepVolume(Document& document, Task& task) {
    VolumeReference& volume = *document.figure.volume;
    const fs::path file = folder_ / kVolume;
    std::error_code failure;
    if (keptVolume_.lock() != volume.data || !fs::exists(file, failure)) {
        const fs::path part = folder_ / "volume.part.nrrd";
        keptSum_ = writeNrrd(*volume.data, part, task);
        if (const int handle = ::open(part.c_str(), O_RDONLY | O_CLOEXEC); handle >= 0) {
            ::fsync(handle);
            ::close(handle);
        }
        fs::rename(part, file, failure);
        if (failure) {
            throw Error(ErrorKind::noResources, {"cannot keep the unsaved work", file.string(), failure.message(), ""});
        }
        keptVolume_ = volume.data;
    }
    volume.path = kVolume;
    volume.absolutePath = file.string();
    volume.sha256 = keptSum_;
    volume.bytes = 0;
    volume.embedded = false;
    volume.raw.clear();
    volume.series.clear();
    document.volumeReport = {};
}

void RecoverySession::write(const UnsavedDocument& unsaved, Task& task) {
    begin();
    Document document = unsaved.document;
    Json session{{"name", unsaved.name},
                 {"project", document.path.empty() ? "" : fs::absolute(document.path).string()},
                 {"saved_at", secondsNow()},
                 {"process", ::getpid()}};
    if (needsKeeping(document.figure.volume)) {
        session["volume"] = toJson(*document.figure.volume);
        keepVolume(document, task);
    }
    saveDocument(document, folder_ / kFigure, SaveOptions{}, task);
    if (!unsaved.thumbnailPng.empty()) {
        writeWhole(folder_ / kThumbnail, unsaved.thumbnailPng.data(), unsaved.thumbnailPng.size());
    }
    const std::string text = session.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    writeWhole(folder_ / kSession, text.data(), text.size());
}

void RecoverySession::clear() {
    if (!lock_) {
        return;
    }
    std::error_code ignored;
    fs::remove(folder_ / kSession, ignored); // first: half of it must not be offered
    fs::remove_all(folder_, ignored);
    lock_.reset();
    folder_.clear();
    keptVolume_.reset();
}

RestoredWork openWork(const RecoveryEntry& entry, Task& task) {
    const auto missing = [&](const std::string& why) -> Error {
        return {ErrorKind::badInput, {"cannot restore the unsaved work", entry.folder.string(), why, ""}};
    };
    std::error_code ignored;
    if (!fs::is_directory(entry.folder, ignored)) {
        throw missing("it is not there any more");
    }
    RestoredWork work;
    work.folder = entry.folder;
    work.lock = FileLock::take(entry.folder / kLock, std::to_string(::getpid()));
    if (!work.lock) {
        throw missing("another Limner has restored it");
    }
    work.document = openNewest(entry.folder, task);
    work.document.path = entry.project;
    Json session;
    try {
        session = sessionOf(entry.folder);
    } catch (const Json::exception&) {
        throw missing("its description is damaged");
    }
    Figure& figure = work.document.figure;
    if (figure.volume && session.contains("volume")) {
        work.keptVolume = figure.volume->data;
        work.keptSum = figure.volume->sha256;
        setReference(*figure.volume, session["volume"]);
        work.document.volumeReport.sha256Values.clear(); // of the copy
    }
    for (StyleEntry& style : figure.styles) {
        makeAbsolute(style.file, entry.folder);
        if (style.texture) {
            makeAbsolute(style.texture->file, entry.folder);
        }
    }
    return work;
}

void RecoverySession::adopt(RestoredWork work) {
    clear();
    folder_ = std::move(work.folder);
    lock_ = std::move(work.lock);
    keptVolume_ = work.keptVolume;
    keptSum_ = std::move(work.keptSum);
}

} // namespace limner
