#include "renderer/accuracy/analytic_scenes.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace limner::accuracy {

namespace {

/// Points of a curve that is linear between them: at this count the bend between two points is below 1e-9 of the
/// curve for every medium here (relative error (sigma d0 / n)^2 / 8).
constexpr int kCurvePoints = 4097;

glm::dvec3 grey(double value) { return glm::dvec3(value); }

TransferNode colourNode(double at, double value) { return {at, "", grey(value)}; }

Transfer& transferOf(Figure& figure) { return figure.layers.front().transfer; }

/// sigma = extinctionPerMm * value, for values in [0, 1].
std::vector<glm::dvec2> linearExtinction(double extinctionPerMm, double referenceMm) {
    std::vector<glm::dvec2> curve;
    for (int i = 0; i < kCurvePoints; ++i) {
        const double value = static_cast<double>(i) / (kCurvePoints - 1);
        curve.emplace_back(value, opacityOfMedium(extinctionPerMm * value, referenceMm));
    }
    return curve;
}

/// A field that rises from 0 to 1 over 1 mm along z, on 65 voxels; 3 x 3 columns, so that no ray meets a side.
constexpr int kRampVoxels = 65;
AnalyticScene rampScene(const std::string& name, const SampleLattice& lattice) {
    Grid grid;
    grid.dims = {3, 3, kRampVoxels};
    grid.spacingMm = {1, 1, 1.0 / (kRampVoxels - 1)};
    const auto volume = sampleField(grid, [](const glm::dvec3& mm) { return mm.z; });
    AnalyticScene scene{name, plainFigure(volume, viewAlongZ(grid.centreMm(), 1)), {}};
    scene.request.size = {1, 1};
    scene.request.lattice = lattice;
    scene.request.lattice->boxInset = 0.5;
    return scene;
}

} // namespace

double opacityOfMedium(double extinctionPerMm, double lengthMm) { return -std::expm1(-extinctionPerMm * lengthMm); }

std::shared_ptr<const Volume> sampleField(const Grid& grid, const FieldMm& field) {
    std::vector<double> values;
    values.reserve(grid.voxelCount());
    for (int z = 0; z < grid.dims.z; ++z) {
        for (int y = 0; y < grid.dims.y; ++y) {
            for (int x = 0; x < grid.dims.x; ++x) {
                values.push_back(field(grid.mmFromVoxel({x, y, z})));
            }
        }
    }
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    Volume::Contents contents;
    contents.grid = grid;
    contents.type = VoxelType::float32;
    contents.range = {*low, *high};
    contents.slope = *high > *low ? *high - *low : 1;
    contents.intercept = *low;
    std::vector<float> stored(values.size());
    std::transform(values.begin(), values.end(), stored.begin(),
                   [&](double v) { return static_cast<float>((v - contents.intercept) / contents.slope); });
    return std::make_shared<const Volume>(contents, std::as_bytes(std::span(stored)));
}

Grid centredGrid(int voxels, double spacingMm) {
    Grid grid;
    grid.dims = glm::ivec3(voxels);
    grid.spacingMm = glm::dvec3(spacingMm);
    grid.originMm = glm::dvec3(-spacingMm * (voxels - 1) / 2);
    return grid;
}

Camera viewAlongZ(const glm::dvec3& targetMm, double heightMm) {
    Camera camera;
    camera.targetMm = targetMm;
    camera.direction = {0, 0, 1};
    camera.up = {0, -1, 0};
    camera.heightMm = heightMm;
    return camera;
}

Figure plainFigure(std::shared_ptr<const Volume> volume, const Camera& camera) {
    Figure figure;
    figure.volume.emplace();
    figure.volume->data = std::move(volume);
    figure.camera = camera;
    figure.quality.earlyTermination = 0;
    Layer layer;
    layer.name = "matter";
    layer.shading = Shading::flat;
    figure.layers.push_back(layer);
    return figure;
}

glm::dvec2 pixelCentreMm(const AnalyticScene& scene, glm::ivec2 pixel) {
    const Camera& camera = scene.figure.camera;
    const double pixelMm = camera.heightMm / scene.request.size.y;
    const glm::dvec2 fromMiddle = glm::dvec2(pixel) + 0.5 - glm::dvec2(scene.request.size) / 2.0;
    return glm::dvec2(camera.targetMm) + fromMiddle * pixelMm;
}

AnalyticScene ConstantMedium::scene(double stepMm) const {
    Grid grid;
    grid.dims = {5, 5, 8};
    grid.spacingMm = glm::dvec3(lengthMm / grid.dims.z);
    constexpr double value = 40; // any
    AnalyticScene scene{"A1",
                        plainFigure(sampleField(grid, [](const glm::dvec3&) { return value; }),
                                    viewAlongZ(grid.centreMm(), lengthMm / 2)),
                        {}};
    scene.request.size = {2, 2};
    scene.request.lattice = SampleLattice{stepMm, 0.5, 0};
    Transfer& transfer = transferOf(scene.figure);
    transfer.nodes = {colourNode(value, colour)};
    transfer.opacity = {{value, opacityOfMedium(extinctionPerMm, grid.smallestSpacingMm())}};
    return scene;
}

double ConstantMedium::opacity() const { return opacityOfMedium(extinctionPerMm, lengthMm); }
double ConstantMedium::premultiplied() const { return colour * opacity(); }

AnalyticScene LinearRamp::scene(const SampleLattice& lattice) const {
    AnalyticScene scene = rampScene("A2", lattice);
    Transfer& transfer = transferOf(scene.figure);
    transfer.nodes = {colourNode(0, 0), colourNode(1, 1)};
    transfer.opacity = linearExtinction(extinctionPerMm, 1.0 / (kRampVoxels - 1));
    return scene;
}

double LinearRamp::opacity() const { return -std::expm1(-extinctionPerMm / 2); }

double LinearRamp::premultiplied() const {
    const double s = extinctionPerMm;
    return -std::exp(-s / 2) + std::sqrt(std::numbers::pi / (2 * s)) * std::erf(std::sqrt(s / 2));
}

AnalyticScene StepInterface::scene(const SampleLattice& lattice) const {
    AnalyticScene scene = rampScene("A3", lattice);
    const double reference = 1.0 / (kRampVoxels - 1);
    const double a1 = opacityOfMedium(extinctionPerMm.x, reference);
    const double a2 = opacityOfMedium(extinctionPerMm.y, reference);
    Transfer& transfer = transferOf(scene.figure);
    transfer.nodes = {colourNode(0, colour.x), colourNode(interfaceMm, colour.x), colourNode(interfaceMm, colour.y),
                      colourNode(1, colour.y)};
    transfer.opacity = {{0, a1}, {interfaceMm, a1}, {interfaceMm, a2}, {1, a2}};
    return scene;
}

double StepInterface::opacity() const {
    return -std::expm1(-extinctionPerMm.x * interfaceMm - extinctionPerMm.y * (1 - interfaceMm));
}

double StepInterface::premultiplied() const {
    const double front = opacityOfMedium(extinctionPerMm.x, interfaceMm);
    const double back = opacityOfMedium(extinctionPerMm.y, 1 - interfaceMm);
    return colour.x * front + colour.y * (1 - front) * back;
}

AnalyticScene Ball::scene(double stepMm, int pixels) const {
    const double halfMm = 1.25 * radiusMm; // a quarter more, so that the field is smooth on both sides of the surface
    const Grid grid = centredGrid(static_cast<int>(std::lround(2 * halfMm / spacingMm)) + 1, spacingMm);
    const auto volume = sampleField(grid, [this](const glm::dvec3& mm) { return radiusMm - glm::length(mm); });
    AnalyticScene scene{"A4", plainFigure(volume, viewAlongZ(glm::dvec3(0), 2 * radiusMm)), {}};
    scene.request.size = {pixels, pixels};
    scene.request.lattice = SampleLattice{stepMm, 0.5, 0};
    Transfer& transfer = transferOf(scene.figure);
    transfer.nodes = {colourNode(0, 1)};
    transfer.opacity = {{0, 0}, {0, opacityOfMedium(extinctionPerMm, grid.smallestSpacingMm())}};
    return scene;
}

double Ball::opacity(double impactMm) const {
    const double square = radiusMm * radiusMm - impactMm * impactMm;
    return opacityOfMedium(extinctionPerMm, 2 * std::sqrt(std::max(0.0, square)));
}

double Ball::meanOpacity() const {
    const double k = 2 * extinctionPerMm * radiusMm;
    return 1 - 2 * (1 - (1 + k) * std::exp(-k)) / (k * k);
}

std::shared_ptr<const Volume> MarschnerLobb::volume(int voxels) const {
    return sampleField(centredGrid(voxels, 2.0 / (voxels - 1)), [this](const glm::dvec3& mm) { return value(mm); });
}

double MarschnerLobb::value(const glm::dvec3& mm) const {
    using std::numbers::pi;
    const double r = std::hypot(mm.x, mm.y);
    const double ring = std::cos(2 * pi * frequency * std::cos(pi * r / 2));
    return (1 - std::sin(pi * mm.z / 2) + alpha * (1 + ring)) / (2 * (1 + alpha));
}

glm::dvec3 MarschnerLobb::gradient(const glm::dvec3& mm) const {
    using std::numbers::pi;
    const double r = std::hypot(mm.x, mm.y);
    const double radial = alpha * pi * pi * frequency * std::sin(pi * r / 2) *
                          std::sin(2 * pi * frequency * std::cos(pi * r / 2)) / (2 * (1 + alpha));
    const double overR = r > 0 ? radial / r : 0; // the radial slope vanishes on the axis
    return {overR * mm.x, overR * mm.y, -(pi / 2) * std::cos(pi * mm.z / 2) / (2 * (1 + alpha))};
}

AnalyticScene GaussianBlob::scene(double stepMm) const {
    const double reachMm = 6 * widthMm; // exp(-36): the tail cut off is below double precision
    const Grid grid = centredGrid(2 * static_cast<int>(std::ceil(reachMm / spacingMm)) + 1, spacingMm);
    const auto volume =
        sampleField(grid, [this](const glm::dvec3& mm) { return std::exp(-glm::dot(mm, mm) / (widthMm * widthMm)); });
    AnalyticScene scene{"A7", plainFigure(volume, viewAlongZ(glm::dvec3(0), grid.dims.y * spacingMm)), {}};
    scene.request.size = {grid.dims.x, grid.dims.y};
    scene.request.lattice = SampleLattice{stepMm, 0.5, 0};
    Transfer& transfer = transferOf(scene.figure);
    transfer.nodes = {colourNode(0, 1)};
    transfer.opacity = linearExtinction(extinctionPerMm, spacingMm);
    return scene;
}

double GaussianBlob::opacity(double impactMm) const {
    const double chord = widthMm * std::sqrt(std::numbers::pi) * std::exp(-impactMm * impactMm / (widthMm * widthMm));
    return opacityOfMedium(extinctionPerMm, chord);
}

AnalyticScene LitBall::scene(std::shared_ptr<const LitSphere> style, int pixels) const {
    const Grid grid = centredGrid(2 * static_cast<int>(radiusVoxels) + 9, 1); // four voxels of air around the ball
    const auto volume = sampleField(grid, [this](const glm::dvec3& mm) { return radiusVoxels - glm::length(mm); });
    AnalyticScene scene{"lit ball", plainFigure(volume, viewAlongZ(glm::dvec3(0), 2 * radiusVoxels)), {}};
    scene.request.size = {pixels, pixels};
    // A first hit lies up to a step below the surface, where the normal leans further out by step / radius; a
    // thousandth of the radius keeps that below half a texel of a 512-texel style.
    scene.request.lattice = SampleLattice{radiusVoxels / 1000, 0.5, 0};
    StyleEntry entry;
    entry.id = "style";
    entry.sphere = std::move(style);
    scene.figure.styles.push_back(entry);
    Layer& layer = scene.figure.layers.front();
    layer.shading = Shading::style;
    layer.transfer.nodes = {{0, "style", std::nullopt}};
    layer.transfer.opacity = {{0, 0}, {0, 1}};
    return scene;
}

AnalyticScene ContourBall::scene(double stepMm, double pixelMm) const {
    const Grid grid = centredGrid(2 * static_cast<int>(std::lround(radiusMm)) + 13, 1);
    const auto volume = sampleField(grid, [this](const glm::dvec3& mm) { return radiusMm - glm::length(mm); });
    constexpr int rows = 4;
    Camera camera = viewAlongZ(glm::dvec3(0), rows * pixelMm);
    camera.projection = projection;
    camera.fovDeg = glm::degrees(2 * std::atan(0.5 * camera.heightMm / eyeMm));
    AnalyticScene scene{"A4 contour", plainFigure(volume, camera), {}};
    scene.request.size = {2 * static_cast<int>(std::ceil(1.05 * rimMm() / pixelMm)), rows};
    scene.request.lattice = SampleLattice{stepMm, 0.5, 0};
    scene.figure.output.heightMm = camera.heightMm;
    Layer& layer = scene.figure.layers.front();
    layer.transfer.nodes = {colourNode(0, 1)};
    layer.transfer.opacity = {{-1, 0}, {1, 1}};
    layer.contours.emplace();
    layer.contours->thicknessMm = thicknessMm;
    layer.contours->curvature = curvature;
    return scene;
}

double ContourBall::rimMm() const {
    return projection == Projection::perspective ? eyeMm * std::tan(std::asin(radiusMm / eyeMm)) : radiusMm;
}

double ContourBall::paper(double pictureMm) const {
    double impact = pictureMm; // of the ray
    double depth = 1;          // of the ball's surface, over the middle's
    if (projection == Projection::perspective) {
        const double angle = std::atan(pictureMm / eyeMm);
        impact = eyeMm * std::sin(angle);
        const double toSurface =
            eyeMm * std::cos(angle) - std::sqrt(std::max(0.0, radiusMm * radiusMm - impact * impact));
        depth = toSurface * std::cos(angle) / eyeMm;
    }
    if (impact >= radiusMm) {
        return 0;
    }
    const double sine = impact / radiusMm;
    const double share = thicknessMm / radiusMm * depth * (curvature == CurvatureEstimator::normals ? sine : 1);
    const double width = std::sqrt(share * (2 - share));
    // Ink is whole up to nine tenths of the width and fades in a smooth step.
    const double t = std::clamp((std::sqrt(1 - sine * sine) / width - 0.9) / 0.1, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

double ContourBall::innerEndMm() const {
    double low = 0; // paper is 1 in the middle and falls once
    double high = rimMm();
    for (int halving = 0; halving < 60; ++halving) {
        const double middle = 0.5 * (low + high);
        (paper(middle) >= 1 ? low : high) = middle;
    }
    return low;
}

namespace {

/// Of the torus' own frame, whose z is the ring's axis.
glm::dvec3 ringFrame(const glm::dvec3& mm) {
    const double lean = glm::radians(50.0);
    return {mm.x, std::cos(lean) * mm.y + std::sin(lean) * mm.z, std::cos(lean) * mm.z - std::sin(lean) * mm.y};
}

} // namespace

double Torus::value(const glm::dvec3& mm) const {
    const glm::dvec3 p = ringFrame(mm);
    return minorMm - std::hypot(std::hypot(p.x, p.y) - majorMm, p.z);
}

glm::dvec3 Torus::normal(const glm::dvec3& mm) const {
    // Away from the nearest point of the circle, which is where the circle's frame says.
    const glm::dvec3 p = ringFrame(mm);
    const double toAxis = std::hypot(p.x, p.y);
    const double out = (toAxis - majorMm) / toAxis;
    const glm::dvec3 n = glm::normalize(glm::dvec3(out * p.x, out * p.y, p.z));
    const double lean = glm::radians(50.0);
    return {n.x, std::cos(lean) * n.y - std::sin(lean) * n.z, std::cos(lean) * n.z + std::sin(lean) * n.y};
}

double Torus::curvatureAlong(const glm::dvec3& mm, const glm::dvec3& view) const {
    const glm::dvec3 p = ringFrame(mm);
    const glm::dvec3 v = ringFrame(view);
    const glm::dvec3 n = ringFrame(normal(mm));
    const double toAxis = std::hypot(p.x, p.y);
    const double rho = std::hypot(toAxis - majorMm, p.z);
    const double along = (p.x * v.y - p.y * v.x) / toAxis; // the view's part in the ring's direction
    const glm::dvec3 tangent = v - glm::dot(n, v) * n;
    const double square = glm::dot(tangent, tangent);
    const double inRing = along * along / square;
    const double cosine = (toAxis - majorMm) / rho;
    return std::abs((1 - inRing) / rho + inRing * cosine / toAxis);
}

std::optional<double> Torus::frontMm(const glm::dvec2& mm) const {
    const double reach = majorMm + 2 * minorMm;
    double depth = -reach;
    for (int step = 0; step < 10000 && depth < reach; ++step) {
        const double toSurface = -value({mm, depth});
        if (toSurface < 1e-12) {
            return depth;
        }
        depth += toSurface; // a distance field: nothing is nearer
    }
    return std::nullopt;
}

AnalyticScene Torus::scene(int pixels) const {
    const double reach = majorMm + minorMm;
    const Grid grid = centredGrid(2 * static_cast<int>(std::ceil(reach)) + 9, 1);
    const auto volume = sampleField(grid, [this](const glm::dvec3& mm) { return value(mm); });
    AnalyticScene scene{"torus", plainFigure(volume, viewAlongZ(glm::dvec3(0), 2 * reach)), {}};
    scene.request.size = {pixels, pixels};
    scene.request.lattice = SampleLattice{0.1, 0.5, 0}; // the surface is found to a twentieth of a voxel
    Transfer& transfer = transferOf(scene.figure);
    transfer.kind = TransferKind::twoDimensional;
    transfer.axes = {"value", "curvature"};
    transfer.nodes.clear();
    transfer.grid = TransferGrid{{volume->range().low}, {0, 2 / minorMm}, {{"#000000"}, {"#ffffff"}}};
    transfer.opacity = {{0, 0}, {0, 1}};
    return scene;
}

} // namespace limner::accuracy
