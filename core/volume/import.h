#pragma once

#include "core/base/task.h"
#include "core/volume/volume.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace limner {

struct ImportOptions {
    std::string raw;             ///< "256x256x230:uint16:le:0.5,0.5,0.7" for headerless bytes; empty: read the header
    std::string series;          ///< DICOM: series UID, or its number in the list counted from 1; empty: the largest
    bool firstComponent = false; ///< colour, vector and 4D data: take the first component instead of refusing
    bool labels = false;         ///< integer labels: never quantised, never resampled with interpolation
    std::uint64_t memoryBudget = 0; ///< bytes; 0: three quarters of the machine's memory
};

/// One DICOM series of a folder.
struct SeriesSummary {
    std::string uid;
    std::string description;
    std::string modality;
    int slices = 0;
};

/// What was read and what was done to it: the facts behind `limner info`.
struct ImportReport {
    std::string format;       ///< "DICOM series", "NIfTI-1", "NRRD", ...
    std::string type;         ///< of the numbers in the file: "int16", "float32", ...
    std::string sha256Values; ///< of the stored numbers, little-endian, x fastest, before slope and intercept
    std::uintmax_t fileBytes = 0;
    double quantisationError = 0;      ///< largest |kept - read| in the data's unit; 0: exact
    std::vector<SeriesSummary> series; ///< DICOM folders
    std::vector<std::string> warnings; ///< what was repaired or guessed, one line each
};

struct ImportedVolume {
    std::shared_ptr<const Volume> volume;
    ImportReport report;
};

/// Reads any supported volume: DICOM folder, DICOMDIR or file, NIfTI-1/2 and Analyze, NRRD/NHDR, MetaImage, VTK
/// structured points, VTI, TIFF and PNG stacks (a folder or one picture of it), multi-page TIFF, InVesalius .inv3, raw
/// bytes; the path "builtin:head" makes the built-in head instead of reading a file. Header words are checked against
/// the file's length and the memory budget before anything is allocated. Throws Error: badInput for a file that is not
/// what it claims, noResources over the budget, cancelled.
ImportedVolume importVolume(const std::filesystem::path& path, const ImportOptions& options, Task& task);

} // namespace limner
