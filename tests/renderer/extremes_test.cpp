#include "core/base/error.h"
#include "core/volume/import.h"
#include "renderer/accuracy/analytic_scenes.h"
#include "support/rendering.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

// Extremes of data and view (numerics.md 2f), on every backend.

namespace limner {
namespace {

using accuracy::AnalyticScene;
using accuracy::opacityOfMedium;
using testing::BackendTest;
using testing::planOf;
using testing::renderWhole;

constexpr double kSingle = 6e-6; // some 50 ulp: single precision along a ray of a hundred samples

class Extremes : public BackendTest {};
LIMNER_ON_EVERY_BACKEND(Extremes);

/// One medium of extinction `perMm` on a grid.
AnalyticScene mediumOn(const Grid& grid, double perMm, const Camera& camera) {
    const auto volume = accuracy::sampleField(grid, [](const glm::dvec3&) { return 7.0; });
    AnalyticScene scene{"medium", accuracy::plainFigure(volume, camera), {}};
    scene.request.size = {8, 8};
    Layer& layer = scene.figure.layers.front();
    layer.transfer.nodes = {{7, "", glm::dvec3(0.5, 0.25, 1)}};
    layer.transfer.opacity = {{7, opacityOfMedium(perMm, grid.smallestSpacingMm())}};
    return scene;
}

/// Length of the ray from `origin` along the unit `direction` inside the grid's box, from the origin on.
double chordMm(const Grid& grid, const glm::dvec3& origin, const glm::dvec3& direction, double nearest) {
    const glm::dvec3 low = grid.mmFromVoxel(glm::dvec3(-0.5));
    const glm::dvec3 high = grid.mmFromVoxel(glm::dvec3(grid.dims) - 0.5);
    double in = nearest;
    double out = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (low[axis] - origin[axis]) / direction[axis];
        const double b = (high[axis] - origin[axis]) / direction[axis];
        in = std::max(in, std::min(a, b));
        out = std::min(out, std::max(a, b));
    }
    return std::max(0.0, out - in);
}

/// Four bytes a voxel, little-endian, read as the importer reads them.
std::shared_ptr<const Volume> importFloats(const std::vector<float>& values, glm::ivec3 dims) {
    const auto path =
        std::filesystem::temp_directory_path() /
        ("limner-extremes-" +
         std::to_string(std::hash<std::string>()(::testing::UnitTest::GetInstance()->current_test_info()->name())) +
         ".raw");
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(values.data()),
               static_cast<std::streamsize>(values.size() * sizeof(float)));
    ImportOptions options;
    options.raw =
        std::to_string(dims.x) + "x" + std::to_string(dims.y) + "x" + std::to_string(dims.z) + ":float32:le:1,1,1";
    Task task;
    auto imported = importVolume(path, options, task);
    std::filesystem::remove(path);
    return imported.volume;
}

TEST_P(Extremes, ANanVoxelGivesTheMaskedPicture) {
    constexpr int n = 32;
    std::vector<float> values(n * n * n);
    for (int i = 0; i < n * n * n; ++i) {
        values[static_cast<std::size_t>(i)] =
            static_cast<float>(std::sin(0.3 * (i % n)) + std::cos(0.2 * (i / n % n)) + 0.01 * (i / n / n));
    }
    const float lowest = *std::min_element(values.begin(), values.end());
    const std::size_t middle = (n / 2 * n + n / 2) * n + n / 2;
    values[middle] = lowest;
    const auto masked = importFloats(values, glm::ivec3(n));
    values[middle] = std::numeric_limits<float>::quiet_NaN();
    const auto holed = importFloats(values, glm::ivec3(n));
    EXPECT_EQ(holed->contents().nonFinite, 1U);
    const auto picture = [&](std::shared_ptr<const Volume> volume) {
        AnalyticScene scene{
            "nan", accuracy::plainFigure(std::move(volume), accuracy::viewAlongZ(glm::dvec3((n - 1) / 2.0), n)), {}};
        scene.request.size = {n, n};
        Layer& layer = scene.figure.layers.front();
        layer.shading = Shading::phong;
        layer.transfer.nodes = {{-2, "", glm::dvec3(1, 0, 0)}, {2, "", glm::dvec3(0, 0, 1)}};
        layer.transfer.opacity = {{-2, 0}, {2, 0.2}};
        return renderWhole(backend(), scene);
    };
    const Picture withHole = picture(holed);
    EXPECT_EQ(testing::unsoundPixels(withHole), 0);
    EXPECT_TRUE(testing::sameBits(withHole, picture(masked)));
}

TEST_P(Extremes, DenormalDataLookLikeOrdinaryData) {
    // A ramp of multiples of 2^-140 is the ramp 0..1, bit for bit: both are normalised in double.
    constexpr int n = 16;
    const auto picture = [&](double unit) {
        std::vector<float> values;
        for (int i = 0; i < n * n * n; ++i) {
            values.push_back(static_cast<float>((i / n / n + i % n) * unit));
        }
        AnalyticScene scene{"ramp",
                            accuracy::plainFigure(importFloats(values, glm::ivec3(n)),
                                                  accuracy::viewAlongZ(glm::dvec3((n - 1) / 2.0), n)),
                            {}};
        scene.request.size = {n, n};
        Layer& layer = scene.figure.layers.front();
        layer.transfer.nodes = {{0, "", glm::dvec3(0)}, {30 * unit, "", glm::dvec3(1)}};
        layer.transfer.opacity = {{0, 0}, {30 * unit, 0.5}};
        return renderWhole(backend(), scene);
    };
    const Picture ordinary = picture(1.0 / 32);
    EXPECT_EQ(testing::unsoundPixels(ordinary), 0);
    EXPECT_GT(ordinary.pixel(8, 8)[3], 0.5);
    EXPECT_TRUE(testing::sameBits(ordinary, picture(std::ldexp(1.0, -140))));
    EXPECT_TRUE(testing::sameBits(ordinary, picture(std::ldexp(1.0, 120)))); // and at the other end of the type
}

TEST_P(Extremes, OneSliceIsASlabOfItsSpacing) {
    Grid grid;
    grid.dims = {512, 512, 1};
    grid.spacingMm = {0.5, 0.5, 3};
    AnalyticScene scene = mediumOn(grid, 0.4, accuracy::viewAlongZ(grid.centreMm(), 200));
    for (const Shading shading : {Shading::flat, Shading::phong}) {
        scene.figure.layers.front().shading = shading;
        const Picture picture = renderWhole(backend(), scene);
        EXPECT_EQ(testing::unsoundPixels(picture), 0);
        for (int i = 0; i < 64; ++i) {
            EXPECT_NEAR(picture.pixel(i % 8, i / 8)[3], opacityOfMedium(0.4, 3), kSingle);
        }
    }
}

TEST_P(Extremes, OneVoxelIsABox) {
    Grid grid;
    grid.dims = {1, 1, 1};
    grid.spacingMm = {2, 2, 2};
    const Picture picture = renderWhole(backend(), mediumOn(grid, 0.3, accuracy::viewAlongZ(glm::dvec3(0), 4)));
    EXPECT_NEAR(picture.pixel(4, 4)[3], opacityOfMedium(0.3, 2), kSingle);
    EXPECT_EQ(picture.pixel(0, 0)[3], 0);
}

TEST_P(Extremes, ExtremeExtinctionNeverLeavesTheUnitInterval) {
    for (const double perMm : {1e-9, 1e3, 1e6, 1e12}) {
        const Picture picture = renderWhole(
            backend(), mediumOn(accuracy::centredGrid(8, 1), perMm, accuracy::viewAlongZ(glm::dvec3(0), 4)));
        EXPECT_EQ(testing::unsoundPixels(picture), 0);
        EXPECT_NEAR(picture.pixel(3, 3)[3], opacityOfMedium(perMm, 8), kSingle);
        if (perMm < 1e-6) {
            EXPECT_GT(picture.pixel(3, 3)[3], 0) << "thin matter must not round away";
        }
    }
}

TEST_P(Extremes, AHundredThousandStepsDoNotDrift) {
    const accuracy::ConstantMedium medium;
    const Picture picture = renderWhole(backend(), medium.scene(1e-5));
    // Single precision rounds every of the 1e5 additions: half an ulp each, all in one direction at worst, is 3e-3.
    EXPECT_NEAR(picture.pixel(0, 0)[3], medium.opacity(), rounding(1e-7, 5e-4));
}

TEST_P(Extremes, ACameraInsideSeesWhatLiesAhead) {
    Grid grid;
    grid.dims = {20, 30, 25};
    grid.spacingMm = {1, 0.5, 0.8};
    std::mt19937 random(7);
    std::uniform_real_distribution<double> inside(0.05, 0.95);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 eye =
            grid.mmFromVoxel(glm::dvec3(inside(random), inside(random), inside(random)) * glm::dvec3(grid.dims) - 0.5);
        Camera camera;
        camera.projection = Projection::perspective;
        camera.direction = glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
        camera.up = {0.3, 0.1, 1};
        camera.fovDeg = 50;
        camera.heightMm = 10;
        const double distance = 5 / std::tan(glm::radians(25.0));
        camera.targetMm = eye + camera.direction * distance;
        const AnalyticScene scene = mediumOn(grid, 0.1, camera);
        const Picture picture = renderWhole(backend(), scene);
        ASSERT_EQ(testing::unsoundPixels(picture), 0);
        const glm::dvec3 right = glm::normalize(glm::cross(camera.direction, camera.up));
        const glm::dvec3 up = glm::cross(right, camera.direction);
        for (const glm::ivec2 at : {glm::ivec2(0, 0), glm::ivec2(4, 3), glm::ivec2(7, 7)}) {
            const glm::dvec2 offset = (glm::dvec2(at) + 0.5 - 4.0) * 10.0 / 8.0;
            const glm::dvec3 ray = glm::normalize(camera.direction * distance + right * offset.x - up * offset.y);
            EXPECT_NEAR(picture.pixel(at.x, at.y)[3], opacityOfMedium(0.1, chordMm(grid, eye, ray, 0)),
                        rounding(2e-7, 2e-5));
        }
    }
}

TEST_P(Extremes, TwentySixViewsAreSound) {
    const Grid grid = accuracy::centredGrid(12, 1);
    for (int i = 0; i < 27; ++i) {
        const glm::dvec3 direction(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        if (direction == glm::dvec3(0)) {
            continue;
        }
        for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
            Camera camera;
            camera.projection = projection;
            camera.direction = direction;
            camera.up = {0.31, 0.57, -0.76};
            camera.heightMm = 24;
            for (const Shading shading : {Shading::flat, Shading::phong}) {
                AnalyticScene scene = mediumOn(grid, 0.1, camera);
                scene.figure.layers.front().shading = shading;
                scene.request.size = {24, 24};
                const Picture picture = renderWhole(backend(), scene);
                EXPECT_EQ(testing::unsoundPixels(picture), 0);
                EXPECT_GT(picture.pixel(12, 12)[3], 0.5);
                EXPECT_EQ(picture.pixel(0, 0)[3], 0);
            }
        }
    }
}

TEST_P(Extremes, RaysAlongFacesAndEdgesAreInsideOrOutsideButWhole) {
    // Pixels of half a voxel whose middles fall on the box's own faces: such a ray sees the whole length or nothing.
    const Grid grid = accuracy::centredGrid(8, 1); // the box is [-4, 4]^3
    AnalyticScene scene = mediumOn(grid, 0.2, accuracy::viewAlongZ(glm::dvec3(0), 9));
    scene.request.size = {9, 9};
    const Picture picture = renderWhole(backend(), scene);
    for (int y = 0; y < 9; ++y) {
        for (int x = 0; x < 9; ++x) {
            const double alpha = picture.pixel(x, y)[3];
            const bool face = x == 0 || x == 8 || y == 0 || y == 8;
            if (!face || alpha > 0) {
                EXPECT_NEAR(alpha, opacityOfMedium(0.2, 8), kSingle) << x << ' ' << y;
            }
        }
    }
}

TEST_P(Extremes, PerspectiveMeasuresLengthsAlongTheRay) {
    Grid grid;
    grid.dims = {20, 16, 10};
    grid.spacingMm = {1, 1, 2};
    Camera camera = accuracy::viewAlongZ(grid.centreMm(), 14);
    camera.projection = Projection::perspective;
    camera.fovDeg = 40;
    const AnalyticScene scene = mediumOn(grid, 0.08, camera);
    const Picture picture = renderWhole(backend(), scene);
    const double distance = 7 / std::tan(glm::radians(20.0));
    const glm::dvec3 eye = grid.centreMm() - glm::dvec3(0, 0, distance);
    for (int i = 0; i < 64; ++i) {
        const glm::dvec2 offset = (glm::dvec2(i % 8, i / 8) + 0.5 - 4.0) * 14.0 / 8.0;
        const glm::dvec3 ray = glm::normalize(glm::dvec3(offset, distance));
        EXPECT_NEAR(picture.pixel(i % 8, i / 8)[3], opacityOfMedium(0.08, chordMm(grid, eye, ray, 0)),
                    rounding(1e-7, 1e-5));
    }
}

TEST_P(Extremes, ObliqueAxesChangeNothing) {
    // A rotated, left-handed grid in the same physical place under the same rays shows the same chords.
    Grid straight = accuracy::centredGrid(16, 1);
    Grid mirrored = straight;
    mirrored.direction = glm::dmat3({0, 1, 0}, {1, 0, 0}, {0, 0, 1});
    mirrored.originMm = {straight.originMm.y, straight.originMm.x, straight.originMm.z};
    Camera camera;
    camera.direction = {1, 2, 3};
    camera.heightMm = 24;
    const Picture a = renderWhole(backend(), mediumOn(straight, 0.1, camera));
    const Picture b = renderWhole(backend(), mediumOn(mirrored, 0.1, camera));
    EXPECT_LT(testing::largestDifference(a, b), rounding(1e-7, 1e-5));
}

TEST_P(Extremes, ClipPlanesCutExactly) {
    const Grid grid = accuracy::centredGrid(10, 1); // [-5, 5]
    for (const double step : {0.21, 0.5, 3.0}) {
        for (const double offset : {-4.97, -1.234, 0.0, 2.5}) {
            AnalyticScene scene = mediumOn(grid, 0.15, accuracy::viewAlongZ(glm::dvec3(0), 6));
            scene.request.lattice = SampleLattice{step, 0.5, 0};
            scene.figure.clip.planes = {{{0, 0, 2}, 2 * offset}}; // the back goes; normals need not be unit
            EXPECT_NEAR(renderWhole(backend(), scene).pixel(4, 4)[3], opacityOfMedium(0.15, offset + 5), kSingle);
            scene.figure.clip.planes = {{{0, 0, -1}, -offset}}; // the front goes
            EXPECT_NEAR(renderWhole(backend(), scene).pixel(4, 4)[3], opacityOfMedium(0.15, 5 - offset), kSingle);
            scene.figure.clip.boxMm = BoxMm{{-1, -1, -2.2}, {9, 1, 3.3}};
            const double kept = std::max(0.0, 3.3 - std::max(offset, -2.2));
            const Picture picture = renderWhole(backend(), scene);
            EXPECT_NEAR(picture.pixel(4, 4)[3], opacityOfMedium(0.15, kept), kSingle);
            EXPECT_NEAR(picture.pixel(7, 4)[3], opacityOfMedium(0.15, kept), kSingle);
            EXPECT_EQ(picture.pixel(1, 4)[3], 0);
            EXPECT_EQ(picture.pixel(4, 0)[3], 0);
        }
    }
    AnalyticScene gone = mediumOn(grid, 0.15, accuracy::viewAlongZ(glm::dvec3(0), 6));
    gone.figure.clip.planes = {{{1, 1, 1}, -100}};
    EXPECT_EQ(renderWhole(backend(), gone).pixel(4, 4)[3], 0);
}

/// A ball with Phong shading in a world scaled by a power of two.
AnalyticScene scaledBall(double scale, Projection projection) {
    accuracy::Ball ball;
    ball.radiusMm = scale;
    ball.spacingMm = 0.125 * scale;
    ball.extinctionPerMm = 1.5 / scale;
    AnalyticScene scene = ball.scene(0.03125 * scale, 16);
    Layer& layer = scene.figure.layers.front();
    layer.shading = Shading::phong;
    layer.transfer.nodes = {{0, "", glm::dvec3(0.9, 0.5, 0.2)}};
    layer.transfer.opacity = {{0, 0}, {0, 0.2}, {0.5 * scale, 0.9}};
    scene.figure.camera.projection = projection;
    scene.figure.camera.direction = {1, 0.5, 2};
    return scene;
}

TEST_P(Extremes, AnyScaleGivesTheSameBits) {
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
        const Picture unit = renderWhole(backend(), scaledBall(1, projection));
        EXPECT_GT(unit.pixel(8, 8)[3], 0.5);
        for (const int exponent : {-20, -10, -3, 1, 10}) {
            EXPECT_TRUE(
                testing::sameBits(unit, renderWhole(backend(), scaledBall(std::ldexp(1.0, exponent), projection))))
                << exponent;
        }
    }
}

/// A style with a steep slope around one normal: reads a normal to a ten-thousandth in spite of packing to 11 bits.
constexpr double kSteepness = 20;
std::shared_ptr<const LitSphere> steepSphere(const glm::dvec2& around) {
    constexpr int size = 512;
    std::vector<Rgba> pixels;
    const auto channel = [](double n, double middle) {
        return static_cast<float>(std::clamp(0.5 + kSteepness * (n - middle), 0.0, 1.0));
    };
    for (int i = 0; i < size * size; ++i) {
        const double x = 2 * (i % size + 0.5) / size - 1;
        const double y = 1 - 2 * (i / size + 0.5) / size;
        pixels.push_back({channel(x, around.x), channel(y, around.y), 0, 1});
    }
    return std::make_shared<const LitSphere>(size, std::move(pixels));
}

TEST_P(Extremes, SpacingsOfOneToAThousandKeepTheNormal) {
    // A plane at 45 degrees on a grid of 1 x 1 x 1000 mm: whole numbers, so that the data add no error of their own.
    Grid grid;
    grid.dims = {9, 9, 4};
    grid.spacingMm = {1, 1, 1000};
    std::vector<std::int16_t> stored;
    for (int i = 0; i < 9 * 9 * 4; ++i) {
        stored.push_back(static_cast<std::int16_t>(i % 9 + 1000 * (i / 81)));
    }
    Volume::Contents contents;
    contents.grid = grid;
    contents.type = VoxelType::int16;
    contents.range = {0, 3008};
    const auto volume = std::make_shared<const Volume>(contents, std::as_bytes(std::span(stored)));
    AnalyticScene scene{"plane", accuracy::plainFigure(volume, accuracy::viewAlongZ({4.3, 4.2, 1300}, 0.01)), {}};
    scene.request.size = {1, 1};
    scene.request.lattice = SampleLattice{1e5, 0.5, 0};
    scene.figure.clip.planes = {{{0, 0, 1}, 1310}, {{0, 0, -1}, -1290}};
    const glm::dvec3 normal = glm::normalize(glm::dvec3(-1, 0, 1)); // eye: out of dense matter, z towards the viewer
    StyleEntry entry;
    entry.id = "style";
    entry.sphere = steepSphere({normal.x, normal.y});
    scene.figure.styles = {entry};
    Layer& layer = scene.figure.layers.front();
    layer.shading = Shading::style;
    layer.transfer.nodes = {{0, "style", std::nullopt}};
    layer.transfer.opacity = {{0, 1}};
    const Picture picture = renderWhole(backend(), scene);
    const double dx = (picture.pixel(0, 0)[0] - 0.5) / kSteepness;
    const double dy = (picture.pixel(0, 0)[1] - 0.5) / kSteepness;
    // A change of n_x turns the normal by dx / n_z.
    const double angleDeg = std::hypot(dx / normal.z, dy) * 180 / std::numbers::pi;
    EXPECT_EQ(picture.pixel(0, 0)[3], 1);
    EXPECT_LT(angleDeg, 0.01);
}

TEST_P(Extremes, AFarEyeAndAHugePictureKeepTheirPixels) {
    // An eye ten thousand box sizes away, a picture of 32768^2: neighbouring pixels are 1/32768 of the box apart. One
    // sample a ray on a linear field reads the ray's place off the colour.
    constexpr int n = 16;
    const Grid grid = accuracy::centredGrid(n, 1);
    const auto volume = accuracy::sampleField(grid, [](const glm::dvec3& mm) { return mm.x; });
    Camera camera = accuracy::viewAlongZ(glm::dvec3(0), n);
    camera.projection = Projection::perspective;
    camera.fovDeg = 2 * std::atan(0.5 / 1e4) * 180 / std::numbers::pi;
    AnalyticScene scene{"poster", accuracy::plainFigure(volume, camera), {}};
    scene.request.size = glm::ivec2(32768);
    scene.request.lattice = SampleLattice{100, 0.5, 0};
    scene.figure.clip.planes = {{{0, 0, 1}, 0.01}, {{0, 0, -1}, 0.01}};
    Layer& layer = scene.figure.layers.front();
    layer.transfer.nodes = {{-7.5, "", glm::dvec3(0)}, {7.5, "", glm::dvec3(1)}}; // linear: tables have it exactly
    layer.transfer.opacity = {{-10, 1}};
    const auto plan = planOf(scene);
    const double pixelMm = static_cast<double>(n) / 32768;
    Task task;
    for (const glm::ivec2 corner : {glm::ivec2(3000, 7000), glm::ivec2(16380, 20000), glm::ivec2(29000, 31000)}) {
        const Picture tile = backend().render(*plan, {corner, {16, 2}}, task).picture;
        for (int x = 0; x < 16; ++x) {
            const double mm = tile.pixel(x, 1)[0] * 15.0 - 7.5;
            // numerics 2f asks for 0.01 pixel; a colour in single precision tells one pixel of 32768 to 0.004 at best,
            // and some operations on it to ten times that.
            EXPECT_NEAR((mm + n / 2.0) / pixelMm - 0.5, corner.x + x, rounding(0.01, 0.04)) << corner.x;
        }
    }
}

} // namespace
} // namespace limner
