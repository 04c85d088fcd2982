#pragma once

#include "renderer/text/font_face.h"

namespace limner {

/// The family that text is set in where none is named, and where a named one is not there.
inline constexpr const char* kDefaultFamily = "DejaVu Sans";

struct FontWish {
    std::string family; ///< empty: the default
    bool bold = false;
    bool italic = false;
    friend auto operator<=>(const FontWish&, const FontWish&) = default;
};

/// The installed face that is nearest to a wish. Faces are opened once and stay for the process's life; thread-safe.
/// Throws Error(noResources) where the system has no font at all.
const FontFace& fontFor(const FontWish& wish);

/// A face with this letter: the wish's own where that has it, else the nearest one that has; the wish's own where none
/// has (its empty box is drawn then).
const FontFace& fontWith(const FontWish& wish, char32_t letter);

/// Names of the installed families that can be drawn, sorted.
std::vector<std::string> fontFamilies();

} // namespace limner
