#if defined(LIMNER_CORE_OPTICS_IMPORTANCE_H) == defined(HWY_TARGET_TOGGLE) // see scalar.h
#ifdef LIMNER_CORE_OPTICS_IMPORTANCE_H
#undef LIMNER_CORE_OPTICS_IMPORTANCE_H
#else
#define LIMNER_CORE_OPTICS_IMPORTANCE_H
#endif

#include "core/optics/opacity.h"
#include "core/optics/scalar.h"

// Importance-aware composition (paper 001, de Moura Pinto and Freitas 2010; spec importance-composition.md; numerics.md
// 2c): the stable form, the same function as the published one.
//
//   c, a     colour (not multiplied by a) and opacity gathered so far
//   I        importance so far, Iref + ln e; Iref is the greatest met, e is in (0, 1]
//   as, Is   opacity of a sample (corrected for the step) and its importance
//   k        share of the colour so far that a sample leaves

LIMNER_OPTICS_BEGIN

/// State of a ray. (No initial values here: a constructor that the compiler makes knows nothing of instruction sets.)
template <typename T>
struct ImportanceState {
    Colour<T> colour; ///< c
    T opacity;        ///< a
    T share;          ///< e
    T reference;      ///< Iref
};

/// Where a ray begins. Importance starts at 0: part of the format, it shows in the picture.
template <typename T>
ImportanceState<T> startOfRay() {
    return {{T(0), T(0), T(0)}, T(0), T(1), T(0)};
}

/// What a sample makes of a ray's state but its colour, and k.
template <typename T>
struct ImportanceStep {
    T kept;
    T opacity;
    T share;
    T reference;
};

/// A sample without opacity (or whose opacity is no number) changes nothing: k is 1.
template <typename T>
ImportanceStep<T> stepOfSample(const ImportanceState<T>& ray, const T& opacity, const T& importance) {
    const auto visible = opacity > T(0);
    const T alpha = select(visible, min(T(1), opacity), T(0));
    const auto rises = importance > ray.reference;
    const T fall = exp(-abs(importance - ray.reference));
    const T before = ray.share * select(rises, fall, T(1));
    const T sample = select(rises, T(1), fall); // e^(Is - Iref)
    const T share = before + alpha * max(T(0), sample - before);
    const T whole = ray.opacity + (T(1) - ray.opacity) * alpha;
    const auto claims = ray.opacity * sample > before;
    const T base = select(claims, share, whole);
    const auto divides = base > T(0);
    const T kept = select(claims, before, ray.opacity) / select(divides, base, T(1));
    return {select(visible, kept, T(1)), whole, select(visible, share, ray.share),
            select(visible, max(ray.reference, importance), ray.reference)};
}

/// The ray after one more sample. All values are convex combinations: nothing overflows, nothing divides 0 by 0.
template <typename T>
ImportanceState<T> withSample(const ImportanceState<T>& ray, const Colour<T>& colour, const T& opacity,
                              const T& importance) {
    const ImportanceStep<T> step = stepOfSample(ray, opacity, importance);
    const auto visible = opacity > T(0);
    const auto behind = [&](const T& here, const T& before) {
        return select(visible, mixed(here, before, step.kept), before); // the colour of what is not seen may be any
    };
    return {{behind(colour.r, ray.colour.r), behind(colour.g, ray.colour.g), behind(colour.b, ray.colour.b)},
            step.opacity,
            step.share,
            step.reference};
}

/// Premultiplied colour and opacity.
template <typename T>
Accumulated<T> composed(const ImportanceState<T>& ray) {
    const T a = ray.opacity;
    return {ray.colour.r * a, ray.colour.g * a, ray.colour.b * a, a};
}

/// The scalars of a ray's state with e^I in one number: for importances from 0 to kGreatestImportance, whose
/// exponentials float32 holds. (The bounds are what the reference is for.)
template <typename T>
struct ExponentialState {
    T opacity;     ///< a
    T exponential; ///< e^I
};

/// `withSample` for the scalars: takes a sample of as > 0 and e^Is into `ray`, gives k, the share of the colour so far
/// that it leaves.
template <typename T>
T keptBehind(ExponentialState<T>& ray, const T& opacity, const T& exponential) {
    const T share = ray.exponential + opacity * max(T(0), exponential - ray.exponential);
    const T whole = ray.opacity + (T(1) - ray.opacity) * opacity;
    const auto claims = ray.opacity * exponential > ray.exponential;
    const T kept = select(claims, ray.exponential, ray.opacity) / select(claims, share, whole);
    ray = {whole, share};
    return kept;
}

/// What of the ray's colour is left in front of a background of importance Ib: the picture's alpha, min(a, E/Eb).
template <typename T>
T shareBeforeBackground(const ImportanceState<T>& ray, const T& background) {
    return min(ray.opacity, ray.share * exp(min(T(80), ray.reference - background)));
}

/// I. Where e is small the two parts cancel: an absolute error of an ulp of Iref.
template <typename T>
T importanceSoFar(const ImportanceState<T>& ray) {
    return ray.reference + T(kLn2) * log2(ray.share);
}

/// Share of the final colour that is certain whatever follows, a min(1, E / Emax): a ray may end where 1 less this is
/// small enough. `ahead`: the greatest importance still to come. Opacity alone is no reason to end a ray.
template <typename T>
T certainShare(const ImportanceState<T>& ray, const T& ahead) {
    // e^80 times any share that a ray can have is over 1, and float32 still has it
    return ray.opacity * min(T(1), ray.share * exp(min(T(80), ray.reference - ahead)));
}

LIMNER_OPTICS_END

#endif
