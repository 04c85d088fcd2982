#if defined(LIMNER_CORE_OPTICS_MEASURES_H) == defined(HWY_TARGET_TOGGLE) // see scalar.h
#ifdef LIMNER_CORE_OPTICS_MEASURES_H
#undef LIMNER_CORE_OPTICS_MEASURES_H
#else
#define LIMNER_CORE_OPTICS_MEASURES_H
#endif

#include "core/optics/scalar.h"
#include "core/optics/shading.h"

// How important a sample is (paper 001; spec importance-composition.md, "Measures" and "Focus lens"; numerics.md 2d).
//
//   g        gradient magnitude over its 99.9th percentile; clamped to [0, 1] here
//   f        |n.v|
//   tau      extinction, 1/length; capped at kGreatestExtinction, so an opaque sample has a finite importance
//   n.h, n.l cosines of the normal (turned to the viewer) with the halfway vector and with the light
//   W        weight in the middle of a lens; distances in figure coordinates

LIMNER_OPTICS_BEGIN

/// An extinction of more, an opaque sample's too, counts as this one: importance ln(1 + 1e6) = 13.8.
inline constexpr double kGreatestExtinction = 1e6;
/// Importance of what has nothing in front of it.
inline constexpr double kUnoccluded = 20;
/// Weighted sums of measures stay below.
inline constexpr double kGreatestImportance = 64;
/// Samples on silhouettes are darkened by up to e^-4.
inline constexpr double kSilhouetteDarkening = 4;

/// x^n by repeated squaring, defined at 0. The exponent is the same for all lanes.
template <typename T>
T wholePower(const T& x, unsigned exponent) {
    T result = T(1);
    T square = x;
    for (unsigned bits = exponent; bits != 0; bits >>= 1U) {
        if ((bits & 1U) != 0) {
            result = result * square;
        }
        square = square * square;
    }
    return result;
}

/// A data value normalised over the volume.
template <typename T>
T intensityImportance(const T& value) {
    return clampedToUnit(value);
}

/// ln(1 + tau), exact for the smallest.
template <typename T>
T extinctionImportance(const T& extinction) {
    return log1p(min(T(kGreatestExtinction), max(T(0), extinction)));
}

template <typename T>
T gradientImportance(const T& gradientMagnitude) {
    return clampedToUnit(gradientMagnitude);
}

template <typename T>
struct SilhouetteTerms {
    T exponent; ///< p
    T low;      ///< edges of the step, in 1 - f
    T high;
};

/// g^p smoothstep(low, high, 1 - f)
template <typename T>
T silhouetteness(const T& gradientMagnitude, const T& facing, const SilhouetteTerms<T>& terms) {
    return powc(clampedToUnit(gradientMagnitude), terms.exponent) *
           smoothStep(terms.low, terms.high, T(1) - clampedToUnit(facing));
}

/// What a colour is multiplied by, so that silhouettes show: e^(-4 silhouetteness).
template <typename T>
T silhouetteDarkening(const T& silhouette) {
    return exp(T(-kSilhouetteDarkening) * silhouette);
}

/// 20 less the optical depth along the ray so far, at least 0.
template <typename T>
T unocclusionImportance(const T& depthSoFar) {
    return max(T(0), T(kUnoccluded) - depthSoFar);
}

/// Unit vector between the directions to the light and to the viewer; zero, so that its term drops out, where they are
/// opposite.
template <typename T>
Vector3<T> halfwayDirection(const Vector3<T>& light, const Vector3<T>& viewer) {
    return normalFromGradient<T>({-(light.x + viewer.x), -(light.y + viewer.y), -(light.z + viewer.z)});
}

struct LightingExponents {
    unsigned highlight = 50;
    unsigned diffuse = 5;
    unsigned gradient = 30;
};

/// 3 - max(0, n.h)^50 - max(0, n.l)^5 - (1 - g)^30, in [0, 3]: what lighting would hide matters. Cosines are clamped
/// first, an even power would light up back faces.
template <typename T>
T lightingImportance(const T& cosineHalfway, const T& cosineLight, const T& gradientMagnitude,
                     const LightingExponents& exponents = {}) {
    return T(3) - wholePower(clampedToUnit(cosineHalfway), exponents.highlight) -
           wholePower(clampedToUnit(cosineLight), exponents.diffuse) -
           wholePower(T(1) - clampedToUnit(gradientMagnitude), exponents.gradient);
}

/// The global weight times the weighted sum of measures, in [0, kGreatestImportance]; what is not finite counts as 0.
template <typename T>
T totalImportance(const T& globalWeight, const T& sum) {
    return max(T(0), min(T(kGreatestImportance), finiteOr(globalWeight * sum, T(0))));
}

/// Importance of what can hardly be seen is taken back, or noise of no opacity would replace what is in front of it.
/// `floor`: extinction below which nothing counts; from four times of it on all does.
template <typename T>
T importanceOfVisible(const T& importance, const T& extinction, const T& floor) {
    return importance * smoothStep(floor, T(4) * floor, extinction);
}

/// W in the circle, 0 outside.
template <typename T>
T circularLens(const T& weight, const T& distance, const T& radius) {
    return select(distance > radius, T(0), weight);
}

/// W e^(-d^2 / (2 s^2)) with s = radius / 2; nothing where the radius is 0.
template <typename T>
T gaussianLens(const T& weight, const T& distance, const T& radius) {
    const auto wide = radius > T(0);
    const T ratio = distance / select(wide, radius, T(1));
    return select(wide, weight * exp(T(-2) * ratio * ratio), T(0));
}

LIMNER_OPTICS_END

#endif
