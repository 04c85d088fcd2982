#if defined(LIMNER_CORE_OPTICS_OPACITY_H) == defined(HWY_TARGET_TOGGLE) // see scalar.h
#ifdef LIMNER_CORE_OPTICS_OPACITY_H
#undef LIMNER_CORE_OPTICS_OPACITY_H
#else
#define LIMNER_CORE_OPTICS_OPACITY_H
#endif

#include "core/optics/scalar.h"

// Opacity per length and composition (spec style-transfer-functions.md 5, 6; numerics.md 2b).
//
//   a_u    opacity of one reference length d0, from the opacity curve
//   a_d    directional opacity, the alpha of a lit-sphere style at the normal
//   d      length that a sample stands for
//   tau    optical depth, -ln(1 - a)
//   C, a   accumulated colour (premultiplied) and opacity along the ray, front to back

LIMNER_OPTICS_BEGIN

/// Uniform transparency: a = a_d * a_u. (The illustrative kind is a formula of its own.)
template <typename T>
T uniformOpacity(const T& directional, const T& opacity) {
    return directional * opacity;
}

/// tau of an opacity; infinite for a = 1.
template <typename T>
T opticalDepth(const T& opacity) {
    return -log1p(-opacity);
}

/// a of an optical depth; 1 for an infinite one.
template <typename T>
T opacityOfDepth(const T& depth) {
    return -expm1(-depth);
}

/// a' = 1 - (1 - a)^(d/d0), stable for the smallest opacities and lengths. a = 1 stays 1 for every d > 0; d = 0 gives
/// 0.
template <typename T>
T opacityOfLength(const T& opacity, const T& lengthRatio) {
    const auto opaque = opacity >= T(1);
    const T translucent = select(opaque, T(0), max(T(0), opacity)); // keeps 0 * infinity out
    const T corrected = -expm1(lengthRatio * log1p(-translucent));
    return select(lengthRatio > T(0), select(opaque, T(1), corrected), T(0));
}

template <typename T>
struct Colour {
    T r;
    T g;
    T b;
};

/// Premultiplied colour and opacity gathered so far.
template <typename T>
struct Accumulated {
    T r;
    T g;
    T b;
    T a;
};

/// One sample behind all that came before: C += (1 - a) a' c, a += (1 - a) a'.
template <typename T>
Accumulated<T> compositeBehind(const Accumulated<T>& front, const Colour<T>& colour, const T& opacity) {
    const T weight = (T(1) - front.a) * opacity;
    return {front.r + weight * colour.r, front.g + weight * colour.g, front.b + weight * colour.b, front.a + weight};
}

LIMNER_OPTICS_END

#endif
