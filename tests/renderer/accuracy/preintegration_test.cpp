#include "renderer/accuracy/analytic_scenes.h"
#include "renderer/reference/exact_ray.h"
#include "renderer/reference/ray_parts.h"
#include "support/make_volume.h"
#include "support/rendering.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <random>
#include <vector>

// Pre-integration in pictures: the analytic scenes of accuracy.md 1.5, thin peaks (1.7), and empty space passed over.

namespace limner::accuracy {
namespace {

using testing::BackendTest;
using testing::planOf;
using testing::renderWhole;

class Preintegrated : public BackendTest {};
LIMNER_ON_EVERY_BACKEND(Preintegrated);

AnalyticScene preintegrated(AnalyticScene scene) {
    scene.figure.quality.preintegration = true;
    return scene;
}

TEST_P(Preintegrated, A1IsExactAtAnyStepAndAnyCut) {
    const ConstantMedium medium;
    for (const double step : {0.003, 0.0625, 0.1, 0.3, 0.7, 1.0, 5.0}) {
        const Picture picture = renderWhole(backend(), preintegrated(medium.scene(step)));
        for (const glm::ivec2 at : {glm::ivec2(0, 0), glm::ivec2(1, 1)}) {
            // 1e-5: some hundred steps in single precision
            EXPECT_NEAR(picture.pixel(at.x, at.y)[3], medium.opacity(), rounding(2e-7, 1e-5)) << step;
            EXPECT_NEAR(picture.pixel(at.x, at.y)[0], medium.premultiplied(), rounding(2e-7, 1e-5)) << step;
        }
        AnalyticScene cut = preintegrated(medium.scene(step));
        const double front = 0.217; // of the slab's mm
        const double back = 0.654;
        const Grid& grid = cut.figure.volume->data->grid();
        const double low = grid.originMm.z - grid.spacingMm.z / 2;
        cut.figure.clip.planes = {{{0, 0, 1}, low + back}, {{0, 0, -1}, -(low + front)}};
        const double expected = -std::expm1(-medium.extinctionPerMm * (back - front));
        EXPECT_NEAR(renderWhole(backend(), cut).pixel(0, 1)[3], expected, rounding(2e-7, 1e-5)) << step;
    }
}

double rampError(const Backend& backend, double step) {
    const LinearRamp ramp;
    const Picture picture = renderWhole(backend, preintegrated(ramp.scene({step, 0.5, 0.5})));
    EXPECT_NEAR(picture.pixel(0, 0)[3], ramp.opacity(), 1e-5) << step;
    return std::abs(picture.pixel(0, 0)[0] - ramp.premultiplied());
}

TEST_P(Preintegrated, A2IsAllButExactInOneSlab) {
    const LinearRamp ramp;
    const auto pointSampled = [&](double step) {
        const Picture picture = renderWhole(backend(), ramp.scene({step, 0.5, 0.5}));
        return std::abs(picture.pixel(0, 0)[0] - ramp.premultiplied());
    };
    EXPECT_LT(rampError(backend(), 1), 0.004); // what a ramp differs from a block; the spread of its colours is 1
    EXPECT_LT(rampError(backend(), 1), pointSampled(1) / 5);
    for (const double step : {0.5, 0.25, 0.125}) {
        EXPECT_LT(rampError(backend(), step), pointSampled(step) / 10) << step;
    }
}

TEST_P(Preintegrated, A3FindsTheInterfaceBetweenSamples) {
    const StepInterface interface;
    for (const double step : {1.0 / 8, 0.1, 0.07, 1.0 / 16, 0.05, 0.03, 1.0 / 64}) {
        const Picture picture = renderWhole(backend(), preintegrated(interface.scene({step, 0.5, 0.5})));
        const float* pixel = picture.pixel(0, 0);
        // The table gives the interface a width of 1/16384.
        EXPECT_NEAR(pixel[3], interface.opacity(), 2e-6) << step;
        // Point sampling is off by up to 6.38 h. Two colours in one slab count as a block of colours between them.
        EXPECT_NEAR(pixel[0], interface.premultiplied(), 0.4 * step) << step;
    }
}

// ---- thin peaks (accuracy.md 1.7)
// ------------------------------------------------------------------------------------

/// Marschner and Lobb's signal with three rings, a Gaussian peak of opacity around one half, colours along the value.
AnalyticScene thinPeak(double width, double stepVoxels) {
    MarschnerLobb signal;
    signal.frequency = 3;
    constexpr int voxels = 64;
    AnalyticScene scene{"thin peak", plainFigure(signal.volume(voxels), viewAlongZ(glm::dvec3(0), 1.8)), {}};
    Camera& camera = scene.figure.camera;
    camera.direction = {0.3, 0.5, 0.8};
    scene.request.size = {10, 10};
    const double spacing = scene.figure.volume->data->grid().smallestSpacingMm();
    scene.request.lattice = SampleLattice{stepVoxels * spacing, 0.5, 0};
    Transfer& transfer = scene.figure.layers.front().transfer;
    transfer.nodes = {{0.5 - 3 * width, "", glm::dvec3(1, 0.2, 0)}, {0.5 + 3 * width, "", glm::dvec3(0, 0.4, 1)}};
    transfer.opacity.clear();
    for (int i = -20; i <= 20; ++i) {
        const double s = 4 * i / 20.0;
        transfer.opacity.emplace_back(0.5 + s * width, i == -20 || i == 20 ? 0 : 0.9 * std::exp(-s * s / 2));
    }
    return scene;
}

/// Root of the mean square over pixels and channels, against the integral without a step.
double errorOf(const Picture& picture, const std::vector<glm::dvec4>& exact) {
    double sum = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        for (int c = 0; c < 4; ++c) {
            const double d = picture.rgba()[4 * i + static_cast<std::size_t>(c)] - exact[i][c];
            sum += d * d;
        }
    }
    return std::sqrt(sum / static_cast<double>(picture.rgba().size()));
}

std::vector<glm::dvec4> exactPicture(const AnalyticScene& scene) {
    const auto plan = planOf(scene);
    std::vector<glm::dvec4> pixels;
    for (int y = 0; y < plan->size.y; ++y) {
        for (int x = 0; x < plan->size.x; ++x) {
            pixels.push_back(reference::integrateExactly(*plan, {x + 0.5, y + 0.5}).rgba);
        }
    }
    return pixels;
}

class ThinPeak : public ::testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(OfWidth, ThinPeak, ::testing::Values(0.02, 0.005), [](const auto& one) {
    return std::to_string(static_cast<int>(std::lround(one.param * 1000))) + "thousandths";
});

TEST_P(ThinPeak, IsTenTimesBetterThanPointSampling) {
    const double width = GetParam();
    const std::vector<glm::dvec4> exact = exactPicture(thinPeak(width, 1));
    const auto cpu = makeCpuBackend();
    std::vector<double> ofSlabs;
    for (const double step : {1.0, 0.5, 0.25}) {
        const AnalyticScene scene = thinPeak(width, step);
        const double point = errorOf(renderWhole(*cpu, scene), exact);
        const double slabs = errorOf(renderWhole(*cpu, preintegrated(scene)), exact);
        std::cout << "width " << width << ", step " << step << " voxels: " << point << " by points, " << slabs
                  << " by slabs\n";
        if (width < 0.02) { // what is left is the field's: it is not linear over a voxel
            EXPECT_LT(slabs, point / (step < 1 ? 10 : 5)) << step;
        }
        ofSlabs.push_back(slabs);
    }
    EXPECT_GT(std::log2(ofSlabs[0] / ofSlabs[1]), 1.4);
    EXPECT_GT(std::log2(ofSlabs[1] / ofSlabs[2]), 1.8);
}

// ---- empty space
// -------------------------------------------------------------------------------------------------------

/// Smooth noise with thin shells of opacity, so that matter begins and ends at blocks of every neighbourhood.
AnalyticScene shells(unsigned seed, double stepVoxels, Projection projection) {
    std::mt19937 random(seed);
    const auto next = [&](double low, double high) { return low + (high - low) * random() / 4294967296.0; };
    const glm::dvec3 wave(next(0.1, 0.5), next(0.1, 0.5), next(0.1, 0.5));
    const Grid grid = centredGrid(37, 1);
    const auto volume = testing::makeVolume<std::uint8_t>(grid, VoxelType::uint8, [&](const glm::ivec3& v) {
        const double s = std::sin(wave.x * v.x) + std::sin(wave.y * v.y) + std::sin(wave.z * v.z);
        return std::lround(255 * (s + 3) / 6);
    });
    Camera camera;
    camera.projection = projection;
    camera.direction = {next(-1, 1), next(-1, 1), next(-1, 1)};
    camera.heightMm = 40;
    AnalyticScene scene{"shells", plainFigure(volume, camera), {}};
    scene.request.size = {40, 40};
    scene.request.lattice = SampleLattice{stepVoxels, 0.5, 0};
    const double at = volume->range().low + next(0.2, 0.8) * (volume->range().high - volume->range().low);
    Transfer& transfer = scene.figure.layers.front().transfer;
    transfer.nodes = {{at - 2, "", glm::dvec3(1, 0, 0)}, {at + 2, "", glm::dvec3(0, 0, 1)}};
    transfer.opacity = {{at - 1.5, 0}, {at, 0.6}, {at + 1.5, 0}};
    return scene;
}

TEST_P(Preintegrated, PassingOverEmptyBlocksChangesNoBit) {
    if (isReference()) {
        GTEST_SKIP() << "it takes every sample";
    }
    int skipping = 0;
    for (unsigned seed = 0; seed < 12; ++seed) {
        for (const double step : {0.4, 1.7, 5.3}) { // longer than a block, too
            AnalyticScene scene =
                preintegrated(shells(seed, step, seed % 2 == 0 ? Projection::perspective : Projection::orthographic));
            const auto with = planOf(scene);
            scene.request.kept = {LeaveOut::emptySpace};
            const auto without = planOf(scene);
            ASSERT_EQ(without->skip->occupied, 1);
            skipping += with->skip->occupied < 0.7 ? 1 : 0;
            const Picture picture = renderWhole(backend(), *with);
            EXPECT_TRUE(testing::sameBits(picture, renderWhole(backend(), *without))) << seed << ' ' << step;
        }
    }
    EXPECT_GT(skipping, 10);
}

TEST_P(Preintegrated, TilesAreTheWholePicture) {
    const AnalyticScene scene = preintegrated(shells(5, 0.9, Projection::perspective));
    const auto plan = planOf(scene);
    EXPECT_TRUE(testing::sameBits(renderWhole(backend(), *plan), testing::renderTiles(backend(), *plan, {3, 2})));
}

TEST(PreintegratedPick, PartsOfARayAreThePixel) {
    AnalyticScene scene = preintegrated(shells(3, 0.7, Projection::orthographic));
    Layer second = scene.figure.layers.front();
    second.transfer.opacity = {{0, 0.05}};
    second.transfer.nodes = {{0, "", glm::dvec3(0, 1, 0)}};
    scene.figure.layers.push_back(second);
    const auto plan = planOf(scene);
    const Picture picture = renderWhole(*makeReferenceBackend(), *plan);
    for (const glm::ivec2 pixel : {glm::ivec2(20, 20), glm::ivec2(13, 25)}) {
        double sum = 0;
        double ofSecond = 0;
        for (const reference::RayPart& part : reference::rayParts(*plan, glm::dvec2(pixel) + 0.5)) {
            sum += part.weight;
            ofSecond += part.layer == 1 ? part.weight : 0;
        }
        EXPECT_NEAR(sum, picture.pixel(pixel.x, pixel.y)[3], 1e-6);
        EXPECT_NEAR(ofSecond, picture.pixel(pixel.x, pixel.y)[1], 1e-6); // the only green
    }
}

} // namespace
} // namespace limner::accuracy
