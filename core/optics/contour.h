#if defined(LIMNER_CORE_OPTICS_CONTOUR_H) == defined(HWY_TARGET_TOGGLE) // see scalar.h
#ifdef LIMNER_CORE_OPTICS_CONTOUR_H
#undef LIMNER_CORE_OPTICS_CONTOUR_H
#else
#define LIMNER_CORE_OPTICS_CONTOUR_H
#endif

#include "core/optics/scalar.h"
#include "core/optics/shading.h"

// Style contours (paper 000 section 4.2; spec style-transfer-functions.md 4; numerics.md 2a).
//
//   n        unit normal, v unit vector to the viewer, f = |n.v|
//   kappa    normal curvature along the view, 1/length
//   T        thickness of the pen, the same length
//   c        where contours end: a sample is on one where f <= c
//   r        distance from the middle of the lit sphere, |n_xy|; r' the same after the push to the rim

LIMNER_OPTICS_BEGIN

/// c = sqrt(t (2 - t)), t = T kappa clamped to [0, 1]: a feature thinner than the pen is all contour.
template <typename T>
T contourWidth(const T& thicknessTimesCurvature) {
    const T t = clampedToUnit(thicknessTimesCurvature);
    return sqrt(t * (T(2) - t));
}

/// r' = min(1, r / delta) with delta = f / c on a contour and 1 off it: the colour on a contour is the sphere's own rim
/// colour. Never divides by 0: r c / f is taken as r c >= f first.
template <typename T>
T contourPush(const T& radius, const T& facing, const T& width) {
    const T f = clampedToUnit(facing);
    const T r = clampedToUnit(radius);
    const auto on = f < width;
    const auto rim = r * width >= f;
    const T pushed = r * width / select(f > T(0), f, T(1));
    return select(on, select(rim, T(1), min(T(1), pushed)), r);
}

/// Ink of a contour that is drawn over a colour rather than taken from a sphere's rim: 1 on it, falling to 0 over the
/// last tenth of its width, so that its edge is not a staircase.
template <typename T>
T contourCoverage(const T& facing, const T& width) {
    const T inner = T(0.9) * width;
    return select(width > T(0), T(1) - smoothStep(inner, width, facing), T(0));
}

/// Angle between two vectors of any length (whose squares neither overflow nor vanish) over the distance between them;
/// 0 where one of them vanishes or the distance does. As atan2(|n0 x n1|, n0.n1): the arc cosine loses half its digits
/// near 1, |n0 - n1| takes a difference of lengths for an angle. The cross product is the shorter one's with n1 - n0,
/// which nearly equal vectors lose no digit of, and neither do very different ones.
template <typename T>
T curvatureOfNormals(const Vector3<T>& n0, const Vector3<T>& n1, const T& distance) {
    const auto second = dot(n1, n1) < dot(n0, n0);
    const Vector3<T> n = {select(second, n1.x, n0.x), select(second, n1.y, n0.y), select(second, n1.z, n0.z)};
    const Vector3<T> step = {n1.x - n0.x, n1.y - n0.y, n1.z - n0.z};
    const Vector3<T> cross = {n.y * step.z - n.z * step.y, n.z * step.x - n.x * step.z, n.x * step.y - n.y * step.x};
    const T angle = atan2(sqrt(dot(cross, cross)), dot(n0, n1));
    const auto apart = distance > T(0);
    return select(apart, angle / select(apart, distance, T(1)), T(0));
}

/// The second derivatives of a field.
template <typename T>
struct Hessian {
    T xx, yy, zz, xy, xz, yz;
};

template <typename T>
T quadraticForm(const Hessian<T>& h, const Vector3<T>& u) {
    return u.x * u.x * h.xx + u.y * u.y * h.yy + u.z * u.z * h.zz +
           T(2) * (u.x * u.y * h.xy + u.x * u.z * h.xz + u.y * u.z * h.yz);
}

/// |kappa| of the level surface along the view: |t' H t| / (|t|^2 |g|) with t = v - (n.v) n, the view's part in the
/// tangent plane. 0 where the gradient vanishes or the view is along the normal (there it never matters: f is 1).
template <typename T>
T curvatureAlongView(const T& secondDerivativeAlongTangent, const T& tangentSquared, const T& gradientMagnitude) {
    const T scale = tangentSquared * gradientMagnitude;
    const auto defined = scale > T(0);
    return select(defined, abs(secondDerivativeAlongTangent) / select(defined, scale, T(1)), T(0));
}

LIMNER_OPTICS_END

#endif
