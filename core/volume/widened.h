#pragma once

#include "core/volume/volume.h"

#include <memory>

namespace limner {

/// The same numbers of a volume of eight bits in sixteen, which take twice the memory: to prove that they need not.
std::shared_ptr<const Volume> widenedToInt16(const Volume& narrow);

} // namespace limner
