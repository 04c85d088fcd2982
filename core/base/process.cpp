#include "core/base/process.h"

#include <sys/resource.h>

namespace limner {

std::uint64_t peakResidentBytes() {
    rusage usage{};
    if (::getrusage(RUSAGE_SELF, &usage) != 0) {
        return 0;
    }
#ifdef __APPLE__
    return static_cast<std::uint64_t>(usage.ru_maxrss); // bytes there, KiB elsewhere
#else
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
#endif
}

} // namespace limner
