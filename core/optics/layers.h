#if defined(LIMNER_CORE_OPTICS_LAYERS_H) == defined(HWY_TARGET_TOGGLE) // see scalar.h
#ifdef LIMNER_CORE_OPTICS_LAYERS_H
#undef LIMNER_CORE_OPTICS_LAYERS_H
#else
#define LIMNER_CORE_OPTICS_LAYERS_H
#endif

#include "core/optics/scalar.h"

// Parts of a layer and depth cues (paper 003 section 2; spec layers.md). A sample is classified, toned, thinned by its
// gradient and tinted by its place; then line and highlight follow with a gradient map of their own.
//
//   a, c     opacity of the reference length and colour of the transfer function
//   n, v, l  unit normal, unit directions to the viewer and to the light, eye space
//   d        how far the normal is worth anything, 0 to 1 (normalDefinedness)
//   g_s, g_l gradient maps of the shading, and of line and highlight

LIMNER_OPTICS_BEGIN

/// Place on a tone ramp: 0 where a surface looks away from the light, 1 where it faces it, the middle where there is no
/// surface.
template <typename T>
T tonePlace(const T& normalToLight, const T& definedness) {
    return T(0.5) + T(0.5) * definedness * max(T(-1), min(T(1), normalToLight));
}

/// How much of a silhouette there is: 1 where |n.v| <= full, 0 from `none` on. Equal edges: a step. full <= none.
template <typename T>
T silhouetteShare(const T& facing, const T& full, const T& none, const T& definedness) {
    return definedness * (T(1) - smoothStep(full, none, abs(facing)));
}

/// n.h, h half way between light and viewer; 0 where the light is right behind or the surface looks away from it.
template <typename T>
T halfway(const T& normalToLight, const T& facing, const T& lightToViewer) {
    const T squared = T(2) + T(2) * lightToViewer; // |l + v|^2
    const auto usable = squared > T(1e-6);
    const T cosine = (normalToLight + facing) / sqrt(select(usable, squared, T(1)));
    return select(usable, clampedToUnit(cosine), T(0));
}

/// Opacity of shading with a line over it, at one place.
template <typename T>
T withLine(const T& shading, const T& line) {
    return shading + line - shading * line;
}

/// The line's share of the colour. Both are opacities of the reference length, so that it does not depend on the step.
template <typename T>
T lineShare(const T& shading, const T& line) {
    const T all = withLine(shading, line);
    return select(all > T(0), line / select(all > T(0), all, T(1)), T(0));
}

/// Length share of a sample on the kept side of a plane, whose distance inside (mm) it has at its middle; `reach`: how
/// much the distance changes over the sample, >= 0. Exact for one plane.
template <typename T>
T keptByPlane(const T& inside, const T& reach) {
    const auto sloped = reach > T(1e-6);
    const T share = clampedToUnit(T(0.5) + inside / select(sloped, reach, T(1)));
    return select(sloped, share, select(inside >= T(0), T(1), T(0)));
}

/// How far a sample belongs to the face of a cut: all within a voxel of it, not at all from the second on.
template <typename T>
T cutFaceShare(const T& insideVoxels) {
    return clampedToUnit(T(2) - insideVoxels);
}

/// Blurred copies of a scan, the k-th (k = 1, 2, 3) with a standard deviation of 2^(k-1) voxels.
inline constexpr int kBlurLevels = 3;

/// Slope of such a copy, in its stored numbers per voxel: copies are rounded to whole numbers, so that one of them is
/// no slope. Continuous.
template <typename T>
T slopeOfCopy(const T& slope) {
    const T beyond = max(T(0), abs(slope) - T(1));
    return select(slope < T(0), -beyond, beyond);
}

/// Depth of field: levels of blur at a depth from 0 (front) to 1 (back); strength 1 blurs by four levels over the whole
/// depth.
template <typename T>
T blurLevel(const T& depth, const T& focus, const T& strength) {
    return min(T(kBlurLevels), T(4) * strength * abs(depth - focus));
}

/// How much light matter around a surface takes, from occlusion over all directions: its mean, and 2 n . (mean of
/// occlusion times direction), the cosine-weighted rest of a first-order expansion. 0 on a flat surface, whichever side
/// of the step of opacity the sample lies on; 1 where all around is shut.
template <typename T>
T ambientOcclusion(const T& mean, const T& normalDotVector, const T& definedness) {
    return definedness * clampedToUnit(mean + T(2) * normalDotVector);
}

/// Share of a cast shadow that counts: a surface that looks away from the light is dark by its shading already.
template <typename T>
T shadowed(const T& occlusion, const T& normalToLight, const T& definedness) {
    return definedness * clampedToUnit(occlusion) * smoothStep(T(0), T(0.3), normalToLight);
}

LIMNER_OPTICS_END

#endif
