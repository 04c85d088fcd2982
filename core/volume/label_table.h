#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace limner {

struct LabelEntry {
    std::string name;   ///< UTF-8 without control characters, at most 256 bytes; may be empty
    std::string colour; ///< "#rrggbb"; empty: none
    friend bool operator==(const LabelEntry&, const LabelEntry&) = default;
};

/// Names and colours of label numbers.
struct LabelTable {
    static constexpr std::size_t kMostEntries = 65536; ///< numbers that 16 bits tell apart
    static constexpr std::size_t kLongestName = 256;   ///< bytes

    std::map<int, LabelEntry> entries;
    std::vector<std::string> warnings; ///< what could not be read, one line each
};

/// The table of a label volume: from the file's own header (NIfTI header extension with Caret's LabelTable, as
/// TotalSegmentator and wb_command write it; NRRD keys SegmentN_* of 3D Slicer), and what is not there from a text file
/// with the same stem beside it (.txt, .label, .lut, .ctbl: a number and a name a line with columns of numbers between
/// or after them, three of them after each other within 0..255 being a colour; ITK-SNAP's label descriptions).
/// Only the header is read, within fixed bounds. Never throws for an absent or odd table. Thread-safe.
LabelTable readLabelTable(const std::filesystem::path& path);

} // namespace limner
