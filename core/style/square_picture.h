#pragma once

#include "core/style/lit_sphere.h"

#include <filesystem>
#include <vector>

namespace limner {

/// What a kind of picture must be, and the words for one that is not. Internal to core/style.
struct PictureRules {
    const char* what;    ///< "cannot read the style"
    int widths[2];       ///< smallest and largest, in pixels
    const char* crop;    ///< remedies: it is not square,
    const char* resize;  ///< too small or too large,
    const char* formats; ///< no picture at all
};

struct SquarePicture {
    int size = 0;
    std::vector<Rgba> pixels; ///< size * size, top row first
};

/// Reads a whole picture, by `PictureRows`. Its size is checked before anything is allocated. Throws Error(badInput),
/// Error(noResources).
SquarePicture readSquarePicture(const std::filesystem::path& file, const PictureRules& rules);

} // namespace limner
