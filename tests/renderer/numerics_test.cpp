#include "renderer/accuracy/analytic_scenes.h"
#include "support/make_volume.h"
#include "support/rendering.h"
#include "support/transfer_scenes.h"

#include <algorithm>
#include <cmath>
#include <vector>

// Lines of numerics.md 2b and 2f as pictures, on every backend. (Its formulas: accuracy/formula_vectors_test.cpp.)

namespace limner {
namespace {

using accuracy::AnalyticScene;
using accuracy::opacityOfMedium;
using testing::renderWhole;

class Numerics : public testing::BackendTest {};
LIMNER_ON_EVERY_BACKEND(Numerics);

/// A cube of eight voxels of 1 mm, of one value, opacity and colour.
AnalyticScene cubeOf(double opacity, double stepMm) {
    const auto volume = accuracy::sampleField(accuracy::centredGrid(8, 1), [](const glm::dvec3&) { return 3.0; });
    AnalyticScene scene{"cube", accuracy::plainFigure(volume, accuracy::viewAlongZ(glm::dvec3(0), 4)), {}};
    scene.request.size = {2, 2};
    scene.request.lattice = SampleLattice{stepMm, 0.5, 0};
    Transfer& transfer = scene.figure.layers.front().transfer;
    transfer.nodes = {{3, "", glm::dvec3(0.5)}};
    transfer.opacity = {{3, opacity}};
    return scene;
}

TEST_P(Numerics, ATrueSurfaceIsOpaqueAtEveryStep) { // 2b
    for (const double step : {1e-3, 0.3, 1.0, 8.0, 64.0, 1e6}) {
        for (const double kept : {8.0, 0.01}) { // also where a clip leaves a sliver of it
            AnalyticScene scene = cubeOf(1, step);
            scene.figure.clip.planes = {{{0, 0, 1}, -4 + kept}};
            EXPECT_EQ(renderWhole(backend(), scene).pixel(0, 0)[3], 1) << step << ' ' << kept;
        }
    }
}

TEST_P(Numerics, FaintSamplesAddUp) { // 2b
    for (const double opacity : {1e-4, 1e-8}) {
        for (const double step : {1e-3, 0.5}) {
            const double exact = opacityOfMedium(-std::log1p(-opacity), 8);
            EXPECT_NEAR(renderWhole(backend(), cubeOf(opacity, step)).pixel(0, 0)[3], exact, 1e-4 * exact) << step;
        }
    }
}

TEST_P(Numerics, ALongStepKnowsItsDepth) { // 2b: the opacity of a whole step is 1 but for rounding
    for (const double opacity : {0.3, 0.9, 0.999}) {
        for (const double kept : {0.05, 1.3, 8.0}) {
            AnalyticScene scene = cubeOf(opacity, 64);
            scene.figure.clip.planes = {{{0, 0, 1}, -4 + kept}};
            const Picture picture = renderWhole(backend(), scene);
            const double exact = opacityOfMedium(-std::log1p(-opacity), kept);
            EXPECT_NEAR(picture.pixel(1, 1)[3], exact, rounding(2e-7, 4e-6)) << opacity << ' ' << kept;
            EXPECT_NEAR(picture.pixel(1, 1)[0], exact / 2, rounding(2e-7, 4e-6)) << opacity << ' ' << kept;
        }
    }
}

TEST_P(Numerics, BehindWhatIsAllButOpaqueColoursDoNotAddUp) { // 2b
    // In single precision an opacity near 1 stands still, and 40,000 white samples behind it must not show. Black in
    // front down to a transmittance of 1.6e-7.
    AnalyticScene scene = cubeOf(0.98, 1e-4);
    scene.figure.volume->data =
        accuracy::sampleField(accuracy::centredGrid(8, 1), [](const glm::dvec3& mm) { return mm.z; });
    Transfer& transfer = scene.figure.layers.front().transfer;
    transfer.nodes = {{0, "", glm::dvec3(0)}, {0, "", glm::dvec3(1)}};
    const Picture picture = renderWhole(backend(), scene);
    EXPECT_NEAR(picture.pixel(0, 0)[3], 1, rounding(2e-7, 2e-4));
    EXPECT_NEAR(picture.pixel(0, 0)[0], 0, rounding(1e-6, 1e-5));
}

TEST_P(Numerics, SixteenBitsKeepEveryNumber) { // 2f
    // All 65,536 numbers in one slice, a voxel a pixel; colours tell them apart by 1.5e-5.
    constexpr int edge = 256;
    Grid grid = testing::gridOf({edge, edge, 1});
    const auto volume = testing::makeVolume<std::int16_t>(
        grid, VoxelType::int16, [](const glm::ivec3& v) { return v.y * edge + v.x - 32768; }, 1, 32768);
    AnalyticScene scene{"numbers", accuracy::plainFigure(volume, accuracy::viewAlongZ(grid.centreMm(), edge)), {}};
    scene.request.size = {edge, edge};
    Transfer& transfer = scene.figure.layers.front().transfer;
    transfer.nodes = {{0, "", glm::dvec3(0)}, {65535, "", glm::dvec3(1)}};
    transfer.opacity = {{0, 1}};
    const Picture picture = renderWhole(backend(), scene);
    EXPECT_EQ(picture.pixel(0, 0)[0], 0);
    EXPECT_NEAR(picture.pixel(edge - 1, edge - 1)[0], 1, 2e-7);
    double most = 0;
    for (int i = 0; i < edge * edge; ++i) {
        most = std::max(most, std::abs(65535.0 * picture.pixel(i % edge, i / edge)[0] - i));
    }
    EXPECT_LT(most, 0.5);
}

TEST_P(Numerics, AConstantVolumeIsAMediumHoweverItIsKept) { // 2f
    for (const double slope : {1e-3, -1e-3}) {
        for (const bool plane : {false, true}) {
            Figure figure = testing::smoothFigure({});
            const Grid grid = accuracy::centredGrid(8, 1);
            figure.volume->data = testing::makeVolume<std::int16_t>(
                grid, VoxelType::int16, [](const glm::ivec3&) { return 1234; }, slope, 0.5 - slope * 1234);
            Layer& layer = figure.layers.front();
            if (plane) {
                testing::makePlane(layer, "value", "second");
                layer.transfer.opacity2d.clear();
            }
            layer.transfer.opacity = {{0, 0.2}, {1, 0.2}};
            figure.camera = accuracy::viewAlongZ(glm::dvec3(0), 4);
            figure.quality.earlyTermination = 0;
            PlanRequest request;
            request.size = {2, 2};
            const Picture picture = renderWhole(backend(), *testing::planOf(figure, request));
            EXPECT_NEAR(picture.pixel(0, 0)[3], opacityOfMedium(-std::log1p(-0.2), 8), rounding(2e-7, 4e-6))
                << slope << (plane ? " plane" : " line");
        }
    }
}

} // namespace
} // namespace limner
