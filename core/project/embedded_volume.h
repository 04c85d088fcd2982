#pragma once

#include "core/base/task.h"
#include "core/volume/volume.h"

#include <filesystem>
#include <string>

namespace limner {

/// Writes a volume as gzipped NRRD in LPS: 8- and 16-bit data whose values are whole numbers of that size bit for bit,
/// everything else as float values. Returns the SHA-256 of the numbers written. Throws Error(noResources, cancelled).
std::string writeNrrd(const Volume& volume, const std::filesystem::path& path, Task& task);

} // namespace limner
