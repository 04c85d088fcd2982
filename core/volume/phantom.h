#pragma once

#include "core/volume/volume.h"

#include <memory>

namespace limner {

/// A built-in analytic head in HU with skin, skull, brain, eyes and vessels, `size`^3 voxels over 240 mm: what the
/// sample figure falls back on and what tests use where a plausible CT is needed. Deterministic.
std::shared_ptr<const Volume> makeHeadPhantom(int size);

} // namespace limner
