#pragma once

#include <cstdint>

namespace limner {

/// The memory that the machine has, in bytes.
std::uint64_t machineMemory();

} // namespace limner
