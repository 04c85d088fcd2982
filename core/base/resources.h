#pragma once

#include <filesystem>

namespace limner {

/// The folder with the bundled styles, presets and samples. Found once, through LIMNER_RESOURCES, beside the executable
/// (`../resources` in a build tree, `../share/limner` where installed), or where the build was told to install; the
/// first that is a folder counts. Throws Error(badInput) naming these places when there is none. Thread-safe.
const std::filesystem::path& resourcesFolder();

} // namespace limner
