#include "core/base/error.h"
#include "core/base/pending_file.h"
#include "core/figure/figure_json.h"
#include "core/project/archive.h"
#include "core/project/backup.h"
#include "core/project/embedded_volume.h"
#include "core/project/project.h"
#include "core/style/background_picture.h"
#include "core/style/png_writing.h"
#include "core/style/style_files.h"

#include <zlib.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>
#include <set>
#include <span>
#include <sstream>

#include <unistd.h>

namespace limner {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& why) {
    throw Error(ErrorKind::noResources,
                {"cannot save the project", path.string(), why, "free some space or choose another folder"});
}

std::string fileBytes(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream bytes;
    bytes << file.rdbuf();
    return bytes.str();
}

/// A file name from a style's id: letters, digits, hyphens and underscores stay.
std::string safeName(const std::string& id) {
    std::string name;
    for (const char c : id.substr(0, 100)) { // far from any file system's limit
        const bool plain =
            (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
        name += plain ? c : '_';
    }
    return name.empty() ? "style" : name;
}

/// What is to be said of a style in the project: the card beside its picture, where there is one, under the figure's
/// words.
StyleCard cardOf(const StyleEntry& style, const fs::path& picture) {
    StyleCard card;
    std::error_code ignored;
    if (const fs::path file = cardFileOf(picture); fs::is_regular_file(file, ignored)) {
        try {
            card = loadStyleCard(file);
        } catch (const Error&) { // a broken card must not keep a project from being saved
            card = {};
        }
    }
    card.origin = card.origin.empty() ? picture.filename().string() : card.origin;
    card.id = style.id;
    card.name = style.name;
    card.credit = style.credit;
    card.licence = style.licence;
    return card;
}

std::uint32_t crcOf(const std::string& bytes) {
    return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()));
}

/// What goes into the file, made before anything is written.
class Contents {
  public:
    Contents(const Document& document, const fs::path& target, const SaveOptions& options, Task& task)
        : figure_(document.figure), target_(target), task_(task) {
        std::error_code ignored;
        if (fs::exists(document.path, ignored) && looksLikeArchive(document.path)) {
            old_.emplace(document.path);
        }
        placeVolume(figure_.volume, document.volumeReport, options.embedVolume);
        placeVolume(figure_.secondVolume, {}, false);
        if (figure_.labels) {
            placeBeside(figure_.labels->path, figure_.labels->absolutePath);
            if (options.embedVolume) {
                task.warn("the labels " + figure_.labels->path + " stay outside the project; keep them with it");
            }
        }
        placeStyles(document);
        placeBackground();
        placeOther(options);
        figureText_ = writeFigure(figure_);
        NewEntry figure;
        figure.name = "figure.json";
        figure.bytes = figureText_;
        entries_.insert(entries_.begin(), std::move(figure));
    }

    [[nodiscard]] const std::string& figureText() const { return figureText_; }
    [[nodiscard]] const std::vector<NewEntry>& entries() const { return entries_; }

  private:
    [[nodiscard]] bool isBare() const { return target_.extension() == ".json"; }

    void add(const std::string& name, std::string bytes, bool compress) {
        NewEntry entry;
        entry.name = name;
        entry.bytes = std::move(bytes);
        entry.compress = compress;
        names_.insert(name);
        entries_.push_back(std::move(entry));
    }

    /// Copies an entry of the document's old file as it is.
    bool keep(const std::string& name) {
        const ArchiveEntry* entry = old_ ? old_->find(name) : nullptr;
        if (entry == nullptr || !names_.insert(name).second) {
            return entry != nullptr;
        }
        NewEntry copy;
        copy.name = name;
        copy.source = &*old_;
        copy.sourceIndex = entry->index;
        entries_.push_back(std::move(copy));
        return true;
    }

    void placeVolume(std::optional<VolumeReference>& reference, const ImportReport& report, bool embed) {
        if (!reference) {
            return;
        }
        if (embed && reference->data != nullptr && !isBare() && !(reference->embedded && keep("volume.nrrd"))) {
            NewEntry entry;
            entry.name = "volume.nrrd";
            entry.file = temporary_.path() / "volume.nrrd";
            entry.compress = false; // packed already
            reference->sha256 = writeNrrd(*reference->data, entry.file, task_);
            reference->embedded = true;
            reference->raw.clear();
            reference->series.clear();
            names_.insert(entry.name);
            entries_.push_back(std::move(entry));
            return;
        }
        if (reference->embedded && !isBare() && keep("volume.nrrd")) {
            return;
        }
        reference->embedded = false;
        if (reference->data != nullptr && !report.sha256Values.empty()) {
            reference->sha256 = report.sha256Values;
            reference->bytes = static_cast<std::int64_t>(report.fileBytes);
        }
        placeBeside(reference->path, reference->absolutePath);
    }

    /// Makes a path relative to the new place, so that project and scan may move together.
    void placeBeside(std::string& path, const fs::path& absolute) const {
        std::error_code failure;
        if (!absolute.empty() && fs::exists(absolute, failure)) {
            const fs::path folder = fs::weakly_canonical(fs::absolute(target_).parent_path(), failure);
            const fs::path relative = absolute.lexically_relative(folder);
            path = relative.empty() ? absolute.string() : relative.string();
        }
    }

    void placeStyles(const Document& document) {
        for (StyleEntry& style : figure_.styles) {
            if (stays(document, style.file)) {
                keep(cardFileOf(style.file).string());
            } else if (style.sphere != nullptr) {
                const std::string name = placePicture(safeName(style.id), pngBytes(*style.sphere));
                const bool inArchive = old_ || style.file.empty();
                placeCard(name + ".json",
                          cardOf(style, inArchive ? fs::path(style.file) : folderOf(document.path) / style.file));
                style.file = name + ".png";
            }
            if (style.texture && !stays(document, style.texture->file) && style.texture->tile != nullptr) {
                style.texture->file =
                    placePicture(safeName(style.id) + "-texture", pngBytes(*style.texture->tile)) + ".png";
            }
        }
    }

    /// Puts a picture into "styles", under the name of one that is the same already or under a new one, so that saving
    /// again adds nothing and nothing is replaced that another figure may use. Gives the name without its ending.
    std::string placePicture(const std::string& stem, std::string png) {
        std::string name = "styles/" + stem;
        while (!isFree(name + ".png")) {
            if (holds(name + ".png", png)) {
                keep(name + ".png");
                return name;
            }
            name += "_";
        }
        add(name + ".png", std::move(png), false);
        return name;
    }

    void placeCard(const std::string& name, const StyleCard& card) {
        const std::string old = textAt(name);
        if (names_.contains(name)) {
            return; // a second style of the same name and picture
        }
        try {
            add(name, cardText(card, old, name), true);
        } catch (const Error&) { // the old one is broken
            add(name, cardText(card), true);
        }
    }

    [[nodiscard]] bool isFree(const std::string& name) const {
        std::error_code ignored;
        return !names_.contains(name) &&
               (isBare() ? !fs::exists(target_.parent_path() / name, ignored) : !(old_ && old_->find(name) != nullptr));
    }

    /// Whether an entry, of the old file or the new, or a file beside a bare figure has these bytes.
    [[nodiscard]] bool holds(const std::string& name, const std::string& bytes) const {
        const auto fresh = std::find_if(entries_.begin(), entries_.end(), [&](const NewEntry& entry) {
            return entry.name == name && entry.source == nullptr;
        });
        if (fresh != entries_.end()) {
            return fresh->bytes == bytes;
        }
        if (isBare()) {
            return fileBytes(target_.parent_path() / name) == bytes;
        }
        const ArchiveEntry* entry = old_ ? old_->find(name) : nullptr;
        return entry != nullptr && entry->size == bytes.size() && entry->crc == crcOf(bytes);
    }

    /// What a card that is to be replaced says; empty where there is none.
    [[nodiscard]] std::string textAt(const std::string& name) const {
        if (isBare()) {
            return fileBytes(target_.parent_path() / name);
        }
        const ArchiveEntry* entry = old_ ? old_->find(name) : nullptr;
        return entry == nullptr ? "" : old_->read(*entry);
    }

    /// The picture goes into the project as it is; a bare figure keeps its path, unless the picture lies in an archive.
    void placeBackground() {
        Background& background = figure_.background;
        std::error_code ignored;
        if (background.kind != "image" || background.picture == nullptr ||
            !fs::is_regular_file(background.picture->file(), ignored)) {
            return; // what was not found stays as it is written
        }
        const fs::path file = background.picture->file();
        if (isBare() && !(old_ && old_->find(background.file) != nullptr)) {
            const fs::path folder = fs::weakly_canonical(fs::absolute(target_).parent_path(), ignored);
            const fs::path relative = fs::weakly_canonical(file, ignored).lexically_relative(folder);
            const bool below = !relative.empty() && *relative.begin() != "..";
            background.file = below ? relative.string() : file.string();
            return;
        }
        std::string ending = file.extension().string();
        std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
        NewEntry entry;
        entry.name = "background" + ending;
        if (kindOf(entry.name) != EntryKind::background) { // projects hold the usual formats only
            background.file = file.string();
            return;
        }
        entry.file = file;
        entry.compress = false;
        background.file = entry.name;
        names_.insert(entry.name);
        entries_.push_back(std::move(entry));
    }

    /// Whether a picture needs no writing: bundled, in the document's old file (whose entry is kept), or beside a bare
    /// figure already.
    bool stays(const Document& document, const std::string& file) {
        if (file.starts_with("bundled:")) {
            return true;
        }
        if (old_ && old_->find(file) != nullptr && !isBare()) {
            return keep(file);
        }
        std::error_code ignored;
        return isBare() && !old_ && !file.empty() && fs::path(file).is_relative() &&
               fs::equivalent(folderOf(document.path), folderOf(target_), ignored);
    }

    void placeOther(const SaveOptions& options) {
        if (!options.thumbnailPng.empty()) {
            add("thumbnail.png",
                std::string(reinterpret_cast<const char*>(options.thumbnailPng.data()), options.thumbnailPng.size()),
                false);
        }
        if (!old_) {
            return;
        }
        // Pictures of styles no longer in use and what a newer version put there go along; of backgrounds the one that
        // the figure names.
        for (const ArchiveEntry& entry : old_->entries()) {
            if (entry.kind == EntryKind::background && entry.name != figure_.background.file) {
                continue;
            }
            if (entry.kind != EntryKind::figure && entry.kind != EntryKind::volume && entry.kind != EntryKind::folder) {
                keep(entry.name);
            }
        }
    }

    Figure figure_;
    fs::path target_;
    Task& task_;
    TemporaryFolder temporary_;
    std::optional<Archive> old_;
    std::set<std::string> names_;
    std::vector<NewEntry> entries_;
    std::string figureText_;
};

/// Reads the fresh file back, every entry of it, before it may take the old one's place.
void verify(const fs::path& temporary, const Contents& contents, Task& task) {
    const Archive archive(temporary);
    for (const NewEntry& entry : contents.entries()) {
        task.throwIfCancelled();
        const ArchiveEntry* written = archive.find(entry.name);
        if (written == nullptr) {
            fail(temporary, "the entry " + entry.name + " is missing after writing");
        }
        if (entry.name == "figure.json") {
            if (archive.read(*written) != contents.figureText()) {
                fail(temporary, "figure.json is not what was written");
            }
        } else {
            archive.readInto(*written, [](std::span<const char>) {}); // checks the CRC
        }
    }
}

/// A bare figure.json: pictures beside it first, so that it never names one that is not there.
void saveBare(const Contents& contents, const fs::path& path, Task& task) {
    for (const NewEntry& entry : contents.entries()) {
        const bool picture = entry.name.starts_with("styles/") || entry.name.starts_with("background.");
        if (picture && entry.source == nullptr) {
            const fs::path place = path.parent_path() / entry.name;
            std::error_code ignored;
            fs::create_directories(place.parent_path(), ignored);
            writeWholeFile(place, entry.file.empty() ? entry.bytes : fileBytes(entry.file));
        }
    }
    PendingFile file(path);
    std::fwrite(contents.figureText().data(), 1, contents.figureText().size(), file.stream());
    file.check();
    Backup backup(path);
    file.commit();
    backup.rotate(task);
}

/// The file that links lead to: it is replaced, not the link.
fs::path followed(const fs::path& path) {
    std::error_code failure;
    const fs::path target = fs::is_symlink(path, failure) ? fs::weakly_canonical(path, failure) : path;
    return failure ? path : target;
}

} // namespace

void saveDocument(const Document& document, const fs::path& path, const SaveOptions& options, Task& task) {
    const fs::path target = followed(path);
    removeStaleParts(target);
    const Contents contents(document, target, options, task);
    if (target.extension() == ".json") {
        saveBare(contents, target, task);
        return;
    }
    PendingFile file(target);
    writeArchive(file.stream(), target, contents.entries());
    file.check();
    if (std::fflush(file.stream()) != 0 || ::fsync(::fileno(file.stream())) != 0) {
        fail(target, std::strerror(errno));
    }
    verify(file.temporaryPath(), contents, task);
    Backup backup(target);
    file.commit();
    backup.rotate(task);
}

} // namespace limner
