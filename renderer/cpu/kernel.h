#pragma once

#include "renderer/scene/kernel_scene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace limner {

/// A block of rays: kSize x kSize sub-pixels at a multiple of kSize of the whole picture, whatever the tile, so that
/// every tiling computes the same numbers.
struct KernelBlock {
    static constexpr int kSize = 32;
    int x = 0; ///< first sub-pixel
    int y = 0;
    int width = kSize; ///< rays wanted, from the block's corner; the rest is not computed
    int height = kSize;
    /// Composition by importance; null: the ordinary one. For each slab of depth the greatest importance in it and
    /// behind it, before global weights (ImportanceAhead::kSlabs of them).
    const float* ahead = nullptr;
    const float* weights = nullptr; ///< global weights, kSize * kSize; null: the figure's everywhere
};

struct KernelCounts {
    std::uint64_t samples = 0;
    std::uint64_t shaded = 0;
};

/// Casts the rays of a block; `rgba` holds kSize * kSize premultiplied pixels, row-major. Picks the best instruction
/// set of the machine at run time. Thread-safe.
void castBlock(const KernelScene& scene, const KernelBlock& block, float* rgba, KernelCounts& counts);

/// The same for one kind of voxel; `castBlock` chooses.
void castBlockUint8(const KernelScene& scene, const KernelBlock& block, float* rgba, KernelCounts& counts);
void castBlockInt16(const KernelScene& scene, const KernelBlock& block, float* rgba, KernelCounts& counts);
void castBlockFloat32(const KernelScene& scene, const KernelBlock& block, float* rgba, KernelCounts& counts);

/// Names of the instruction sets that this machine can run, best first: "AVX3" (AVX-512), "AVX2", "SSE4".
std::vector<std::string> kernelTargets();

/// Restricts the kernel to one of these, or "" for the best again; for tests that compare them. Not while rendering.
void restrictKernelTarget(const std::string& name);

} // namespace limner
