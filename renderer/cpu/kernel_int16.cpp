// The ray-casting kernel over int16 voxels, for every instruction set (Highway's run-time dispatch). Everything a
// target compiles stands in that target's namespace: the linker must never keep one target's copy for all.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/cpu/kernel_int16.cpp"
#include <hwy/foreach_target.h> // must come before the headers that each target compiles anew

#include "renderer/cpu/march-inl.h"

HWY_BEFORE_NAMESPACE();
namespace limner::HWY_NAMESPACE {

void castInt16Target(const KernelScene& scene, const KernelBlock& block, float* rgba, KernelCounts& counts) {
    castWidth<std::int16_t>(scene, block, rgba, counts);
}

} // namespace limner::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace limner {

namespace {
HWY_EXPORT(castInt16Target);
}

void castBlockInt16(const KernelScene& scene, const KernelBlock& block, float* rgba, KernelCounts& counts) {
    HWY_DYNAMIC_DISPATCH(castInt16Target)(scene, block, rgba, counts);
}

} // namespace limner

#endif
