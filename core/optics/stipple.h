#if defined(LIMNER_CORE_OPTICS_STIPPLE_H) == defined(HWY_TARGET_TOGGLE) // see scalar.h
#ifdef LIMNER_CORE_OPTICS_STIPPLE_H
#undef LIMNER_CORE_OPTICS_STIPPLE_H
#else
#define LIMNER_CORE_OPTICS_STIPPLE_H
#endif

#include "core/optics/scalar.h"

// How many of a voxel's points are drawn (paper 004, Lu et al. 2002; spec stippling.md; numerics.md 2e): a product of
// factors, each in [0, 1]; a factor that is not finite counts as 1.
//
//   v        data value in [0, 1]
//   g        gradient magnitude over its 99.9th percentile; clamped to [0, 1] here
//   n.e      cosine of the unit normal with the unit direction to the eye; its absolute value is taken
//   l.n      cosine of the light with the unit normal
//   k_...    settings; exponents are at least 0, but for the sign of the distance factor's

LIMNER_OPTICS_BEGIN

template <typename T>
T stippleFactor(const T& raw) {
    return clampedToUnit(finiteOr(raw, T(1)));
}

/// kc + ks x^ke
template <typename T>
struct StippleCurve {
    T constant;
    T scale;
    T exponent;
};

/// T_b = v (kgc + kgs g^kge): more points where tissues meet.
template <typename T>
T boundaryFactor(const T& value, const T& gradientMagnitude, const StippleCurve<T>& curve) {
    const T g = clampedToUnit(gradientMagnitude);
    return stippleFactor(value * (curve.constant + curve.scale * powc(g, curve.exponent)));
}

/// T_s = v (ksc + kss (1 - |n.e|)^kse). The paper writes the raw gradient for n.
template <typename T>
T silhouetteFactor(const T& value, const T& cosineEye, const StippleCurve<T>& curve) {
    const T across = T(1) - clampedToUnit(abs(cosineEye));
    return stippleFactor(value * (curve.constant + curve.scale * powc(across, curve.exponent)));
}

/// T_r = min(1, ((Dnear + d0) / (Dnear + di))^kre): farther means fewer. (The paper prints the ratio the other way
/// round, against its own text.) 1 at and behind the eye.
template <typename T>
T resolutionFactor(const T& nearest, const T& distance, const T& reference, const T& exponent) {
    const T far = nearest + distance;
    const auto ahead = far > T(0);
    const T power = powc((nearest + reference) / select(ahead, far, T(1)), exponent);
    return select(ahead, stippleFactor(power), T(1));
}

/// T_d = (1 + sign(kde) sign(z) |z/a|^|kde|) / 2, z in (-a, a), positive is nearer; 1 (no effect) where kde or a is 0.
/// (The paper's 1 + (z/a)^kde is not defined for z < 0; halved, it lies in [0, 1].)
template <typename T>
T distanceFactor(const T& depth, const T& halfDepth, const T& exponent) {
    const auto deep = halfDepth > T(0);
    const T ratio = max(T(-1), min(T(1), depth / select(deep, halfDepth, T(1))));
    const T power = spow(ratio, abs(exponent));
    const T factor = T(0.5) * (T(1) + select(exponent < T(0), -power, power));
    return select(deep, select(abs(exponent) > T(0), stippleFactor(factor), T(1)), T(1));
}

/// T_t = g^kte: the inside of a tissue thins out.
template <typename T>
T interiorFactor(const T& gradientMagnitude, const T& exponent) {
    return stippleFactor(powc(clampedToUnit(gradientMagnitude), exponent));
}

/// T_l = 1 - max(0, l.n)^kle: shade is drawn.
template <typename T>
T lightingFactor(const T& cosineLight, const T& exponent) {
    return stippleFactor(T(1) - powc(clampedToUnit(cosineLight), exponent));
}

/// N_max = k_max A / (X Y Z)^(2/3): points of a voxel at most; 0 where no area is seen. `resolution`: voxels along each
/// axis, below 1 counts as 1. As a sum of logarithms: the product of three axes leaves 32 bits.
template <typename T>
T mostPoints(const T& density, const T& areaPixels, const Vector3<T>& resolution) {
    const T voxels = log2(max(T(1), resolution.x)) + log2(max(T(1), resolution.y)) + log2(max(T(1), resolution.z));
    return density * max(T(0), areaPixels) * exp2(T(-2.0 / 3) * voxels);
}

LIMNER_OPTICS_END

#endif
