#pragma once

#include "core/style/extraction/ink_marks.h"

#include <vector>

namespace limner {

/// Marks that stand in a row as letters do.
struct TextRow {
    std::vector<std::size_t> letters; ///< indices into `InkMarks::marks`, in reading order or its reverse
    double height = 0;                ///< of its letters, the mean
    double stroke = 0;                ///< of their strokes' width
    double ink = 0;                   ///< of their values
    double contrast = 0;              ///< of theirs with what is beside them
    double sure = 0;                  ///< 0..1: how much like text it is, looked at alone
};

/// Rows of like-sized marks of one ink, straight or gently bent, with light around them; hatching's short parallel
/// strokes are none. A plate is lettered in one hand: what is doubtful is text where it is like the text that is not.
/// `strict`: where the ground is full of marks that are none. Internal to the extraction.
std::vector<TextRow> textRowsOf(const InkMarks& marks, bool strict);

} // namespace limner
