// Re-included once per instruction set by code that uses Highway's foreach_target.h (that is what the toggle below is
// for: HWY_TARGET_TOGGLE flips on every pass); an ordinary include guard everywhere else.
#if defined(LIMNER_CORE_OPTICS_SCALAR_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMNER_CORE_OPTICS_SCALAR_H
#undef LIMNER_CORE_OPTICS_SCALAR_H
#else
#define LIMNER_CORE_OPTICS_SCALAR_H
#endif

#include <algorithm>
#include <cmath>

// Everything one instruction set compiles sits in that set's own namespace, or the linker may keep one set's copy for
// all of them. Without Highway the formulas are limner::optics.
#if defined(HWY_TARGET_INCLUDE) && !defined(HWY_NAMESPACE)
#error "include <hwy/highway.h> before the formulas: it names the instruction set"
#endif
#ifndef LIMNER_OPTICS_BEGIN
#ifdef HWY_NAMESPACE
#define LIMNER_OPTICS_BEGIN                                                                                            \
    HWY_BEFORE_NAMESPACE();                                                                                            \
    namespace limner {                                                                                                 \
    namespace HWY_NAMESPACE {                                                                                          \
    namespace optics {
#define LIMNER_OPTICS_END                                                                                              \
    }                                                                                                                  \
    }                                                                                                                  \
    }                                                                                                                  \
    HWY_AFTER_NAMESPACE();
#else
#define LIMNER_OPTICS_BEGIN                                                                                            \
    namespace limner {                                                                                                 \
    namespace optics {
#define LIMNER_OPTICS_END                                                                                              \
    }                                                                                                                  \
    }
#endif
#endif

LIMNER_OPTICS_BEGIN

/// What a scalar type T of the optics templates has to offer. `double` and `float` have it here (their mask is bool); a
/// SIMD vector type brings its own in its namespace, where argument-dependent lookup finds them:
/// T(double) · + - * / and unary - · comparisons < <= > >= giving a mask · select(mask, T, T) ·
/// min, max, abs, sqrt, exp, expm1, log1p, exp2, log2, pow, atan2.
/// min and max give their first argument where one of the two is no number, as std::min and std::max do.
/// The formulas never branch on data: both sides are evaluated, and both must be harmless to evaluate.

inline constexpr double kLn2 = 0.69314718055994530942;

using std::abs;
using std::atan2;
using std::exp;
using std::exp2;
using std::expm1;
using std::log1p;
using std::log2;
using std::max;
using std::min;
using std::pow;
using std::sqrt;

inline double select(bool mask, double yes, double no) { return mask ? yes : no; }
inline float select(bool mask, float yes, float no) { return mask ? yes : no; }

template <typename T>
struct Vector3 {
    T x;
    T y;
    T z;
};

template <typename T>
T dot(const Vector3<T>& a, const Vector3<T>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <typename T>
Vector3<T> scaled(const Vector3<T>& v, const T& factor) {
    return {v.x * factor, v.y * factor, v.z * factor};
}

/// a + (b - a) * w
template <typename T>
T mixed(const T& a, const T& b, const T& w) {
    return a + (b - a) * w;
}

template <typename T>
T clampedToUnit(const T& x) {
    return max(T(0), min(T(1), x));
}

/// x, or the other where x is infinite or no number.
template <typename T>
T finiteOr(const T& x, const T& other) {
    return select(x - x >= T(0), x, other); // the difference is 0 or no number
}

/// x^y with its ends defined: 1 for y = 0, 0 for x <= 0 (y > 0; numerics.md, powc). What is no number stays none.
/// Exponents below 0 belong to no formula.
template <typename T>
T powc(const T& x, const T& y) {
    const auto nothing = x <= T(0);
    const T power = exp2(y * log2(select(nothing, T(1), x)));
    return select(abs(y) > T(0), select(nothing, T(0), power), T(1));
}

/// sign(x) powc(|x|, y): monotonic in x for every y.
template <typename T>
T spow(const T& x, const T& y) {
    const T power = powc(abs(x), y);
    return select(x < T(0), -power, power);
}

/// Hermite step; where the edges are equal it is the step `x >= edge` (GLSL leaves that open; numerics.md).
template <typename T>
T smoothStep(const T& low, const T& high, const T& x) {
    const T width = high - low;
    const T safeWidth = select(width > T(0), width, T(1));
    const T t = clampedToUnit((x - low) / safeWidth);
    return select(width > T(0), t * t * (T(3) - T(2) * t), select(x >= low, T(1), T(0)));
}

LIMNER_OPTICS_END

#endif
