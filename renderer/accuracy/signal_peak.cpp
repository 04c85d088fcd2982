#include "renderer/accuracy/signal_peak.h"

#include "core/optics/opacity.h"
#include "core/optics/shading.h"
#include "core/style/transfer_function.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace limner::accuracy {

namespace {

constexpr double kReach = 5;       ///< standard deviations of the peak that the curve holds
constexpr int kCurvePoints = 2001; ///< linear between them

std::vector<glm::dvec2> peakCurve(double peak, double width) {
    std::vector<glm::dvec2> curve;
    for (int i = 0; i < kCurvePoints; ++i) {
        const double s = kReach * (2.0 * i / (kCurvePoints - 1) - 1);
        const bool end = i == 0 || i == kCurvePoints - 1;
        curve.emplace_back(peak + s * width, end ? 0 : 0.3 * std::exp(-s * s / 2));
    }
    return curve;
}

} // namespace

AnalyticScene SignalPeak::scene(Interpolation interpolation, GradientEstimator gradient, double stepVoxels,
                                int pixels) const {
    AnalyticScene scene{"A6, a peak", plainFigure(signal.volume(voxels), viewAlongZ(glm::dvec3(0), 1.6)), {}};
    Layer& layer = scene.figure.layers.front();
    layer.shading = Shading::phong;
    layer.phong = PhongLight{};
    layer.specular = Specular{0, 1};
    layer.twoSided = true;
    layer.transfer.nodes = {{0, "", glm::dvec3(0.9)}};
    layer.transfer.opacity = peakCurve(peak, width);
    scene.figure.quality.interpolation = interpolation;
    scene.figure.quality.gradient = gradient;
    scene.request.size = glm::ivec2(pixels);
    const double spacing = scene.figure.volume->data->grid().smallestSpacingMm();
    scene.request.lattice = SampleLattice{stepVoxels * spacing, 0.5, 0.5};
    return scene;
}

Picture SignalPeak::truth(int pixels, int steps) const {
    const AnalyticScene like = scene(Interpolation::linear, GradientEstimator::central, 1, pixels);
    const Layer& layer = like.figure.layers.front();
    const double referenceMm = like.figure.volume->data->grid().smallestSpacingMm();
    const double stepMm = 2.0 / steps;
    const glm::dvec3 rgb = layer.transfer.nodes.front().rgb.value();
    const optics::PhongTerms<double> terms{layer.phong->ambient, layer.phong->diffuse, 0, 1};
    Picture picture(glm::ivec2{pixels, pixels});
    for (int y = 0; y < pixels; ++y) {
        for (int x = 0; x < pixels; ++x) {
            glm::dvec4 sum(0);
            for (int k = 0; k < steps; ++k) {
                const glm::dvec3 mm(pixelCentreMm(like, {x, y}), (k + 0.5) * stepMm - 1);
                const double unit = opacityAt(layer.transfer.opacity, signal.value(mm));
                if (unit <= 0) {
                    continue;
                }
                const double opacity = optics::opacityOfLength(unit, stepMm / referenceMm);
                const glm::dvec3 g = signal.gradient(mm);
                const double facing = optics::facing(g.z / glm::length(g), true); // seen along z
                const auto lit = optics::phong<double>({rgb.r, rgb.g, rgb.b}, facing, terms);
                sum += (1 - sum.a) * opacity * glm::dvec4(lit.r, lit.g, lit.b, 1);
            }
            for (int c = 0; c < 4; ++c) {
                picture.pixel(x, y)[c] = static_cast<float>(sum[c]);
            }
        }
    }
    return picture;
}

} // namespace limner::accuracy
