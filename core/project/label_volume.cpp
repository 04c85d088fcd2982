#include "core/project/label_volume.h"

#include "core/base/error.h"
#include "core/volume/derived_fields.h"
#include "core/volume/grid_cover.h"
#include "core/volume/import.h"
#include "core/volume/label_table.h"

#include <cmath>

namespace limner {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& why, const std::string& remedy) {
    throw Error(ErrorKind::badInput, {"cannot use the labels", path.filename().string(), why, remedy});
}

void comparePlaces(const fs::path& path, const Grid& labels, const Grid& scan, std::vector<std::string>& notes) {
    if (labels == scan) {
        return;
    }
    if (!boxesOverlap(scan, labels)) {
        refuse(path, "they lie wholly outside the scan", "take labels that were made from this scan");
    }
    constexpr double kHalf = 0.5;
    if (const double share = coveredShare(scan, labels); share < kHalf) {
        notes.push_back("the labels " + path.filename().string() + " cover only " +
                        std::to_string(std::lround(100 * share)) +
                        " % of the scan's box; what lies outside them has no label");
    }
}

} // namespace

LabelReference openLabels(const fs::path& path, const LabelRequest& request, std::vector<std::string>& notes,
                          Task& task) {
    ImportOptions options;
    options.labels = true;
    options.memoryBudget = request.memoryBudget;
    LabelReference reference;
    reference.data = importVolume(path, options, task).volume;
    const auto counts = labelCounts(*reference.data);
    if (!counts) {
        refuse(path, "its values are not whole numbers", "take a volume of label numbers");
    }
    if (request.scan != nullptr) {
        comparePlaces(path, reference.data->grid(), request.scan->grid(), notes);
    }
    std::error_code ignored;
    reference.absolutePath = fs::weakly_canonical(path, ignored).string();
    reference.path = reference.absolutePath;
    const LabelTable table = readLabelTable(path);
    for (const std::string& warning : table.warnings) {
        notes.push_back("the labels " + path.filename().string() + ": " + warning);
    }
    for (const auto& [label, entry] : table.entries) {
        if (label == 0 || counts->count(label) == 0) {
            continue; // tables name every organ that a program knows of
        }
        if (!entry.name.empty()) {
            reference.names[std::to_string(label)] = entry.name;
        }
        if (!entry.colour.empty()) {
            reference.colours[std::to_string(label)] = entry.colour;
        }
    }
    return reference;
}

void keepNames(const LabelReference& own, LabelReference& loaded) {
    for (const auto& [label, name] : own.names) {
        loaded.names[label] = name;
    }
    for (const auto& [label, colour] : own.colours) {
        loaded.colours[label] = colour;
    }
}

} // namespace limner
