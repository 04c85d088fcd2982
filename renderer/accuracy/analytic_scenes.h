#pragma once

#include "core/figure/figure.h"
#include "renderer/plan/planner.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace limner::accuracy {

/// Scenes whose picture is known in closed form (spec accuracy.md 1.5). All are seen along +z with the picture's right
/// along +x and down along +y, orthographically, without early termination.

/// A figure and how to sample it. Callers may change the lattice and the size.
struct AnalyticScene {
    std::string name;
    Figure figure;
    PlanRequest request;
};

/// The field at every voxel centre, mm, kept as float32.
using FieldMm = std::function<double(const glm::dvec3&)>;
std::shared_ptr<const Volume> sampleField(const Grid& grid, const FieldMm& field);

/// A cube of voxels around the origin: `voxels` per axis.
Grid centredGrid(int voxels, double spacingMm);

/// Straight view along +z that shows `heightMm` around a point.
Camera viewAlongZ(const glm::dvec3& targetMm, double heightMm);

/// A figure of one layer without shading and without any style.
Figure plainFigure(std::shared_ptr<const Volume> volume, const Camera& camera);

/// Middle of a pixel in such a view: x and y in mm.
glm::dvec2 pixelCentreMm(const AnalyticScene& scene, glm::ivec2 pixel);

/// Opacity of `lengthMm` of a medium.
double opacityOfMedium(double extinctionPerMm, double lengthMm);

/// A1: a slab of one medium. a = 1 - exp(-sigma L), C = c a, at any step.
struct ConstantMedium {
    double extinctionPerMm = 2;
    double lengthMm = 1;
    double colour = 0.5;
    [[nodiscard]] AnalyticScene scene(double stepMm) const;
    [[nodiscard]] double opacity() const;
    [[nodiscard]] double premultiplied() const;
};

/// A2: sigma = s0 x and colour x on [0, 1] mm; boxInset starts rays at the outermost centres.
struct LinearRamp {
    double extinctionPerMm = 4;
    [[nodiscard]] AnalyticScene scene(const SampleLattice& lattice) const;
    [[nodiscard]] double opacity() const;
    [[nodiscard]] double premultiplied() const;
};

/// A3: two media with an interface at x = 1/3 of [0, 1] mm.
struct StepInterface {
    double interfaceMm = 1.0 / 3;
    glm::dvec2 extinctionPerMm{1, 20};
    glm::dvec2 colour{0.2, 0.9};
    [[nodiscard]] AnalyticScene scene(const SampleLattice& lattice) const;
    [[nodiscard]] double opacity() const;
    [[nodiscard]] double premultiplied() const;
};

/// A4: a ball of one medium. The value at distance r is radiusMm - r, so matter is where the value is not negative.
struct Ball {
    double radiusMm = 1;
    double extinctionPerMm = 1.5;
    double spacingMm = 0.05;
    [[nodiscard]] AnalyticScene scene(double stepMm, int pixels) const;
    [[nodiscard]] double opacity(double impactMm) const;
    [[nodiscard]] double meanOpacity() const;
};

/// A6: the signal of Marschner and Lobb (1994), n^3 samples on [-1, 1]^3 mm.
struct MarschnerLobb {
    double alpha = 0.25;
    double frequency = 6;
    [[nodiscard]] std::shared_ptr<const Volume> volume(int voxels) const;
    [[nodiscard]] double value(const glm::dvec3& mm) const;
    [[nodiscard]] glm::dvec3 gradient(const glm::dvec3& mm) const;
};

/// A7: sigma = s0 exp(-r^2 / w^2). One pixel per voxel, its middle on the voxel centre.
struct GaussianBlob {
    double extinctionPerMm = 6;
    double widthMm = 0.25;
    double spacingMm = 0.1;
    [[nodiscard]] AnalyticScene scene(double stepMm) const;
    [[nodiscard]] double opacity(double impactMm) const;
};

/// A ball that is opaque from its surface inwards, drawn with a lit sphere: its picture is the lit sphere's.
struct LitBall {
    double radiusVoxels = 45;
    [[nodiscard]] AnalyticScene scene(std::shared_ptr<const LitSphere> style, int pixels) const;
};

/// A4's contour: a ball in a field of its distance, drawn white with black contours. Its surface is a ramp of opacity
/// two voxels wide, as in scans; one voxel is 1 mm, and so is one mm on paper. The picture is a strip along x through
/// the middle, four pixels high.
struct ContourBall {
    double radiusMm = 50;
    double thicknessMm = 5;
    CurvatureEstimator curvature = CurvatureEstimator::hessian;
    Projection projection = Projection::orthographic;
    double eyeMm = 224; ///< perspective: distance of the eye from the middle
    [[nodiscard]] AnalyticScene scene(double stepMm, double pixelMm) const;
    /// Distance of the contour's inner end from the middle of the picture. Orthographic: R - T by the true curvature,
    /// R^2 / (R + T) by two normals, whose angle is sin(phi) of the curvature's, phi the view's to the normal.
    [[nodiscard]] double innerEndMm() const;
    /// Distance of the ball's rim from the middle of the picture.
    [[nodiscard]] double rimMm() const;
    /// White share of the ball at a distance from the middle: 0 on the contour, 1 inside it; 0 outside the ball.
    [[nodiscard]] double paper(double pictureMm) const;
};

/// A ring in a field of its distance, radiusMm - (distance to the circle of majorMm around the origin); 1 mm voxels.
/// The ring's axis leans by 50 degrees from the view, so that inner and outer sides show.
struct Torus {
    double minorMm = 8;
    double majorMm = 20;
    /// White where the curvature along the view is 2 / minorMm, black where it is 0; opaque from the surface inwards.
    [[nodiscard]] AnalyticScene scene(int pixels) const;
    [[nodiscard]] double value(const glm::dvec3& mm) const;
    [[nodiscard]] glm::dvec3 normal(const glm::dvec3& mm) const;
    /// |kappa| of the level surface along the view: 1 / rho across the ring, cos(phi) / (distance to the axis) along
    /// it, between them by Euler's formula; rho: distance to the circle, phi: from the ring's plane.
    [[nodiscard]] double curvatureAlong(const glm::dvec3& mm, const glm::dvec3& view) const;
    /// Depth along +z of the first point on the surface at (x, y).
    [[nodiscard]] std::optional<double> frontMm(const glm::dvec2& mm) const;
};

} // namespace limner::accuracy
