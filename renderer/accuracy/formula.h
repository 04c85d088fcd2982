#pragma once

#include <array>
#include <cstddef>

namespace limner {

/// The papers' formulas (core/optics) that can be evaluated by name. Names, arguments and results are those of the test
/// vectors (spec vectors/README.md).
enum class Formula {
    opacityPerLength,
    contourWidth,
    curvature,
    contourPush,
    transparency,
    silhouetteness,
    lightingImportance,
    extinctionImportance,
    gaussianLens,
    stippleBoundary,
    stippleSilhouette,
    stippleResolution,
    stippleDistance,
    stippleInterior,
    stippleLighting,
    importanceRay,
};

struct FormulaKind {
    Formula formula;
    const char* name;
    std::size_t arguments; ///< of importanceRay: of every sample
    std::size_t results;
};

/// In the order of the enumeration.
inline constexpr std::array<FormulaKind, 16> kFormulas = {{
    {Formula::opacityPerLength, "opacity_per_length", 2, 1},
    {Formula::contourWidth, "contour_width", 1, 1},
    {Formula::curvature, "curvature", 7, 1},
    {Formula::contourPush, "contour_push", 3, 1},
    {Formula::transparency, "transparency", 5, 1},
    {Formula::silhouetteness, "silhouetteness", 5, 1},
    {Formula::lightingImportance, "lighting_importance", 3, 1},
    {Formula::extinctionImportance, "extinction_importance", 1, 1},
    {Formula::gaussianLens, "lens_gaussian", 3, 1},
    {Formula::stippleBoundary, "stipple_boundary", 5, 1},
    {Formula::stippleSilhouette, "stipple_silhouette", 5, 1},
    {Formula::stippleResolution, "stipple_resolution", 4, 1},
    {Formula::stippleDistance, "stipple_distance", 3, 1},
    {Formula::stippleInterior, "stipple_interior", 2, 1},
    {Formula::stippleLighting, "stipple_lighting", 2, 1},
    {Formula::importanceRay, "importance_ray", 3, 3},
}};

constexpr const FormulaKind& kindOf(Formula formula) { return kFormulas[static_cast<std::size_t>(formula)]; }

} // namespace limner
