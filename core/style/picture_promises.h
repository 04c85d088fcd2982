#pragma once

#include <filesystem>
#include <string>

namespace limner {

/// What a picture file says before its reader is let near it; some make room for whatever it says. Internal to
/// core/style.
struct PicturePromises {
    std::string broken;         ///< a promise that no file of that length keeps; empty: none found
    bool photoshopInks = false; ///< a Photoshop file in CMYK
};

/// Looks at the headers of Photoshop and OpenEXR files; of all others, and of what is not there, nothing is said.
PicturePromises promisesOf(const std::filesystem::path& file);

} // namespace limner
