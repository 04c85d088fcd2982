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

/// Below 4 pixels there is no disk to speak of; above 8192 a style holds nothing a figure could show.
inline constexpr PictureRules kSphereRules{"cannot read the style",
                                           {4, 8192},
                                           "crop it to the square around the ball",
                                           "bring it to a width from 4 to 8192, 512 is plenty",
                                           "use a PNG, TIFF, JPEG or EXR picture of a shaded ball"};
inline constexpr PictureRules kTileRules{"cannot read the texture",
                                         {16, 2048},
                                         "crop it to a square that repeats without a seam",
                                         "bring it to a width from 16 to 2048, 256 is plenty",
                                         "use a PNG, TIFF, JPEG or EXR picture"};

struct SquarePicture {
    int size = 0;
    std::vector<Rgba> pixels; ///< size * size, top row first
};

/// Reads a whole picture, by `PictureRows`. Its size is checked before anything is allocated. Throws Error(badInput),
/// Error(noResources).
SquarePicture readSquarePicture(const std::filesystem::path& file, const PictureRules& rules);

/// Throws what `readSquarePicture` would of the file's header; reads no more than that.
void checkSquarePicture(const std::filesystem::path& file, const PictureRules& rules);

} // namespace limner
