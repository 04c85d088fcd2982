#pragma once

#include "core/figure/figure.h"
#include "core/volume/volume.h"

#include <cstdint>
#include <string>
#include <vector>

namespace limner {

/// What the ray-casting kernel reads: plain pointers and floats, made once per `render` call from a plan.
/// Positions are in *cell* coordinates q = voxel + 1 (see BrickLayout: cell c spans the voxels c-1 and c).

struct KernelLayer {
    Shading shading = Shading::flat;
    bool twoSided = true;
    bool directionalOpacity = false;
    const float* stepOpacity = nullptr;       ///< entries + 1, read by linear interpolation
    const float* opacity = nullptr;           ///< of the reference length; directional opacity only
    const float* colours = nullptr;           ///< Phong and flat: RGBA of every entry and one more, 16-byte aligned
    const float* index = nullptr;             ///< fractional node index; style only
    const std::int32_t* slotOfNode = nullptr; ///< node -> atlas slot
    std::int32_t lastNode = 0;
    std::int32_t singleSlot = -1; ///< >= 0: all nodes have this style, `index` is not read
    float specularStrength = 0;
    float specularExponent = 1;
};

struct KernelAtlas {
    const std::int16_t* texels = nullptr; ///< as StyleAtlas
    const float* mean = nullptr;          ///< four floats per slot
    std::int32_t size = 0;
};

struct KernelPlane { ///< keeps dot(normal, q) <= offset
    double normal[3];
    double offset;
};

struct KernelScene {
    static constexpr int kMaxPlanes = 32;

    const std::uint8_t* bricks = nullptr;
    VoxelType type = VoxelType::uint8;
    bool wide = false;           ///< the store is over 4 GiB: 64-bit offsets
    std::int32_t brickStep[3]{}; ///< from one brick to the next along x, y, z, in bricks
    float lastCell[3]{};         ///< largest position that still has a cell
    double boxLow[3]{};          ///< the rays' box
    double boxHigh[3]{};
    const std::uint8_t* distance = nullptr;
    std::int32_t blocks[3]{};

    float tableScale = 1; ///< from interpolated stored numbers (as the kernel has them) to table entries
    float tableBias = 0;
    const float* visibility = nullptr; ///< greatest stepOpacity of all layers
    float visibleFrom = 0;             ///< entries up to here and from `visibleTo` on show nothing
    float visibleTo = 0;
    const KernelLayer* layers = nullptr;
    int layerCount = 0;
    KernelAtlas atlas;
    float eyeFromGradient[3][3]{}; ///< rows: right, up, towards the viewer; in the kernel's gradient units
    float gradientFloor = 0;

    float opaque = 1;      ///< a ray ends at this opacity
    float stepRatio = 0.5; ///< step / reference length
    float phase = 0.5;

    bool perspective = false;
    double origin[3]{}; ///< as RayFrame, in cell coordinates
    double forward[3]{};
    double right[3]{}; ///< per sub-pixel
    double down[3]{};
    double forwardEye[3]{}; ///< perspective: the same directions in eye space, mm
    double rightEye = 0;
    double downEye = 0;
    double stepMm = 1;
    int planeCount = 0;
    KernelPlane planes[kMaxPlanes];
};

/// A block of rays: kSize x kSize sub-pixels at a multiple of kSize of the whole picture, whatever the tile, so that
/// every tiling computes the same numbers.
struct KernelBlock {
    static constexpr int kSize = 32;
    int x = 0; ///< first sub-pixel
    int y = 0;
    int width = kSize; ///< rays wanted, from the block's corner; the rest is not computed
    int height = kSize;
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
