#pragma once

#include <cstdint>

namespace limner {

/// Most memory that this process has held in RAM so far, in bytes; 0 where the system does not say.
std::uint64_t peakResidentBytes();

} // namespace limner
