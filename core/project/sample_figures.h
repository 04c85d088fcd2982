#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace limner {

/// A figure that comes with Limner, to be laid over the scan that it was made for (spec style-transfer-functions.md,
/// section 9). The scan does not come with it.
struct SampleFigure {
    std::string id;             ///< "contours-even"
    std::string title;          ///< one line: what it shows
    std::string scan;           ///< name of the file that it was made for, "Cranium.inv3"
    std::string labels;         ///< name of the label file beside the scan; empty: none
    std::filesystem::path file; ///< a bare figure.json
};

/// The figures in `resourcesFolder()/figures`, by id. Throws Error(badInput) where there is none or one is damaged.
/// Thread-safe.
const std::vector<SampleFigure>& sampleFigures();

/// The scan of a sample figure on this machine: in a folder of LIMNER_SAMPLES (separated by ':'), or where Debian's
/// package invesalius-examples puts its head CT. Empty: it is not here.
std::filesystem::path findSampleScan(const SampleFigure& figure);

/// Throws Error(usage) for an unknown id.
const SampleFigure& findSampleFigure(const std::string& id);

} // namespace limner
