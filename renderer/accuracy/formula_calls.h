#if defined(LIMNER_FORMULA_CALLS_H) == defined(HWY_TARGET_TOGGLE) // see core/optics/scalar.h
#ifdef LIMNER_FORMULA_CALLS_H
#undef LIMNER_FORMULA_CALLS_H
#else
#define LIMNER_FORMULA_CALLS_H
#endif

#include "core/optics/contour.h"
#include "core/optics/importance.h"
#include "core/optics/measures.h"
#include "core/optics/opacity.h"
#include "core/optics/stipple.h"
#include "core/optics/transparency.h"
#include "renderer/accuracy/formula.h"

LIMNER_OPTICS_BEGIN

/// C of one channel, A and I of a ray; `in(3 k)`, `in(3 k + 1)`, `in(3 k + 2)`: colour, opacity and importance of
/// sample k, front to back.
template <typename T, typename Arguments>
void evaluateRay(const Arguments& in, std::size_t arguments, T* out) {
    ImportanceState<T> ray = startOfRay<T>();
    for (std::size_t k = 0; k + 2 < arguments; k += 3) {
        const T c = in(k);
        ray = withSample(ray, {c, c, c}, in(k + 1), in(k + 2));
    }
    out[0] = composed(ray).r;
    out[1] = ray.opacity;
    out[2] = importanceSoFar(ray);
}

/// A formula by name; `in(k)` is its argument k, `out` takes the results.
template <typename T, typename Arguments>
void evaluateFormula(Formula formula, const Arguments& in, std::size_t arguments, T* out) {
    switch (formula) {
    case Formula::opacityPerLength: *out = opacityOfLength<T>(in(0), in(1)); break;
    case Formula::contourWidth: *out = contourWidth<T>(in(0)); break;
    case Formula::curvature: *out = curvatureOfNormals<T>({in(0), in(1), in(2)}, {in(3), in(4), in(5)}, in(6)); break;
    case Formula::contourPush: *out = contourPush<T>(in(0), in(1), in(2)); break;
    case Formula::transparency: *out = illustrativeOpacity<T>(in(0), in(1), in(2), in(3), in(4)); break;
    case Formula::silhouetteness: *out = silhouetteness<T>(in(0), in(1), {in(2), in(3), in(4)}); break;
    case Formula::lightingImportance: *out = lightingImportance<T>(in(0), in(1), in(2)); break;
    case Formula::extinctionImportance: *out = extinctionImportance<T>(in(0)); break;
    case Formula::gaussianLens: *out = gaussianLens<T>(in(0), in(1), in(2)); break;
    case Formula::stippleBoundary: *out = boundaryFactor<T>(in(0), in(1), {in(2), in(3), in(4)}); break;
    case Formula::stippleSilhouette: *out = silhouetteFactor<T>(in(0), in(1), {in(2), in(3), in(4)}); break;
    case Formula::stippleResolution: *out = resolutionFactor<T>(in(0), in(1), in(2), in(3)); break;
    case Formula::stippleDistance: *out = distanceFactor<T>(in(0), in(1), in(2)); break;
    case Formula::stippleInterior: *out = interiorFactor<T>(in(0), in(1)); break;
    case Formula::stippleLighting: *out = lightingFactor<T>(in(0), in(1)); break;
    case Formula::importanceRay: evaluateRay(in, arguments, out); break;
    }
}

LIMNER_OPTICS_END

#endif
