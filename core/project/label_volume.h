#pragma once

#include "core/base/task.h"
#include "core/figure/figure.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace limner {

struct LabelRequest {
    std::shared_ptr<const Volume> scan; ///< what the labels belong to; null: they are not compared with anything
    std::uint64_t memoryBudget = 0;     ///< bytes, as in ImportOptions
};

/// Reads a label volume with the names and colours of the labels that occur (label_table.h). A grid other than the
/// scan's is fine; one that covers less than half of the scan is noted, as is what is odd about the table. Throws
/// Error(badInput) for values that are no whole numbers and for a grid that does not touch the scan's box, beside what
/// importVolume throws.
LabelReference openLabels(const std::filesystem::path& path, const LabelRequest& request,
                          std::vector<std::string>& notes, Task& task);

/// Lays names and colours that a document has for labels over those of a file.
void keepNames(const LabelReference& own, LabelReference& loaded);

} // namespace limner
