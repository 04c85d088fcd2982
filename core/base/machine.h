#pragma once

#include <cstdint>
#include <string>

namespace limner {

/// The memory that the machine has, in bytes.
std::uint64_t machineMemory();

/// The processor's own name, "AMD EPYC 9R14"; empty where the system does not tell.
std::string processorName();

} // namespace limner
