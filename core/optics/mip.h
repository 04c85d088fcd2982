#if defined(LIMNER_CORE_OPTICS_MIP_H) == defined(HWY_TARGET_TOGGLE) // see scalar.h
#ifdef LIMNER_CORE_OPTICS_MIP_H
#undef LIMNER_CORE_OPTICS_MIP_H
#else
#define LIMNER_CORE_OPTICS_MIP_H
#endif

#include "core/optics/scalar.h"

// Mip level of a lit sphere (spec style-transfer-functions.md 7). Screen derivatives are undefined in a ray loop, so
// the level comes from the change of normal over the width of the ray. On a surface of curvature k the place on the
// sphere's disk moves by k f over a footprint f, however the surface is tilted.
//
//   f      width of the ray at the sample, voxels
//   k      curvature, 1/voxel; 0 where nobody measures it
//   theta  change of normal over the footprint, radii of the sphere
//   R      radius of the finest picture of the sphere, texels

LIMNER_OPTICS_BEGIN

/// Radius of the ball that stands for all structure whose curvature is not measured, voxels.
inline constexpr double kStructureVoxels = 32;

/// theta = f max(1 / kStructureVoxels, |k|)
template <typename T>
T turnOverFootprint(const T& footprint, const T& curvature) {
    return footprint * max(T(1 / kStructureVoxels), abs(curvature));
}

/// log2(R theta), at least 0. Rays no wider than a voxel read the finest picture: between voxels the field has nothing
/// finer than the rays. From one voxel to two the level grows in, so that nothing jumps where an object is shrunk.
template <typename T>
T mipLevel(const T& radiusTexels, const T& footprint, const T& curvature) {
    const T texels = radiusTexels * turnOverFootprint(footprint, curvature);
    return clampedToUnit(footprint - T(1)) * log2(max(T(1), texels));
}

LIMNER_OPTICS_END

#endif
