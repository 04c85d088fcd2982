#pragma once

#include "core/style/extraction/picture.h"

#include <filesystem>

namespace limner {

/// Reads a mask from any picture: what is white counts, what is black or clear does not; of a picture without any
/// colour (a shape drawn in black on a clear ground) what is opaque counts. A large one is reduced to at most 4096
/// pixels along its longer side. Throws Error(badInput) for what is no picture.
Mask loadMask(const std::filesystem::path& file);

} // namespace limner
