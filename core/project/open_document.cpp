#include "core/base/error.h"
#include "core/figure/figure_json.h"
#include "core/figure/presets.h"
#include "core/project/archive.h"
#include "core/project/label_volume.h"
#include "core/project/project.h"
#include "core/project/sample_figures.h"
#include "core/style/background_picture.h"

#include <fstream>
#include <optional>
#include <sstream>
#include <utility>

namespace limner {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEmbeddedName = "volume.nrrd";
constexpr const char* kBundledPrefix = "bundled:";
constexpr const char* kBuiltinPrefix = "builtin:";

std::string textOf(const fs::path& path) {
    constexpr std::uintmax_t kLongest = std::uintmax_t{16} << 20; // as `readFigure` takes
    std::error_code failure;
    const bool regular = fs::is_regular_file(path, failure);
    const std::uintmax_t size = regular ? fs::file_size(path, failure) : 0;
    std::ifstream file(path, std::ios::binary);
    if (!regular || failure || !file) {
        throw Error(ErrorKind::badInput,
                    {"cannot read the figure", path.string(),
                     fs::exists(path, failure) ? "it is not a readable file" : "no such file", "check the path"});
    }
    if (size > kLongest) {
        throw Error(ErrorKind::badInput,
                    {"cannot read the figure", path.string(), "the text has " + std::to_string(size) + " bytes",
                     "a figure has at most 16 MiB"});
    }
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// Where a referred file is: beside the project in `folder`, or where it was.
std::optional<fs::path> foundIn(const fs::path& folder, const std::string& path, const std::string& absolute) {
    if (path.starts_with(kBuiltinPrefix)) {
        return fs::path(path);
    }
    std::error_code ignored;
    for (const fs::path& candidate : {path.empty() ? fs::path() : folder / path, fs::path(absolute)}) {
        if (!candidate.empty() && (fs::is_regular_file(candidate, ignored) || fs::is_directory(candidate, ignored))) {
            return candidate;
        }
    }
    return std::nullopt;
}

LabelRequest labelRequest(const Figure& figure, const ImportOptions& options) {
    return {figure.volume ? figure.volume->data : nullptr, options.memoryBudget};
}

/// What a figure refers to is looked for here.
class Resolver {
  public:
    Resolver(Document& document, fs::path folder, const ImportOptions& options, Task& task)
        : document_(document), folder_(std::move(folder)), options_(options), task_(task) {
        if (looksLikeArchive(document.path)) {
            archive_.emplace(document.path);
        }
    }

    void run() {
        Figure& figure = document_.figure;
        if (figure.volume && figure.volume->data == nullptr) {
            loadVolume(*figure.volume, "scan", &document_.volumeReport);
        }
        if (figure.secondVolume && figure.secondVolume->data == nullptr) {
            loadVolume(*figure.secondVolume, "second scan", nullptr);
        }
        if (figure.labels && figure.labels->data == nullptr) {
            loadLabels(*figure.labels);
        }
        for (StyleEntry& style : figure.styles) {
            if (style.sphere == nullptr) {
                loadEntry(style);
            }
            if (style.texture && style.texture->tile == nullptr) {
                loadTexture(style.id, *style.texture);
            }
        }
        if (figure.background.kind == "image" && figure.background.picture == nullptr) {
            loadBackground(figure.background);
        }
    }

  private:
    void note(const std::string& text) {
        document_.notes.push_back(text);
        task_.warn(text);
    }

    /// Runs a part whose failure is a note, not the end; stopping and want of memory end it all the same.
    template <class Load>
    void attempt(const std::string& what, const Load& load) {
        try {
            load();
        } catch (const Error& error) {
            if (error.kind() == ErrorKind::cancelled || error.kind() == ErrorKind::noResources) {
                throw;
            }
            note(what + ": " + error.what());
        }
    }

    /// `report`: of the main scan, which documents keep; null for others.
    void loadVolume(VolumeReference& reference, const std::string& what, ImportReport* report) {
        ImportOptions options = options_;
        options.raw = reference.raw.empty() ? options.raw : reference.raw;
        options.series = reference.series.empty() ? options.series : reference.series;
        ImportedVolume imported;
        if (reference.embedded && archive_ && archive_->find(kEmbeddedName) != nullptr) {
            attempt("the embedded " + what, [&] {
                const TemporaryFolder temporary;
                imported = importVolume(unpack(*archive_->find(kEmbeddedName), temporary), ImportOptions{}, task_);
            });
        } else {
            const std::optional<fs::path> path = foundIn(folder_, reference.path, reference.absolutePath);
            if (!path) {
                note("the " + what + " " + reference.path + " was not found beside the figure" +
                     (reference.absolutePath.empty() ? "" : " nor at " + reference.absolutePath) +
                     "; put it back there, or show its new place in the studio");
                return;
            }
            attempt("the " + what, [&] { imported = importVolume(*path, options, task_); });
            if (imported.volume != nullptr && !reference.path.starts_with(kBuiltinPrefix)) {
                std::error_code ignored;
                reference.absolutePath = fs::weakly_canonical(*path, ignored).string();
            }
        }
        const std::string& sum = imported.report.sha256Values;
        if (imported.volume != nullptr && !reference.sha256.empty() && !sum.empty() && sum != reference.sha256) {
            note("the " + what + " " + reference.path + " has changed since the figure was saved");
        }
        reference.data = imported.volume;
        if (report != nullptr && imported.volume != nullptr) {
            *report = std::move(imported.report);
        }
    }

    void loadLabels(LabelReference& reference) {
        const std::optional<fs::path> path = foundIn(folder_, reference.path, reference.absolutePath);
        if (!path) {
            note("the labels " + reference.path + " were not found beside the figure" +
                 (reference.absolutePath.empty() ? "" : " nor at " + reference.absolutePath) +
                 "; give their new place");
            return;
        }
        attempt("the labels", [&] {
            LabelReference loaded = openLabels(*path, labelRequest(document_.figure, options_), document_.notes, task_);
            keepNames(reference, loaded);
            loaded.path = reference.path;
            reference = std::move(loaded);
        });
    }

    void loadEntry(StyleEntry& style) {
        attempt("the style \"" + style.id + "\"", [&] {
            if (style.file.starts_with(kBundledPrefix)) {
                const Style* bundled = findBundledStyle(style.file.substr(std::string(kBundledPrefix).size()));
                if (bundled == nullptr) {
                    note("the style \"" + style.id + "\": this version has no " + style.file);
                } else {
                    style.sphere = bundled->sphere;
                }
                return;
            }
            const bool there =
                withPicture(style.file, [&](const fs::path& picture) { style.sphere = loadStyle(picture).sphere; });
            if (!there) {
                note("the style \"" + style.id + "\": the picture " + style.file + " is not there");
            }
        });
    }

    void loadBackground(Background& background) {
        attempt("the background's picture", [&] {
            const ArchiveEntry* entry = archive_ ? archive_->find(background.file) : nullptr;
            const fs::path beside = folder_ / background.file; // an absolute path stays one
            std::error_code ignored;
            if (entry != nullptr && entry->kind == EntryKind::background) {
                auto temporary = std::make_shared<const TemporaryFolder>();
                const fs::path file = unpack(*entry, *temporary);
                background.picture = std::make_shared<const BackgroundPicture>(file, std::move(temporary));
            } else if (!background.file.empty() && fs::is_regular_file(beside, ignored)) {
                background.picture = std::make_shared<const BackgroundPicture>(fs::absolute(beside));
            } else {
                note("the background's picture " + background.file + " is not there; its colour is drawn");
            }
        });
    }

    void loadTexture(const std::string& id, StyleTexture& texture) {
        const std::string what = "the texture of the style \"" + id + "\"";
        attempt(what, [&] {
            if (texture.file.starts_with(kBundledPrefix)) {
                texture.tile = findBundledTexture(texture.file.substr(std::string(kBundledPrefix).size()));
                if (texture.tile == nullptr) {
                    note(what + ": this version has no " + texture.file);
                }
                return;
            }
            const bool there =
                withPicture(texture.file, [&](const fs::path& picture) { texture.tile = loadTextureTile(picture); });
            if (!there) {
                note(what + ": the picture " + texture.file + " is not there");
            }
        });
    }

    /// Calls `load` with a picture from inside the project, from beside the figure, or from where its full path says;
    /// false where it is in none of them.
    template <class Load>
    bool withPicture(const std::string& file, const Load& load) {
        const ArchiveEntry* entry = archive_ ? archive_->find(file) : nullptr;
        std::error_code ignored;
        if (entry != nullptr && entry->kind == EntryKind::style) {
            const TemporaryFolder temporary;
            load(unpack(*entry, temporary));
        } else if ((!archive_ || fs::path(file).is_absolute()) && fs::is_regular_file(folder_ / file, ignored)) {
            load(folder_ / file);
        } else {
            return false;
        }
        return true;
    }

    /// Under a name of our own; only the ending, from a short list, is the entry's.
    fs::path unpack(const ArchiveEntry& entry, const TemporaryFolder& temporary) const {
        const fs::path path = temporary.path() / ("entry" + fs::path(entry.name).extension().string());
        std::ofstream file(path, std::ios::binary);
        archive_->readInto(entry, [&](std::span<const char> piece) {
            task_.throwIfCancelled();
            file.write(piece.data(), static_cast<std::streamsize>(piece.size()));
        });
        file.close();
        if (!file) {
            throw Error(ErrorKind::noResources,
                        {"cannot unpack " + entry.name, path.string(), "the disk is full", "free some space"});
        }
        return path;
    }

    Document& document_;
    fs::path folder_;
    const ImportOptions& options_;
    Task& task_;
    std::optional<Archive> archive_;
};

Document documentFromText(const std::string& text, const fs::path& path) {
    Document document;
    document.path = path;
    std::vector<Problem> problems;
    document.figure = readFigure(text, path.string(), &problems);
    for (const Problem& problem : problems) {
        document.notes.push_back(problem.pointer + ": " + problem.why +
                                 (problem.mend.empty() ? "" : "; " + problem.mend));
    }
    return document;
}

/// Opens the labels that were asked for in the place of the figure's own.
void replaceLabels(Document& document, const LabelReference& own, const OpenOptions& options, Task& task) {
    LabelReference labels =
        openLabels(options.labels, labelRequest(document.figure, options.import), document.notes, task);
    if (!foundIn(document.path.parent_path(), own.path, own.absolutePath)) {
        keepNames(own, labels); // the same labels in a new place
    }
    document.figure.labels = std::move(labels);
}

VolumeReference referenceTo(const fs::path& path, const ImportedVolume& imported, const ImportOptions& options) {
    VolumeReference reference;
    reference.path = path.string();
    if (!reference.path.starts_with(kBuiltinPrefix)) {
        std::error_code ignored;
        reference.absolutePath = fs::weakly_canonical(path, ignored).string();
        reference.path = reference.absolutePath;
    }
    reference.sha256 = imported.report.sha256Values;
    reference.bytes = static_cast<std::int64_t>(imported.report.fileBytes);
    reference.raw = options.raw;
    reference.series = options.series;
    reference.data = imported.volume;
    return reference;
}

Document documentFromVolume(const fs::path& path, const OpenOptions& open, Task& task) {
    const ImportOptions& options = open.import;
    Document document;
    ImportedVolume imported = importVolume(path, options, task);
    std::optional<LabelReference> labels;
    if (!open.labels.empty()) {
        labels = openLabels(open.labels, {imported.volume, options.memoryBudget}, document.notes, task);
    }
    document.figure =
        figureFromPreset(open.preset.empty() ? "auto" : open.preset, imported.volume, document.notes, labels);
    document.figure.volume = referenceTo(path, imported, options);
    document.volumeReport = std::move(imported.report);
    return document;
}

Document documentFromSample(const fs::path& path, const OpenOptions& open, Task& task) {
    const fs::path file = findSampleFigure(open.sample).file;
    Document document = documentFromText(textOf(file), file);
    document.path.clear(); // a fresh figure: saving it must not reach for the bundled file
    Figure& figure = document.figure;
    ImportedVolume imported = importVolume(path, open.import, task);
    figure.volume = referenceTo(path, imported, open.import);
    document.volumeReport = std::move(imported.report);
    std::error_code ignored;
    if (figure.background.kind == "image") { // of the figure's folder; all else is looked for in the scan's
        figure.background.file = (fs::absolute(file, ignored).parent_path() / figure.background.file).string();
    }
    const fs::path folder = fs::absolute(path, ignored).parent_path();
    if (!open.labels.empty()) {
        figure.labels.reset();
    } else if (figure.labels) {
        figure.labels->path = (folder / figure.labels->path).string();
    }
    resolveFigure(document, folder, open.import, task);
    if (!open.labels.empty()) {
        replaceLabels(document, {}, open, task);
    }
    return document;
}

/// Of a project or bare figure; nothing where the path names a scan.
std::optional<std::string> figureTextOf(const fs::path& path) {
    if (looksLikeArchive(path)) {
        const Archive archive(path);
        const ArchiveEntry* figure = archive.find("figure.json");
        if (figure == nullptr) {
            throw Error(ErrorKind::badInput, {"cannot read the project", path.string(), "it holds no figure.json",
                                              "give a .limner file that Limner saved"});
        }
        return archive.read(*figure);
    }
    if (path.extension() == ".json") {
        return textOf(path);
    }
    if (path.extension() == ".limner") {
        std::error_code ignored;
        throw Error(ErrorKind::badInput,
                    {"cannot read the project", path.string(),
                     fs::exists(path, ignored) ? "it is not a zip file" : "no such file",
                     fs::exists(path.string() + "~", ignored) ? "there is a backup: " + path.string() + "~"
                                                              : "check the path"});
    }
    return std::nullopt;
}

} // namespace

Document openDocument(const fs::path& path, const OpenOptions& options, Task& task) {
    const std::optional<std::string> text = figureTextOf(path);
    if (!text) {
        return options.sample.empty() ? documentFromVolume(path, options, task)
                                      : documentFromSample(path, options, task);
    }
    if (!options.sample.empty()) {
        throw Error(ErrorKind::usage, {"cannot lay a sample figure over this", path.string(),
                                       "it is a figure of its own", "name the scan instead"});
    }
    Document document = documentFromText(*text, path);
    LabelReference own;
    if (!options.labels.empty() && document.figure.labels) {
        own = *std::exchange(document.figure.labels, std::nullopt);
    }
    resolveFigure(document, path.parent_path(), options.import, task);
    if (!options.labels.empty()) {
        replaceLabels(document, own, options, task);
    }
    return document;
}

void resolveFigure(Document& document, const fs::path& folder, const ImportOptions& options, Task& task) {
    Resolver(document, folder, options, task).run();
}

} // namespace limner
