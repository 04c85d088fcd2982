#pragma once

#include "core/figure/figure.h"
#include "core/style/transfer_function.h"
#include "core/volume/volume.h"

#include <cstddef>
#include <cstdint>

namespace limner {

/// Of any instruction set: arrays that are read a vector at a time are at least as long.
inline constexpr std::size_t kMostLanes = 16;

/// What a ray-casting kernel reads, on whichever processor: plain pointers and floats, made once per `render` call from
/// a plan. Positions are in *cell* coordinates q = voxel + 1 (see BrickLayout: cell c spans the voxels c-1 and c).

/// The SIMD kernel's interpolated values are the stored numbers times this: integer voxels are blended by whole
/// weights.
constexpr float kernelScale(VoxelType type) { return type == VoxelType::float32 ? 1.0F : 32767.0F; }

/// Nodes along an axis of a transfer function: from entry `from[i]` on, the index is i + (entry - from[i]) *
/// perEntry[i], at most i + 1. So few fit a vector or two, and no table need be read.
struct KernelNodes {
    int count = 0; ///< 0: the index is in a table
    float from[kMostLanes]{};
    float perEntry[kMostLanes]{};
};

/// How a place on an axis of a transfer function is found: raw * scale + bias, in entries of the layer's table.
struct KernelAxis {
    TransferAxis axis = TransferAxis::value;
    float scale = 1;
    float bias = 0;
    float last = 0; ///< last entry
    KernelNodes nodes;
    const std::uint8_t* bricks = nullptr; ///< distance from a label, second volume: int16, laid out as the voxels
    float from[3]{};                      ///< distance from a point: where, in cell coordinates
    float mmFromCell[3][3]{};             ///< and the grid's matrix, rows
};

struct KernelContours {
    bool on = false;
    bool controlled = true;
    bool normals = false; ///< curvature by two normals
    float thicknessMm = 0;
    float fixedWidth = 0;
    float probeMm = 1; ///< between the two normals
};

/// A style's texture: size^2 RGBA factors; no texels: none.
struct KernelTexture {
    const float* texels = nullptr;
    std::int32_t size = 1; ///< a power of two
    float perMm = 1;       ///< tiles
    float strength = 0;
};

/// A layer's parts (PlanParts); null pointers and zeros: absent. Tables have kRampEntries and one more.
struct KernelParts {
    bool any = false;
    float lastEntry = 0;
    const float* tone = nullptr;     ///< RGBA, 16-byte aligned
    float light[3]{0, 0, 1};         ///< eye space, unit; of tone and highlight
    bool ownLight = false;           ///< else the highlight's light is at the eye
    const float* position = nullptr; ///< RGBA, 16-byte aligned
    float placeFromCell[4]{};
    const float* gradientOpacity = nullptr;
    const float* lineOpacity = nullptr;
    float silhouetteOpacity = 0;
    float silhouetteFull = 0;
    float silhouetteNone = 0;
    float silhouetteRgb[4]{};
    float specularStrength = 0;
    float specularExponent = 1;
};

/// PlanCut.
struct KernelCut {
    static constexpr int kMaxPlanes = 72; ///< a box and as many planes as a figure may have
    struct Plane {
        float insideFromCell[4]; ///< mm inside
        float normalEye[3];
        float rgb[3];
    };
    int count = 0;
    Plane planes[kMaxPlanes];
    bool faces = false;
    bool coloured = false;
    float perVoxel = 1; ///< 1 / mm
};

/// One of the blurred copies for depth of field.
struct KernelBlur {
    const std::uint8_t* bricks = nullptr; ///< int16, laid out as the voxels
    float entryScale = 0;                 ///< from the stored number to table entries
    float entryBias = 0;
    float eyeFromSlope[3][3]{}; ///< as KernelScene::eyeFromGradient, from stored numbers per cell
};

/// CueField: cell = q * perCell + bias.
struct KernelCue {
    const float* values = nullptr; ///< null: absent
    std::int32_t dims[3]{1, 1, 1};
    float perCell = 1;
    float bias = 0;
    float outMm = 0; ///< how far out of the surface it is read
};

struct KernelCues {
    bool any = false;
    KernelCue ambient; ///< four channels: mean, and a vector in patient coordinates
    KernelCue shadow;
    KernelCue halo;
    float ambientStrength = 0;
    float shadowStrength = 0;
    float haloStrength = 0;
    float light[3]{0, 0, 1}; ///< the shadow's, eye space
    float haloRgb[4]{};
};

struct KernelLayer {
    Shading shading = Shading::flat;
    bool twoSided = true;
    bool illustrative = false;
    bool directionalOpacity = false;
    bool opacityByValue = true; ///< `stepOpacity` is the whole truth
    KernelAxis x;
    KernelAxis y;                             ///< two dimensions only
    int rows = 0;                             ///< of `opacity2d`; 0: one dimension
    std::int32_t rowStride = 0;               ///< floats
    const float* stepOpacity = nullptr;       ///< 1D: of one step; entries + 1, read by linear interpolation
    const float* slabs = nullptr;             ///< pre-integration: PlanLayer::slabs
    const float* opacity = nullptr;           ///< 1D: of the reference length
    const float* opacity2d = nullptr;         ///< 2D: of the reference length
    const float* colours = nullptr;           ///< 1D Phong and flat: RGBA of every entry and one more, 16-byte aligned
    const float* index = nullptr;             ///< fractional node column of every entry, as `x.nodes`
    const float* rowIndex = nullptr;          ///< fractional node row of every row, as `y.nodes`
    const std::int32_t* slotOfNode = nullptr; ///< node -> atlas slot; at least kMostLanes readable
    std::int32_t nodes = 0;                   ///< of slotOfNode
    const float* nodeColours = nullptr;       ///< 2D Phong and flat: RGBA of every node, 16-byte aligned
    std::int32_t lastColumn = 0;              ///< of the nodes
    std::int32_t lastRow = 0;
    std::int32_t columnStride = 1;
    std::int32_t nodeRowStride = 0;
    const KernelTexture* textures = nullptr;  ///< one per node; null: no style has one
    bool oneColour = false;                   ///< Phong and flat: all nodes have the first one's
    std::int32_t singleSlot = -1;             ///< >= 0: all nodes have this style, `index` is not read
    const std::int16_t* rowOfSlot = nullptr;  ///< label axis: label slot -> row, -1: none
    const std::uint8_t* shownSlots = nullptr; ///< label slot -> 1 where it shows
    bool curvedLevels = false;                ///< mip levels go by the curvature too
    KernelContours contours;
    float ambient = 0; ///< Phong's shares
    float diffuse = 0;
    float specularStrength = 0;
    float specularExponent = 1;
    float importanceWeight = 1;
    KernelParts parts;
    const KernelCut* cut = nullptr; ///< of this layer alone
    float focusStrength = 0;        ///< depth of field; 0: none
    float focus = 0;
    float depthFromCell[4]{}; ///< 0 at the front, 1 at the back
};

struct KernelAtlas {
    const std::int16_t* texels = nullptr; ///< as StyleAtlas
    const float* mean = nullptr;          ///< four floats per slot
    std::int32_t size = 0;
    const std::int32_t* levelStart = nullptr; ///< as StyleAtlas; null: there is one level
    std::int32_t lastLevel = 0;
    float radiusTexels = 1;    ///< PlanMipLevels
    float footprintVoxels = 1; ///< PlanMipLevels
    float voxelMm = 1;         ///< PlanMipLevels
};

/// Weights that a value or gradient gives the four voxels of each axis.
enum class KernelTaps { spline, sobel, neumann };

enum class KernelGradient { central, taps, fourthOrder };

/// Importance-aware composition; weights of measures that are not taken are 0.
struct KernelImportance {
    float global = 0; ///< where the block has no weights of its own
    float intensity = 0;
    float extinction = 0;
    float gradient = 0;
    float silhouette = 0;
    float unocclusion = 0;
    float lighting = 0;
    float object = 0;
    float statisticsWeight = 0; ///< of the stored number
    float background = 0;
    float limit = 0;     ///< the cap, no more than what all importances stay below
    float layerMost = 0; ///< greatest weight of a layer
    bool settles =
        false; ///< what lies ahead bounds a sample's importance: where that claims nothing it is not measured
    float noiseFloor = 0;
    float intensityScale = 1; ///< of table entries
    float intensityBias = 0;
    float silhouetteExponent = 1;
    float silhouetteLow = 0;
    float silhouetteHigh = 1;
    float darkening = 0;
    float actsPerWeight = 1; ///< 1 / the figure's global weight
    float light[3]{0, 0, 1}; ///< eye space, unit
    unsigned highlight = 50; ///< exponents of lighting
    unsigned diffuse = 5;
    unsigned flat = 30;
    const float* weightOfSlot = nullptr;      ///< label slot -> weight of the object
    const std::uint8_t* statistics = nullptr; ///< int16, 0..1, laid out as the voxels
    float slabFromCell[4]{};                  ///< as ImportanceAhead::slabFromVoxel
};

struct KernelPlane { ///< keeps dot(normal, q) <= offset
    double normal[3];
    double offset;
};

struct KernelScene {
    static constexpr int kMaxPlanes = KernelCut::kMaxPlanes;

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
    const float* visibility = nullptr; ///< one layer of early opacity: of a step; else > 0 where any layer can show
    float lastEntry = 0;               ///< a spline may leave the data's range: entries are clamped to the table
    float visibleFrom = 0;             ///< entries up to here and from `visibleTo` on show nothing
    float visibleTo = 0;
    float gapFrom = 0; ///< nor does what lies between: the widest such stretch; none: above `gapTo`
    float gapTo = 0;
    bool earlyOpacity = true;   ///< a sample's opacity is known before its colour: every layer's is by value alone
    bool preintegrated = false; ///< samples are slabs, opacity is early
    const KernelLayer* layers = nullptr;
    int layerCount = 0;
    KernelAtlas atlas;
    bool spline = false; ///< values by the cubic B-spline instead of linear interpolation
    KernelGradient gradient = KernelGradient::central;
    KernelTaps gradientTaps = KernelTaps::spline;
    const std::uint8_t* gradientBricks = nullptr; ///< what taps read
    bool gradientOfOwnType = true;                ///< the voxels' type; else int16 (float32 beside float32 voxels)
    float eyeFromGradient[3][3]{}; ///< rows: right, up, towards the viewer; stored units per mm from the kernel's own
    const std::uint8_t* bendBricks = nullptr; ///< what the curvature's derivatives read
    bool bendOfOwnType = true;                ///< as gradientOfOwnType
    float eyeFromBend[3][3]{};                ///< the same rows for their gradient, from its stored units per voxel
    float gradientRounding = 0;               ///< components of tap gradients up to this are 0; in stored units
    float gradientFloor = 0;
    float perGradientMax = 1; ///< 1 / the gradient that counts as 1

    bool readsNormal = false;        ///< some layer does
    bool readsGradientScale = false; ///< beside the normal's direction
    bool readsBend = false;
    float mmFromEye[3][3]{};              ///< turns a direction to patient coordinates
    float mmFromCell[3][4]{};             ///< patient coordinates of a position
    float cellFromEye[3][3]{};            ///< 1 mm in eye space, in cells
    float depthFromCell[4]{0, 0, 0, 1};   ///< depth over the target's, linear in the position
    const std::uint8_t* labels = nullptr; ///< label slots, uint8, laid out as the voxels

    KernelImportance importance;
    KernelImportance axisImportance;  ///< what the axis "importance" of transfer functions adds up
    const KernelCut* faces = nullptr; ///< of the figure's cuts, where they are drawn flat
    KernelBlur blurs[3];              ///< where a layer has depth of field
    KernelCues cues;

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

} // namespace limner
