#pragma once

#include "core/base/task.h"
#include "core/figure/figure.h"
#include "core/volume/import.h"

#include <filesystem>
#include <string>
#include <vector>

namespace limner {

/// A figure with what it refers to.
struct Document {
    Figure figure;              ///< volume, labels and styles resolved where they were found
    std::filesystem::path path; ///< of the project or figure.json; empty for a fresh figure of a scan
    ImportReport volumeReport;
    std::vector<std::string> notes; ///< what the user should know: volume moved or changed, unknown keys, ...
};

struct OpenOptions {
    std::string preset; ///< of a volume; empty: "auto"
    /// Label volume of the scan; replaces a project's, whose own names and colours stay where its labels are not found.
    std::filesystem::path labels;
    ImportOptions import;
    /// Id of a sample figure that is laid over a volume in the place of a preset; labels that it wants and that are not
    /// given are looked for beside the volume. Of a project: Error(usage).
    std::string sample = {};
};

/// Opens a `.limner` project, a bare figure.json, or any volume (which gets the preset's figure). A missing volume is a
/// note and leaves `volume->data` null; nothing is lost. Throws Error, also for `labels` that cannot be used.
Document openDocument(const std::filesystem::path& path, const OpenOptions& options, Task& task);

/// The same without labels of its own.
inline Document openDocument(const std::filesystem::path& path, const std::string& preset, const ImportOptions& options,
                             Task& task) {
    return openDocument(path, OpenOptions{preset, {}, options}, task);
}

/// Loads volumes, labels and styles of a figure whose relative paths start at `folder`; what cannot be found becomes a
/// note.
void resolveFigure(Document& document, const std::filesystem::path& folder, const ImportOptions& options, Task& task);

struct SaveOptions {
    bool embedVolume = false;
    std::vector<std::byte> thumbnailPng; ///< 256^2 PNG; empty: none
};

/// Writes a `.limner` zip (or, for a path ending in .json, a bare figure.json with styles beside it): written beside,
/// synced, reopened and checked, then renamed over the old one, of which two backups stay (NAME.limner~,
/// NAME.limner~~). Throws Error(noResources or badInput); then the old file is as it was.
void saveDocument(const Document& document, const std::filesystem::path& path, const SaveOptions& options, Task& task);

} // namespace limner
