#include "renderer/cpu/kernel.h"

#include <hwy/targets.h>

#include <array>

namespace limner {

namespace {

constexpr std::array<std::int64_t, 3> kCompiled = {HWY_AVX3, HWY_AVX2, HWY_SSE4};

} // namespace

void castBlock(const KernelScene& scene, const KernelBlock& block, float* rgba, KernelCounts& counts) {
    switch (scene.type) {
    case VoxelType::uint8: castBlockUint8(scene, block, rgba, counts); break;
    case VoxelType::int16: castBlockInt16(scene, block, rgba, counts); break;
    case VoxelType::float32: castBlockFloat32(scene, block, rgba, counts); break;
    }
}

std::vector<std::string> kernelTargets() {
    std::vector<std::string> names;
    for (const std::int64_t target : kCompiled) {
        if ((hwy::SupportedTargets() & target) != 0) {
            names.emplace_back(hwy::TargetName(target));
        }
    }
    return names;
}

void restrictKernelTarget(const std::string& name) {
    hwy::SetSupportedTargetsForTest(0);
    for (const std::int64_t target : kCompiled) {
        if (name == hwy::TargetName(target)) {
            hwy::SetSupportedTargetsForTest(target);
        }
    }
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

} // namespace limner
