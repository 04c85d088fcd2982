#include "renderer/accuracy/analytic_scenes.h"
#include "renderer/reference/exact_ray.h"
#include "renderer/reference/field.h"
#include "support/rendering.h"

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

// The analytic scenes A1-A4, A6 and A7 of accuracy.md 1.5 with the orders of 1.6, on every backend.

namespace limner::accuracy {
namespace {

using testing::BackendTest;
using testing::observedOrder;
using testing::planOf;
using testing::renderWhole;

/// Single precision along a ray of a hundred samples: some 50 ulp of a pixel near 1.
constexpr double kSingle = 6e-6;
constexpr double kPixelUlp = 1.2e-7; // pictures are float32, whatever the backend computes in

class Analytic : public BackendTest {};
LIMNER_ON_EVERY_BACKEND(Analytic);

TEST(ClosedForms, AreTheTabulatedNumbers) {
    EXPECT_NEAR(ConstantMedium().opacity(), 0.864664716763, 1e-12);
    EXPECT_NEAR(ConstantMedium().premultiplied(), 0.432332358382, 1e-12);
    EXPECT_NEAR(LinearRamp().opacity(), 0.864664716763, 1e-12);
    EXPECT_NEAR(LinearRamp().premultiplied(), 0.462808723425, 1e-12);
    EXPECT_NEAR(StepInterface().premultiplied(), 0.701570872959, 1e-12);
    EXPECT_NEAR(StepInterface().opacity(), 0.999998839508, 1e-12);
    EXPECT_NEAR(Ball().opacity(0), 0.9502129316, 1e-10);
    EXPECT_NEAR(Ball().opacity(0.6), 0.9092820467, 1e-10);
    EXPECT_NEAR(Ball().opacity(0.8), 0.8347011118, 1e-10);
    EXPECT_NEAR(Ball().opacity(0.99), 0.3450537314, 1e-10);
    EXPECT_NEAR(Ball().meanOpacity(), 0.822032949660, 1e-12);
    EXPECT_NEAR(MarschnerLobb().value({0, 0, 0}), 0.6, 1e-15);
    EXPECT_NEAR(MarschnerLobb().value({0.3, 0.4, 0.1}), 0.4420485590, 1e-10);
    const glm::dvec3 gradient = MarschnerLobb().gradient({0.3, 0.4, 0.1});
    EXPECT_NEAR(gradient.x, 2.5097056800, 1e-8);
    EXPECT_NEAR(gradient.y, 3.3462742400, 1e-8);
    EXPECT_NEAR(gradient.z, -0.6205828870, 1e-10);
    // 1e-8: the table's own numbers are off by up to 5e-9 (1 - exp(-1.5 sqrt(pi)) is 0.92995944001).
    EXPECT_NEAR(GaussianBlob().opacity(0), 0.9299594371, 1e-8);
    EXPECT_NEAR(GaussianBlob().opacity(0.2), 0.7538716693, 1e-8);
    EXPECT_NEAR(GaussianBlob().opacity(0.4), 0.1857832120, 1e-8);
}

TEST_P(Analytic, A1ConstantMediumIsExactAtAnyStep) {
    const ConstantMedium medium;
    for (const double step : {0.003, 0.0625, 0.1, 0.3, 0.7, 1.0, 5.0}) {
        const Picture picture = renderWhole(backend(), medium.scene(step));
        for (const glm::ivec2 at : {glm::ivec2(0, 0), glm::ivec2(1, 0), glm::ivec2(0, 1), glm::ivec2(1, 1)}) {
            const float* pixel = picture.pixel(at.x, at.y);
            EXPECT_NEAR(pixel[3], medium.opacity(), rounding(kPixelUlp, kSingle)) << step;
            EXPECT_NEAR(pixel[0], medium.premultiplied(), rounding(kPixelUlp, kSingle)) << step;
            EXPECT_EQ(pixel[0], pixel[2]);
        }
    }
}

double rampError(const Backend& backend, const LinearRamp& ramp, const SampleLattice& lattice) {
    return std::abs(renderWhole(backend, ramp.scene(lattice)).pixel(0, 0)[0] - ramp.premultiplied());
}

TEST_P(Analytic, A2RampHasOrderTwoByMidpointsAndOneByLeftEnds) {
    const LinearRamp ramp;
    const double noise = rounding(kPixelUlp, 50 * kPixelUlp); // orders are read above this only
    int halvings = 0;
    for (double step = 0.5; step > 0.5 / 16; step /= 2) {
        const double fine = rampError(backend(), ramp, {step / 2, 0.5, 0.5});
        ASSERT_GT(fine, noise);
        EXPECT_NEAR(observedOrder(rampError(backend(), ramp, {step, 0.5, 0.5}), fine), 2, 0.15) << step;
        ++halvings;
    }
    EXPECT_EQ(halvings, 4);
    for (double step = 1.0 / 16; step > 1.0 / 256; step /= 2) {
        const double coarse = rampError(backend(), ramp, {step, 0, 0.5});
        EXPECT_NEAR(observedOrder(coarse, rampError(backend(), ramp, {step / 2, 0, 0.5})), 1, 0.1) << step;
    }
}

TEST_P(Analytic, A2OpacityIsExactByMidpoints) {
    const LinearRamp ramp; // the depth of a linear extinction is its middle's times the length
    for (const double step : {0.5, 0.13, 0.05, 0.01}) {
        const Picture picture = renderWhole(backend(), ramp.scene({step, 0.5, 0.5}));
        EXPECT_NEAR(picture.pixel(0, 0)[3], ramp.opacity(), rounding(kPixelUlp, kSingle)) << step;
    }
}

TEST_P(Analytic, A3StepInterfaceHasAnEnvelopeOfOrderOne) {
    const StepInterface interface;
    std::vector<double> envelope;
    std::vector<double> steps;
    for (double step = 1.0 / 8; step >= 1.0 / 128; step /= 2) {
        double worst = 0;
        for (int phase = 0; phase < 8; ++phase) {
            const SampleLattice lattice{step, (phase + 0.5) / 8, 0.5};
            const Picture picture = renderWhole(backend(), interface.scene(lattice));
            worst = std::max(worst, std::abs(picture.pixel(0, 0)[0] - interface.premultiplied()));
        }
        EXPECT_LE(worst, 6.38 * step) << step; // the bound of accuracy.md 1.5
        envelope.push_back(worst);
        steps.push_back(step);
    }
    // Least squares through the logarithms.
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    const auto n = static_cast<double>(steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const double x = std::log2(steps[i]);
        const double y = std::log2(envelope[i]);
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    EXPECT_GE((n * sxy - sx * sy) / (n * sxx - sx * sx), 0.9);
}

TEST_P(Analytic, A4BallShowsItsChords) {
    const Ball ball;
    constexpr int pixels = 40;
    const double step = ball.spacingMm / 20;
    const AnalyticScene scene = ball.scene(step, pixels);
    const Picture picture = renderWhole(backend(), scene);
    double mean = 0;
    int inside = 0;
    for (int y = 0; y < pixels; ++y) {
        for (int x = 0; x < pixels; ++x) {
            const double impact = glm::length(pixelCentreMm(scene, {x, y}));
            const double alpha = picture.pixel(x, y)[3];
            mean += alpha / (pixels * pixels);
            // Each end of the chord is found to within a step; the trilinear distance field is short by at most
            // spacing^2 / (4 r), which moves the surface along the ray by that over the cosine of incidence.
            const double cosine = std::sqrt(std::max(0.0, 1 - impact * impact));
            if (cosine > 0.2) {
                const double shift = ball.spacingMm * ball.spacingMm / (4 * cosine);
                const double slope = ball.extinctionPerMm * (1 - ball.opacity(impact));
                // 1/4096 of the value range: the width that tables may smear the step over.
                const double table = isReference() ? 0 : 3.0 / 4096 / cosine;
                EXPECT_NEAR(alpha, ball.opacity(impact), 2 * slope * (step + shift + table) + kSingle) << impact;
                ++inside;
            } else if (impact > ball.radiusMm) {
                EXPECT_EQ(alpha, 0) << impact;
            }
        }
    }
    EXPECT_GT(inside, 1000);
    // Mean over the disc; 0.005: the pixels' staircase along the rim (40 pixels across).
    EXPECT_NEAR(mean * 4 / std::numbers::pi, ball.meanOpacity(), 0.005);
}

TEST_P(Analytic, A4TighterSpacingConverges) {
    // Error over the inner disc falls as the field and the step get finer.
    const auto error = [&](double spacing) {
        Ball ball;
        ball.spacingMm = spacing;
        const AnalyticScene scene = ball.scene(spacing / 20, 8);
        const Picture picture = renderWhole(backend(), scene);
        double sum = 0;
        for (int i = 0; i < 64; ++i) {
            const double impact = glm::length(pixelCentreMm(scene, {i % 8, i / 8}));
            if (impact < 0.9) {
                sum += std::abs(picture.pixel(i % 8, i / 8)[3] - ball.opacity(impact));
            }
        }
        return sum;
    };
    EXPECT_LT(error(0.05), error(0.2) / 2);
}

TEST_P(Analytic, A7GaussianIsSpectrallyExactOnItsGrid) {
    const GaussianBlob blob;
    const AnalyticScene scene = blob.scene(blob.spacingMm); // samples fall on the voxel centres
    const Picture picture = renderWhole(backend(), scene);
    const int middle = scene.request.size.x / 2;
    for (const int offset : {0, 1, 2, 3, 4, 6}) {
        const double alpha = picture.pixel(middle + offset, middle)[3];
        // 1e-6: voxels are float32 (6e-8 each), tables single precision on the SIMD side
        EXPECT_NEAR(alpha, blob.opacity(offset * blob.spacingMm), rounding(3e-7, kSingle)) << offset;
        EXPECT_NEAR(picture.pixel(middle, middle - offset)[3], alpha, rounding(kPixelUlp, kSingle));
    }
}

TEST_P(Analytic, EarlyTerminationCostsAtMostItsThreshold) {
    LinearRamp ramp{30}; // dense enough that every threshold ends the ray
    AnalyticScene scene = ramp.scene({1.0 / 200, 0.5, 0.5});
    const Picture full = renderWhole(backend(), scene);
    for (const double epsilon : {1e-4, 1e-3, 1e-2, 5e-2}) {
        scene.figure.quality.earlyTermination = epsilon;
        const Picture cut = renderWhole(backend(), scene);
        const double error = testing::largestDifference(full, cut);
        EXPECT_LE(error, epsilon + kPixelUlp);
        EXPECT_GT(error, epsilon / 100) << "the ray never ended early";
    }
}

// ---- A6: interpolation and gradient -------------------------------------------------------------------------------

/// Errors of the field at the middle of random cells, where the interpolant is worst (the table of accuracy.md reads
/// there).
struct FieldErrors {
    double value = 0;    ///< RMS
    double gradient = 0; ///< RMS of the vector difference; cells at the border left out
    double angleDeg = 0; ///< mean, likewise
};

/// `slices`: of the cube's middle along z; all for the table's numbers, few where only the order is wanted.
FieldErrors marschnerLobbErrors(int voxels, int slices) {
    const MarschnerLobb signal;
    Grid grid = centredGrid(voxels, 2.0 / (voxels - 1));
    grid.dims.z = slices;
    grid.originMm.z = -grid.spacingMm.z * (slices - 1) / 2;
    const auto volume = sampleField(grid, [&](const glm::dvec3& mm) { return signal.value(mm); });
    RenderPlan plan; // trilinear, central
    plan.volume = plan.field = plan.gradientField = volume;
    FieldErrors errors;
    std::mt19937 random(6);
    const auto cell = [&](int count) { return std::uniform_int_distribution<int>(0, count - 2)(random); };
    constexpr int count = 20000;
    int inner = 0;
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 voxel = glm::dvec3(cell(voxels), cell(voxels), cell(slices)) + glm::dvec3(0.5);
        const glm::dvec3 mm = grid.mmFromVoxel(voxel);
        const double value = reference::valueAt(plan, voxel);
        errors.value += std::pow(value - signal.value(mm), 2) / count;
        if (glm::any(glm::lessThan(voxel, glm::dvec3(1))) ||
            glm::any(glm::greaterThan(voxel, glm::dvec3(grid.dims - 2)))) {
            continue;
        }
        ++inner;
        const glm::dvec3 g = reference::indexGradient(plan, voxel) * volume->contents().slope / grid.spacingMm;
        const glm::dvec3 expected = signal.gradient(mm);
        errors.gradient += glm::dot(g - expected, g - expected);
        const double angle = std::atan2(glm::length(glm::cross(g, expected)), glm::dot(g, expected));
        errors.angleDeg += angle * 180 / std::numbers::pi;
    }
    return {std::sqrt(errors.value), std::sqrt(errors.gradient / inner), errors.angleDeg / inner};
}

TEST(MarschnerLobbField, HasTheTabulatedErrors) {
    // 3 %: the table is over all cells, this over 20,000 random ones
    EXPECT_NEAR(marschnerLobbErrors(41, 41).value, 0.0483, 0.03 * 0.0483);
    EXPECT_NEAR(marschnerLobbErrors(81, 81).value, 0.0146, 0.03 * 0.0146);
    EXPECT_NEAR(marschnerLobbErrors(161, 161).value, 0.00383, 0.03 * 0.00383);
}

TEST(MarschnerLobbField, ValueAndCentralDifferencesHaveOrderTwo) {
    const FieldErrors coarse = marschnerLobbErrors(161, 8);
    const FieldErrors fine = marschnerLobbErrors(321, 8);
    EXPECT_NEAR(observedOrder(coarse.value, fine.value), 2, 0.2);
    EXPECT_NEAR(observedOrder(coarse.gradient, fine.gradient), 2, 0.2);
    EXPECT_LT(fine.angleDeg, coarse.angleDeg / 3);
}

/// Reads a backend's own interpolant: a slab of two planes around a depth leaves one sample a ray, which is opaque and
/// coloured by its value.
AnalyticScene valueProbe(const MarschnerLobb& signal, int voxels, double depthMm, int pixels) {
    const auto volume = signal.volume(voxels);
    AnalyticScene scene{"A6", plainFigure(volume, viewAlongZ(glm::dvec3(0), 1.2)), {}};
    scene.request.size = {pixels, pixels};
    scene.request.lattice = SampleLattice{10, 0.5, 0}; // longer than the box: the whole slab is one sample
    scene.figure.clip.planes = {{{0, 0, 1}, depthMm + 1e-3}, {{0, 0, -1}, -(depthMm - 1e-3)}};
    Transfer& transfer = scene.figure.layers.front().transfer;
    const ValueRange range = volume->range();
    transfer.nodes = {{range.low, "", glm::dvec3(0)}, {range.high, "", glm::dvec3(1)}};
    transfer.opacity = {{range.low, 1}};
    return scene;
}

TEST_P(Analytic, A6InterpolantConvergesWithOrderTwo) {
    const MarschnerLobb signal;
    constexpr int pixels = 64;
    constexpr double depth = 0.0371; // between slices on every grid
    const auto error = [&](int voxels) {
        const AnalyticScene scene = valueProbe(signal, voxels, depth, pixels);
        const Picture picture = renderWhole(backend(), scene);
        const ValueRange range = scene.figure.volume->data->range();
        double sum = 0;
        for (int y = 0; y < pixels; ++y) {
            for (int x = 0; x < pixels; ++x) {
                const glm::dvec3 mm(pixelCentreMm(scene, {x, y}), depth);
                EXPECT_EQ(picture.pixel(x, y)[3], 1);
                const double value = range.low + (range.high - range.low) * picture.pixel(x, y)[0];
                sum += std::pow(value - signal.value(mm), 2) / (pixels * pixels);
            }
        }
        return std::sqrt(sum);
    };
    EXPECT_NEAR(observedOrder(error(81), error(161)), 2, 0.2);
}

// ---- the integrator without a step ---------------------------------------------------------------------------------

glm::dvec4 exactPixel(const AnalyticScene& scene, const glm::dvec2& positionPixel) {
    const auto exact = reference::integrateExactly(*planOf(scene), positionPixel);
    EXPECT_TRUE(exact.converged);
    EXPECT_LT(exact.errorBar, 1e-9);
    return exact.rgba;
}

TEST(ExactRay, IsTheClosedForm) {
    const auto a1 = exactPixel(ConstantMedium().scene(1), {1, 1});
    EXPECT_NEAR(a1.a, ConstantMedium().opacity(), 1e-13);
    EXPECT_NEAR(a1.r, ConstantMedium().premultiplied(), 1e-13);
    // 1e-9: the opacity curve is linear between 4097 points
    const auto a2 = exactPixel(LinearRamp().scene({1, 0.5, 0.5}), {0.5, 0.5});
    EXPECT_NEAR(a2.a, LinearRamp().opacity(), 1e-9);
    EXPECT_NEAR(a2.r, LinearRamp().premultiplied(), 1e-9);
    const auto a3 = exactPixel(StepInterface().scene({1, 0.5, 0.5}), {0.5, 0.5});
    EXPECT_NEAR(a3.a, StepInterface().opacity(), 1e-8); // float32 voxels: the ramp's places are off by 6e-8
    EXPECT_NEAR(a3.r, StepInterface().premultiplied(), 1e-6);
}

TEST(ExactRay, IsTheLimitOfSmallSteps) {
    Ball ball;
    ball.spacingMm = 0.2; // a coarse field: the model's picture, not the ball's
    AnalyticScene scene = ball.scene(1, 4);
    const auto reference = makeReferenceBackend();
    const auto exact = exactPixel(scene, {1.5, 1.5});
    for (const double step : {0.05, 0.01, 0.002}) {
        scene.request.lattice->stepMm = step;
        const double sampled = renderWhole(*reference, scene).pixel(1, 1)[3];
        EXPECT_NEAR(sampled, exact.a, 2 * ball.extinctionPerMm * step) << step; // one step at either end
    }
}

TEST(ExactRay, AddsTheExtinctionsOfSeveralLayers) {
    AnalyticScene scene = LinearRamp().scene({1.0 / 4096, 0.5, 0.5});
    scene.figure.layers.push_back(StepInterface().scene({1, 0.5, 0.5}).figure.layers.front());
    const auto exact = exactPixel(scene, {0.5, 0.5});
    const Picture sampled = renderWhole(*makeReferenceBackend(), scene);
    // A sample composites one layer after the other: an error of the order of the step's depth, (24 / 4096)^2 a step.
    EXPECT_NEAR(sampled.pixel(0, 0)[0], exact.r, 5e-3);
    EXPECT_NEAR(sampled.pixel(0, 0)[3], exact.a, 1e-4);
}

TEST(ExactRay, StopsAtATrueSurface) {
    AnalyticScene scene = StepInterface().scene({1, 0.5, 0.5});
    for (glm::dvec2& point : scene.figure.layers.front().transfer.opacity) {
        if (point.y > 0.1) { // the second medium
            point.y = 1;
        }
    }
    const StepInterface interface;
    const double front = opacityOfMedium(interface.extinctionPerMm.x, interface.interfaceMm);
    const auto exact = exactPixel(scene, {0.5, 0.5});
    EXPECT_EQ(exact.a, 1);
    EXPECT_NEAR(exact.r, interface.colour.x * front + interface.colour.y * (1 - front), 1e-7);
}

TEST(ExactRay, RefusesShadedLayers) {
    auto scene = ConstantMedium().scene(1);
    scene.figure.layers.front().shading = Shading::phong;
    const auto plan = planOf(scene);
    EXPECT_ANY_THROW(reference::integrateExactly(*plan, {1, 1}));
}

} // namespace
} // namespace limner::accuracy
