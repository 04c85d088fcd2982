#pragma once

#include "core/volume/volume.h"

#include <cstddef>
#include <map>
#include <optional>

namespace limner {

/// Label numbers that occur, rising, with their voxel counts. Nothing where the values are not all whole numbers (a
/// fraction as slope or intercept, or floating-point storage, which the importer takes only for what does not fit 65536
/// whole numbers). Parallel, thread-safe.
std::optional<std::map<int, std::size_t>> countLabels(const Volume& labels);

} // namespace limner
