#if defined(LIMNER_CORE_OPTICS_PREINTEGRATION_H) == defined(HWY_TARGET_TOGGLE) // see scalar.h
#ifdef LIMNER_CORE_OPTICS_PREINTEGRATION_H
#undef LIMNER_CORE_OPTICS_PREINTEGRATION_H
#else
#define LIMNER_CORE_OPTICS_PREINTEGRATION_H
#endif

#include "core/optics/scalar.h"

// Pre-integration (spec accuracy.md 1.1, 1.6, 1.7): what a slab between two samples shows, its field linear from one
// end to the other. Its opacity is the integral of the extinction over the values between; its colour is taken once, at
// the place where the slab is seen on average. For colours that are linear along the slab that is Moreland and Angel's
// form (2004), c_back (PSI - ZETA) + c_front (1 - PSI), whose place is (PSI - ZETA) / (1 - ZETA).
//
//   s        place on a table of extinctions, in entries; s_f, s_b: of the slab's front and back
//   tau      extinction there: optical depth of the reference length
//   T        integral of tau over s; U, V: of tau s and tau s^2
//   u        place in the slab, 0 at the front, 1 at the back
//   m, v     mean and variance of u, weighed by the extinction
//   PSI      mean over the slab of the transmittance from its front; ZETA: of all of it

LIMNER_OPTICS_BEGIN

/// Extinction that stands for opacity 1: a hundredth of the reference length is nearly opaque, and sums stay exact.
inline constexpr double kOpaqueExtinction = 100;

/// Ends nearer than this, in entries, are one value: a difference of integrals would be rounding.
inline constexpr double kSameEntry = 1.0 / 16;

template <typename T>
T extinctionOfOpacity(const T& opacity) {
    const auto opaque = opacity >= T(1);
    const T depth = -log1p(-select(opaque, T(0), max(T(0), opacity)));
    return select(opaque, T(kOpaqueExtinction), min(depth, T(kOpaqueExtinction)));
}

template <typename T>
struct SlabIntegrals {
    T depth;  ///< T
    T first;  ///< U
    T second; ///< V
};

/// From an entry over a share of the way to the next, the extinction linear between; places count from the entry.
template <typename T>
SlabIntegrals<T> integralsInside(const T& low, const T& high, const T& share) {
    const T rise = (high - low) * share;
    const T square = share * share;
    return {share * (low + rise * T(0.5)), square * (low * T(0.5) + rise * T(1.0 / 3)),
            square * share * (low * T(1.0 / 3) + rise * T(0.25))};
}

/// The same, places counted from further back.
template <typename T>
SlabIntegrals<T> countedFrom(const SlabIntegrals<T>& inside, const T& entry) {
    return {inside.depth, inside.first + entry * inside.depth,
            inside.second + entry * (T(2) * inside.first + entry * inside.depth)};
}

/// Mean extinction of a slab. `integral`: T at the back less T at the front.
template <typename T>
T meanExtinction(const T& front, const T& back, const T& integral, const T& ofEnds) {
    const T way = back - front;
    const auto apart = abs(way) > T(kSameEntry);
    return max(T(0), select(apart, integral / select(apart, way, T(1)), ofEnds));
}

template <typename T>
struct SlabMoments {
    T mean;     ///< m
    T variance; ///< v
};

/// Of an even medium: what a slab with hardly any depth, or of one value, counts as.
template <typename T>
SlabMoments<T> evenMoments() {
    return {T(0.5), T(1.0 / 12)};
}

/// `between`: integrals at the back less those at the front.
template <typename T>
SlabMoments<T> momentsBetween(const T& front, const T& back, const SlabIntegrals<T>& between) {
    const T way = back - front;
    const auto apart = abs(way) > T(kSameEntry);
    const auto usable = abs(between.depth) > T(0);
    const T perWay = T(1) / select(apart, way, T(1));
    const T perDepth = T(1) / select(usable, between.depth, T(1));
    const T place = between.first * perDepth;
    const T mean = clampedToUnit((place - front) * perWay);
    const T variance = (between.second * perDepth - place * place) * perWay * perWay;
    const SlabMoments<T> even = evenMoments<T>();
    return {select(apart, select(usable, mean, even.mean), even.mean),
            select(apart, select(usable, max(T(0), min(T(0.25), variance)), even.variance), even.variance)};
}

/// Mean place of what is seen of an even medium: 1/tau - 1/(e^tau - 1) = (PSI - ZETA) / (1 - ZETA).
template <typename T>
T evenSeenPlace(const T& depth) {
    const auto thin = depth < T(0.1);
    const T series = T(0.5) - depth * (T(1.0 / 12) - depth * depth * T(1.0 / 720)); // next: 3e-10
    const T safe = select(thin, T(1), depth);
    return select(thin, series, T(1) / safe - T(1) / expm1(safe));
}

/// Where a slab of some depth is seen on average: its matter as an even block of the same mean and variance, which
/// hides itself. Exact for a block, a thin sheet, and whatever the matter is for a small depth.
template <typename T>
T seenPlace(const SlabMoments<T>& moments, const T& depth) {
    const T width = sqrt(T(12) * moments.variance);
    return clampedToUnit(moments.mean + width * (evenSeenPlace(depth) - T(0.5)));
}

LIMNER_OPTICS_END

#endif
