#if defined(LIMNER_CORE_OPTICS_TEXTURE_H) == defined(HWY_TARGET_TOGGLE) // see scalar.h
#ifdef LIMNER_CORE_OPTICS_TEXTURE_H
#undef LIMNER_CORE_OPTICS_TEXTURE_H
#else
#define LIMNER_CORE_OPTICS_TEXTURE_H
#endif

#include "core/optics/scalar.h"

// A texture laid on the object apart from its lighting (paper 000 section 6 leaves it open): three projections along
// the patient's axes, mixed by how squarely the surface faces each.
//
//   n    normal in patient coordinates, of any length; zero: no texture

LIMNER_OPTICS_BEGIN

/// Weights of the projections along x, y and z: n^4 over their sum, so that a face across an axis has one projection
/// only. All 0 for a zero normal.
template <typename T>
Vector3<T> projectionWeights(const Vector3<T>& normal) {
    const Vector3<T> square = {normal.x * normal.x, normal.y * normal.y, normal.z * normal.z};
    const Vector3<T> fourth = {square.x * square.x, square.y * square.y, square.z * square.z};
    const T sum = fourth.x + fourth.y + fourth.z;
    const auto defined = sum > T(0);
    return scaled(fourth, select(defined, T(1) / select(defined, sum, T(1)), T(0)));
}

LIMNER_OPTICS_END

#endif
