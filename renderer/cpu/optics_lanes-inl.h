// A vector of floats as the scalar type of the optics templates (what they ask of one: core/optics/scalar.h); compiled
// once for every instruction set. No loop over lanes, no branch on data.
#if defined(LIMNER_OPTICS_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMNER_OPTICS_LANES_INL_H
#undef LIMNER_OPTICS_LANES_INL_H
#else
#define LIMNER_OPTICS_LANES_INL_H
#endif

#include "renderer/cpu/lanes-inl.h" // names the target: before the formulas

#include "core/optics/scalar.h"

#include <hwy/contrib/math/math-inl.h>

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace limner::HWY_NAMESPACE {

/// What a comparison of lanes gives.
struct LaneMask {
    Mask m;
};

struct Lanes {
    Floats v;

    Lanes() = default;
    HWY_INLINE explicit Lanes(double x) : v(splat(static_cast<float>(x))) {}
    HWY_INLINE explicit Lanes(Floats x) : v(x) {}
};

HWY_INLINE Lanes operator+(Lanes a, Lanes b) { return Lanes(hn::Add(a.v, b.v)); }
HWY_INLINE Lanes operator-(Lanes a, Lanes b) { return Lanes(hn::Sub(a.v, b.v)); }
HWY_INLINE Lanes operator*(Lanes a, Lanes b) { return Lanes(hn::Mul(a.v, b.v)); }
HWY_INLINE Lanes operator/(Lanes a, Lanes b) { return Lanes(hn::Div(a.v, b.v)); }
HWY_INLINE Lanes operator-(Lanes a) { return Lanes(hn::Neg(a.v)); }
HWY_INLINE LaneMask operator<(Lanes a, Lanes b) { return {hn::Lt(a.v, b.v)}; }
HWY_INLINE LaneMask operator<=(Lanes a, Lanes b) { return {hn::Le(a.v, b.v)}; }
HWY_INLINE LaneMask operator>(Lanes a, Lanes b) { return {hn::Gt(a.v, b.v)}; }
HWY_INLINE LaneMask operator>=(Lanes a, Lanes b) { return {hn::Ge(a.v, b.v)}; }
HWY_INLINE Lanes select(LaneMask mask, Lanes yes, Lanes no) { return Lanes(hn::IfThenElse(mask.m, yes.v, no.v)); }

// x86 gives the second operand where one is no number, std::min and std::max the first: hence the order.
HWY_INLINE Lanes min(Lanes a, Lanes b) { return Lanes(hn::Min(b.v, a.v)); }
HWY_INLINE Lanes max(Lanes a, Lanes b) { return Lanes(hn::Max(b.v, a.v)); }
HWY_INLINE Lanes abs(Lanes a) { return Lanes(hn::Abs(a.v)); }
HWY_INLINE Lanes sqrt(Lanes a) { return Lanes(hn::Sqrt(a.v)); }

/// k[0] + k[1] x + ... by Horner's rule.
template <std::size_t kCount>
HWY_INLINE Floats polynomial(Floats x, const float (&k)[kCount]) {
    Floats sum = splat(k[kCount - 1]);
    for (std::size_t i = kCount - 1; i > 0; --i) {
        sum = hn::MulAdd(sum, x, splat(k[i - 1]));
    }
    return sum;
}

constexpr float kPositiveInfinity = std::numeric_limits<float>::infinity();

// Beyond these bounds Highway's exponent arithmetic wraps around; exp and 2^x are infinite and 0 there already.
HWY_INLINE Lanes exp(Lanes a) { return Lanes(hn::Exp(kF, hn::Min(splat(100), a.v))); }
HWY_INLINE Lanes expm1(Lanes a) { return Lanes(hn::Expm1(kF, hn::Min(splat(100), a.v))); }

/// With the poles that Highway's leaves out: -infinity at -1, infinity at infinity.
HWY_INLINE Lanes log1p(Lanes a) {
    const Floats pole = hn::IfThenElse(hn::Le(a.v, splat(-1)), splat(-kPositiveInfinity), hn::Log1p(kF, a.v));
    return Lanes(hn::IfThenElse(hn::Lt(a.v, splat(kPositiveInfinity)), pole, a.v));
}

/// 2^n for a whole n from -126 to 127.
HWY_INLINE Floats powerOfTwo(Ints n) { return hn::BitCast(kF, hn::ShiftLeft<23>(hn::Add(n, splatInt(127)))); }

/// 2^x = 2^n 2^f with f in [-1/2, 1/2]: exact reduction, so that large x lose nothing. (2^f - 1) / f as the polynomial
/// of degree 5 that is best over Chebyshev nodes (1.4e-8). Relative error 1e-7.
HWY_INLINE Lanes exp2(Lanes a) {
    const Floats x = hn::Max(splat(-152), hn::Min(splat(130), a.v));
    const Floats whole = hn::Round(x);
    const Floats f = hn::Sub(x, whole);
    const float k[] = {0.693147182F, 0.240226507F, 0.0555035695F, 0.00961808302F, 0.00133908633F, 0.000154531634F};
    const Floats power = hn::MulAdd(polynomial(f, k), f, splat(1));
    const Ints n = truncate(whole);
    const Ints half = hn::ShiftRight<1>(n); // in two parts: each has an exponent that float32 knows
    return Lanes(hn::Mul(hn::Mul(power, powerOfTwo(half)), powerOfTwo(hn::Sub(n, half))));
}

/// log2(x) = e + log2(m) with m = 1 + r in [sqrt(1/2), sqrt(2)): exact at powers of two, relative error 2e-7 near 1
/// too. (log2(1 + r) - r / ln 2) / r^2 as the best polynomial of degree 8 (7e-8). -infinity at 0, no number below.
HWY_INLINE Lanes log2(Lanes a) {
    const auto tiny = hn::Lt(a.v, splat(1.17549435e-38F));
    const Floats x = hn::IfThenElse(tiny, hn::Mul(a.v, splat(33554432)), a.v); // 2^25
    const Ints root = splatInt(0x3F3504F3);                                    // sqrt(1/2)
    const Ints e = hn::ShiftRight<23>(hn::Sub(hn::BitCast(kI, x), root));
    const Floats r = hn::Sub(hn::BitCast(kF, hn::Sub(hn::BitCast(kI, x), hn::ShiftLeft<23>(e))), splat(1));
    const Floats exponent = hn::Sub(toFloat(e), hn::IfThenElseZero(tiny, splat(25)));
    const float k[] = {-0.721347511F, 0.480898291F,  -0.360685021F, 0.288556814F, -0.239871785F,
                       0.204932719F,  -0.189390644F, 0.183549598F,  -0.110707387F};
    const Floats log = hn::MulAdd(r, splat(1.44269504F), hn::Mul(hn::Mul(r, r), polynomial(r, k)));
    const Floats positive = hn::Add(exponent, log);
    const Floats inside = hn::IfThenElse(hn::Lt(a.v, splat(kPositiveInfinity)), positive, a.v);
    const Floats pole = hn::IfThenElse(hn::Lt(a.v, splat(0)), splat(std::numeric_limits<float>::quiet_NaN()),
                                       splat(-kPositiveInfinity));
    return Lanes(hn::IfThenElse(hn::Le(a.v, splat(0)), pole, inside));
}

/// x^y for x >= 0; 1 where y is 0, as std::pow. Relative error 1e-7 (1 + |y log2 x|).
HWY_INLINE Lanes pow(Lanes x, Lanes y) {
    const Floats power = exp2(Lanes(hn::Mul(y.v, log2(x).v))).v;
    return Lanes(hn::IfThenElse(hn::Eq(y.v, hn::Zero(kF)), splat(1), power));
}

/// Angle of (x, y), finite, in all four quadrants; 0 at the origin. Absolute error 4e-7. From the arc tangent of the
/// smaller over the larger: (atan(t) / t - 1) / t^2 as the best polynomial of degree 8 in t^2 (2e-8).
HWY_INLINE Lanes atan2(Lanes y, Lanes x) {
    const Floats absoluteX = hn::Abs(x.v);
    const Floats absoluteY = hn::Abs(y.v);
    const Floats larger = hn::Max(absoluteX, absoluteY);
    const Floats divisor = hn::IfThenElse(hn::Gt(larger, hn::Zero(kF)), larger, splat(1));
    const Floats t = hn::Div(hn::Min(absoluteX, absoluteY), divisor);
    const Floats square = hn::Mul(t, t);
    const float k[] = {-0.333333313F, 0.199997395F,   -0.142785683F, 0.110337645F,   -0.0865688026F,
                       0.0625016913F, -0.0358715393F, 0.0135077713F, -0.00238699722F};
    const Floats small = hn::MulAdd(hn::Mul(t, square), polynomial(square, k), t);
    const Floats quarter = hn::IfThenElse(hn::Gt(absoluteY, absoluteX), hn::Sub(splat(1.57079637F), small), small);
    const Floats angle = hn::IfThenElse(hn::Lt(x.v, hn::Zero(kF)), hn::Sub(splat(3.14159274F), quarter), quarter);
    return Lanes(hn::CopySignToAbs(angle, y.v));
}

} // namespace limner::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
