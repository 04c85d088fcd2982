#pragma once

#include "core/style/lit_sphere.h"

#include <filesystem>

namespace limner {

class Task;

/// A picture of a shaded ball as a style, with the card beside it (same name, .json) where there is one, and the file's
/// name as its origin. Throws Error(badInput).
Style importedStyle(const std::filesystem::path& picture, Task& task);

} // namespace limner
