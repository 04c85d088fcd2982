#if defined(LIMNER_CORE_OPTICS_SHADING_H) == defined(HWY_TARGET_TOGGLE) // see scalar.h
#ifdef LIMNER_CORE_OPTICS_SHADING_H
#undef LIMNER_CORE_OPTICS_SHADING_H
#else
#define LIMNER_CORE_OPTICS_SHADING_H
#endif

#include "core/optics/opacity.h"
#include "core/optics/scalar.h"

// Lit spheres and the Phong head light (paper 000 section 4; spec style-transfer-functions.md 1; numerics.md 2a).
//
//   g        gradient in eye space (x right, y up, z towards the viewer)
//   n        unit normal, -g/|g|: out of dense matter
//   r        unit direction of the ray, eye space; (0, 0, -1) in orthographic views
//   g0       gradient floor: below it a normal means nothing
//   k_a, k_d, k_s, e   ambient, diffuse, specular strength and specular exponent

LIMNER_OPTICS_BEGIN

/// How far a gradient is worth a normal: 0 below g0, 1 above 2 g0. With g0 = 0: 1 wherever |g| > 0.
template <typename T>
T normalDefinedness(const T& gradientMagnitude, const T& floor) {
    return select(gradientMagnitude > T(0), smoothStep(floor, T(2) * floor, gradientMagnitude), T(0));
}

/// -g/|g|, and zero for a zero gradient. Scaled by its largest component first: |g|^2 must not overflow or vanish.
template <typename T>
Vector3<T> normalFromGradient(const Vector3<T>& gradientEye) {
    const T largest = max(abs(gradientEye.x), max(abs(gradientEye.y), abs(gradientEye.z)));
    const auto usable = largest > T(0);
    const Vector3<T> g = scaled(gradientEye, T(1) / select(usable, largest, T(1)));
    const T squared = dot(g, g); // in [1, 3] where usable
    const T inverse = T(1) / sqrt(select(usable, squared, T(1)));
    return scaled(g, select(usable, -inverse, T(0)));
}

/// The normal in the frame of the ray: turned by the shortest rotation that takes the ray r to (0, 0, -1). Only then do
/// silhouettes at the border of a perspective picture reach the rim of the sphere. r_z < 1. With t = (0, 0, -1):
/// n' = n - ((r + t).n) / (1 + r.t) (r + t) + 2 (r.n) t
template <typename T>
Vector3<T> normalInRayFrame(const Vector3<T>& normalEye, const Vector3<T>& rayEye) {
    const T along = dot(rayEye, normalEye);
    const T bend = (along - normalEye.z) / (T(1) - rayEye.z);
    return {normalEye.x - bend * rayEye.x, normalEye.y - bend * rayEye.y, -along};
}

/// Two-sided lighting: the normal (in the frame of the ray) turned to face the viewer.
template <typename T>
Vector3<T> facingViewer(const Vector3<T>& normalRay) {
    const T sign = select(normalRay.z < T(0), T(-1), T(1));
    return scaled(normalRay, sign);
}

/// A point of the disk that a lit sphere's picture covers, centre (0, 0), radius 1, y up.
template <typename T>
struct DiskPoint {
    T x;
    T y;
};

/// Where a lit sphere is read: (n_x, n_y), moved onto the rim where rounding has left the disk.
template <typename T>
DiskPoint<T> litSpherePoint(const Vector3<T>& normalRay) {
    const T squared = normalRay.x * normalRay.x + normalRay.y * normalRay.y;
    const T shrink = T(1) / sqrt(max(T(1), squared));
    return {normalRay.x * shrink, normalRay.y * shrink};
}

template <typename T>
struct PhongTerms {
    T ambient;  ///< k_a
    T diffuse;  ///< k_d
    T strength; ///< k_s
    T exponent; ///< e
};

/// How squarely a surface faces the viewer, from n_z in the frame of the ray: |n_z| where both sides are lit alike,
/// else 0 on back faces.
template <typename T>
T facing(const T& normalZ, bool twoSided) {
    return min(T(1), twoSided ? abs(normalZ) : max(T(0), normalZ));
}

/// Light at the eye: c (k_a + k_d f) + k_s f^e, at most 1, with f = facing(). Where there is no normal f is 0: the
/// ambient part alone.
template <typename T>
Colour<T> phong(const Colour<T>& colour, const T& facingViewer, const PhongTerms<T>& terms) {
    const T matte = terms.ambient + terms.diffuse * facingViewer;
    const T gloss = terms.strength * pow(facingViewer, terms.exponent);
    return {min(T(1), colour.r * matte + gloss), min(T(1), colour.g * matte + gloss),
            min(T(1), colour.b * matte + gloss)};
}

LIMNER_OPTICS_END

#endif
