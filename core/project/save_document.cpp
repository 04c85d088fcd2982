#include "core/base/error.h"
#include "core/base/pending_file.h"
#include "core/figure/figure_json.h"
#include "core/project/archive.h"
#include "core/project/embedded_volume.h"
#include "core/project/project.h"
#include "core/style/background_picture.h"

#include <OpenImageIO/imageio.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <optional>
#include <random>
#include <set>
#include <span>
#include <sstream>

#include <fcntl.h>
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

/// 16-bit PNG of a square picture.
std::string picturePng(int size, std::span<const Rgba> pixels, const fs::path& folder) {
    const fs::path path = folder / "style.png";
    OIIO::ImageSpec spec(size, size, 4, OIIO::TypeDesc::UINT16);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("oiio:UnassociatedAlpha", 1); // as the sphere has it
    const auto output = OIIO::ImageOutput::create(path.string());
    const bool written = output != nullptr && output->open(path.string(), spec) &&
                         output->write_image(OIIO::TypeDesc::FLOAT, pixels.data()) && output->close();
    if (!written) {
        fail(path, output == nullptr ? OIIO::geterror() : output->geterror());
    }
    return fileBytes(path);
}

/// The picture that a tile was made of: half its factors.
std::vector<Rgba> tilePicture(const TextureTile& tile) {
    std::vector<Rgba> pixels = tile.pixels();
    for (Rgba& texel : pixels) {
        texel = {texel.r / 2, texel.g / 2, texel.b / 2, 1};
    }
    return pixels;
}

std::string styleCard(const StyleEntry& style) {
    nlohmann::ordered_json card = {{"id", style.id},
                                   {"name", style.name.empty() ? style.id : style.name},
                                   {"origin", style.file},
                                   {"credit", style.credit},
                                   {"licence", style.licence}};
    return card.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
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
                keep(fs::path(style.file).replace_extension(".json").string());
            } else if (style.sphere != nullptr) {
                const std::string name = freshName(safeName(style.id));
                add(name + ".png", picturePng(style.sphere->size(), style.sphere->pixels(), temporary_.path()), false);
                add(name + ".json", styleCard(style), true);
                style.file = name + ".png";
            }
            if (style.texture && !stays(document, style.texture->file) && style.texture->tile != nullptr) {
                const TextureTile& tile = *style.texture->tile;
                const std::string name = freshName(safeName(style.id) + "-texture");
                add(name + ".png", picturePng(tile.size(), tilePicture(tile), temporary_.path()), false);
                style.texture->file = name + ".png";
            }
        }
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
        return isBare() && !old_ && !file.empty() &&
               fs::equivalent(document.path.parent_path(), target_.parent_path(), ignored);
    }

    /// A name for pictures that is neither given yet nor in the old file.
    [[nodiscard]] std::string freshName(const std::string& stem) const {
        std::string name = "styles/" + stem;
        while (names_.count(name + ".png") > 0 || (old_ && old_->find(name + ".png") != nullptr)) {
            name += "_";
        }
        return name;
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

void syncFolder(const fs::path& folder) {
    if (const int handle = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        handle >= 0) {
        ::fsync(handle);
        ::close(handle);
    }
}

/// The old file under a second name until the new one stands; then it becomes the newest backup.
class Backup {
  public:
    explicit Backup(const fs::path& path) : path_(path) {
        std::error_code ignored;
        if (!fs::is_regular_file(path, ignored)) {
            return;
        }
        held_ = path.parent_path() / ("." + path.filename().string().substr(0, 200) + "." +
                                      std::to_string(std::random_device()()) + ".part");
        // A link costs nothing and the old file never lacks a name; a file system without links gets a copy.
        if (::link(path.c_str(), held_.c_str()) != 0) {
            std::error_code failure;
            if (!fs::copy_file(path, held_, failure)) {
                fs::remove(held_, ignored);
                fail(path, "the backup cannot be made: " + failure.message());
            }
        }
    }
    ~Backup() {
        std::error_code ignored;
        if (!held_.empty()) {
            fs::remove(held_, ignored);
        }
    }
    Backup(const Backup&) = delete;
    Backup& operator=(const Backup&) = delete;

    void rotate(Task& task) {
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
        syncFolder(path_.parent_path());
    }

  private:
    fs::path path_;
    fs::path held_;
};

/// What a save that was killed left behind. None writes for ten minutes without a pause.
void removeStale(const fs::path& path) {
    const std::string start = "." + path.filename().string().substr(0, 200) + ".";
    std::error_code ignored;
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    for (const auto& entry : fs::directory_iterator(folder, ignored)) {
        const std::string name = entry.path().filename().string();
        const auto age = fs::file_time_type::clock::now() - entry.last_write_time(ignored);
        if (name.starts_with(start) && name.ends_with(".part") && age > std::chrono::minutes(10)) {
            fs::remove(entry.path(), ignored);
        }
    }
}

void writeFile(PendingFile& file, const std::string& bytes) {
    std::fwrite(bytes.data(), 1, bytes.size(), file.stream());
    file.check();
}

/// A bare figure.json: pictures beside it first, so that it never names one that is not there.
void saveBare(const Contents& contents, const fs::path& path, Task& task) {
    for (const NewEntry& entry : contents.entries()) {
        const bool picture = entry.name.starts_with("styles/") || entry.name.starts_with("background.");
        if (picture && entry.source == nullptr) {
            const fs::path place = path.parent_path() / entry.name;
            std::error_code ignored;
            fs::create_directories(place.parent_path(), ignored);
            PendingFile file(place);
            writeFile(file, entry.file.empty() ? entry.bytes : fileBytes(entry.file));
            file.commit();
        }
    }
    PendingFile file(path);
    writeFile(file, contents.figureText());
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
    removeStale(target);
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
