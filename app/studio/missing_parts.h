#pragma once

#include "core/project/project.h"
#include "core/volume/histogram.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace limner {

/// Files that a figure refers to and that were not there when it was opened.

enum class MissingPart { scan, secondScan, labels };

/// In this order.
std::vector<MissingPart> missingParts(const Figure& figure);
/// The path by which the figure knows a part.
std::string pathOf(const Figure& figure, MissingPart part);

/// What was found of them.
struct FoundParts {
    std::optional<VolumeReference> scan;
    ImportReport report; ///< of the scan
    std::shared_ptr<const Histogram> histogram;
    std::optional<VolumeReference> secondScan;
    std::optional<LabelReference> labels;
    std::vector<std::string> notes;

    [[nodiscard]] bool any() const { return scan || secondScan || labels; }
    /// The figure with them.
    [[nodiscard]] Figure in(Figure figure) const;
};

/// Looks for all missing parts below the folders (find_volume.h). Throws Error(cancelled, noResources).
FoundParts findParts(const Figure& figure, const std::vector<std::filesystem::path>& folders, Task& task);
/// Takes one part from a file; that its numbers are others than the figure remembers is a note. Throws Error.
FoundParts takePart(const Figure& figure, MissingPart part, const std::filesystem::path& file, Task& task);

} // namespace limner
