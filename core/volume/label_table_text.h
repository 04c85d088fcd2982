#pragma once

#include "core/volume/label_table.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

/// How tables of labels are written. Internal to core/volume.
namespace limner::importing {

/// As LabelEntry has it: bytes that are no UTF-8 become "?", control characters go, the rest is cut at a character.
std::string cleanLabelName(std::string_view text);

/// "#rrggbb" of parts in 0..1, clamped; empty where one is not finite.
std::string hexColour(const std::array<double, 3>& rgb);

std::optional<int> labelNumber(std::string_view text);

/// Adds an entry unless the label has one (the first counts) or the table is full, which is warned of once.
/// False where it is full.
bool addLabel(LabelTable& table, int label, LabelEntry entry);

/// Caret's <LabelTable> with <Label Key Red Green Blue>name</Label>; colours 0..1.
void readCaretLabels(std::string_view xml, LabelTable& table);

/// The text file beside a volume, `name` for warnings; empty where it is no table of labels.
LabelTable parseLabelText(std::string_view text, const std::string& name);

} // namespace limner::importing
