#if defined(LIMNER_CORE_OPTICS_TRANSPARENCY_H) == defined(HWY_TARGET_TOGGLE) // see scalar.h
#ifdef LIMNER_CORE_OPTICS_TRANSPARENCY_H
#undef LIMNER_CORE_OPTICS_TRANSPARENCY_H
#else
#define LIMNER_CORE_OPTICS_TRANSPARENCY_H
#endif

#include "core/optics/scalar.h"

// Illustrative transparency, the 100-percent rule (paper 000 section 4.3; spec style-transfer-functions.md 5;
// numerics.md 2b).
//
//   a_u    opacity of the transfer function
//   a_d    directional opacity, the alpha of a lit-sphere style at the normal
//   f, c   |n.v| and where contours end, see contour.h
//   g      gradient magnitude over its 99.9th percentile

LIMNER_OPTICS_BEGIN

/// a = a_d a_u^e with e = 1/2 + max(0, f - c) (1 - g), in [1/2, 3/2]: smaller a_u clears flat regions before contours;
/// a_u = 1 gives a_d, a_u = 0 gives 0.
template <typename T>
T illustrativeOpacity(const T& directional, const T& opacity, const T& facing, const T& width,
                      const T& gradientMagnitude) {
    const T overContour = max(T(0), clampedToUnit(facing) - width);
    const T exponent = T(0.5) + overContour * (T(1) - clampedToUnit(gradientMagnitude));
    return directional * select(opacity > T(0), powc(min(T(1), opacity), exponent), T(0));
}

LIMNER_OPTICS_END

#endif
