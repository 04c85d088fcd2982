#include "core/base/machine.h"

#include <algorithm>
#include <unistd.h>

namespace limner {

std::uint64_t machineMemory() {
    const auto pages = static_cast<std::uint64_t>(std::max(sysconf(_SC_PHYS_PAGES), 1L));
    const auto pageBytes = static_cast<std::uint64_t>(std::max(sysconf(_SC_PAGESIZE), 1L));
    return pages * pageBytes;
}

} // namespace limner
