#include "app/studio/missing_parts.h"

#include "app/studio/scan_histogram.h"
#include "core/base/error.h"
#include "core/project/find_volume.h"
#include "core/project/label_volume.h"

#include <utility>

namespace limner {
namespace {

namespace fs = std::filesystem;

VolumeReference at(VolumeReference reference, const fs::path& path, const ImportedVolume& imported) {
    reference.path = reference.absolutePath = path.string(); // saving makes it relative
    reference.embedded = false;
    reference.data = imported.volume;
    if (!imported.report.sha256Values.empty())
        reference.sha256 = imported.report.sha256Values;
    reference.bytes = static_cast<std::int64_t>(imported.report.fileBytes);
    return reference;
}

void setScan(FoundParts& found, const VolumeReference& reference, FoundVolume volume) {
    found.scan = at(reference, volume.path, volume.imported);
    found.report = std::move(volume.imported.report);
    Figure figure;
    figure.volume = found.scan;
    found.histogram = scanHistogram(figure);
}

LabelReference labelsAt(const Figure& figure, const FoundParts& found, const fs::path& path, FoundParts& into,
                        Task& task) {
    const auto& scan = found.scan ? found.scan : figure.volume;
    LabelReference labels = openLabels(path, {scan ? scan->data : nullptr, 0}, into.notes, task);
    keepNames(*figure.labels, labels);
    return labels;
}

} // namespace

std::vector<MissingPart> missingParts(const Figure& figure) {
    std::vector<MissingPart> missing;
    if (figure.volume && !figure.volume->data)
        missing.push_back(MissingPart::scan);
    if (figure.secondVolume && !figure.secondVolume->data)
        missing.push_back(MissingPart::secondScan);
    if (figure.labels && !figure.labels->data)
        missing.push_back(MissingPart::labels);
    return missing;
}

std::string pathOf(const Figure& figure, MissingPart part) {
    return part == MissingPart::scan         ? figure.volume->path
           : part == MissingPart::secondScan ? figure.secondVolume->path
                                             : figure.labels->path;
}

Figure FoundParts::in(Figure figure) const {
    if (scan)
        figure.volume = scan;
    if (secondScan)
        figure.secondVolume = secondScan;
    if (labels)
        figure.labels = labels;
    return figure;
}

FoundParts findParts(const Figure& figure, const std::vector<fs::path>& folders, Task& task) {
    FoundParts found;
    for (const MissingPart part : missingParts(figure)) {
        if (part == MissingPart::scan) {
            if (auto volume = findVolume(*figure.volume, folders, task))
                setScan(found, *figure.volume, std::move(*volume));
        } else if (part == MissingPart::secondScan) {
            if (auto volume = findVolume(*figure.secondVolume, folders, task))
                found.secondScan = at(*figure.secondVolume, volume->path, volume->imported);
        } else if (const auto path = findByName(figure.labels->path, folders, task)) {
            try {
                found.labels = labelsAt(figure, found, *path, found, task);
            } catch (const Error& error) {
                if (error.kind() != ErrorKind::badInput)
                    throw;
                found.notes.emplace_back(error.what());
            }
        }
    }
    return found;
}

FoundParts takePart(const Figure& figure, MissingPart part, const fs::path& file, Task& task) {
    FoundParts found;
    if (part == MissingPart::labels) {
        found.labels = labelsAt(figure, found, file, found, task);
        return found;
    }
    const VolumeReference& reference = part == MissingPart::scan ? *figure.volume : *figure.secondVolume;
    ImportOptions options;
    options.raw = reference.raw;
    options.series = reference.series;
    FoundVolume volume{file, importVolume(file, options, task)};
    const std::string& sum = volume.imported.report.sha256Values;
    if (!reference.sha256.empty() && !sum.empty() && sum != reference.sha256)
        found.notes.push_back(file.filename().string() +
                              " holds other numbers than the scan that the figure was made of");
    if (part == MissingPart::scan)
        setScan(found, reference, std::move(volume));
    else
        found.secondScan = at(reference, file, volume.imported);
    return found;
}

} // namespace limner
