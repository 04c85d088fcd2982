#include "core/base/error.h"
#include "core/volume/phantom.h"
#include "renderer/accuracy/analytic_scenes.h"
#include "support/rendering.h"

#include <tbb/global_control.h>

#include <chrono>
#include <cmath>
#include <thread>

// What every backend promises beside the picture itself: tiles, threads, sub-pixels, layers, cancellation.

namespace limner {
namespace {

using accuracy::AnalyticScene;
using testing::BackendTest;
using testing::planOf;
using testing::renderWhole;

class BackendContract : public BackendTest {};
LIMNER_ON_EVERY_BACKEND(BackendContract);

/// A head in perspective: bone with a Phong light under translucent skin with a lit sphere.
AnalyticScene head(int pixels) {
    Camera camera;
    camera.projection = Projection::perspective;
    camera.direction = {0.4, 0.8, -0.2};
    camera.up = {0, 0, 1};
    camera.heightMm = 220;
    const auto volume = makeHeadPhantom(48);
    camera.targetMm = volume->grid().centreMm();
    AnalyticScene scene{"head", accuracy::plainFigure(volume, camera), {}};
    scene.request.size = glm::ivec2(pixels);
    scene.figure.quality.stepVoxels = 0.5;
    scene.figure.quality.earlyTermination = 1e-3;
    constexpr int size = 64;
    std::vector<Rgba> pixelsOfStyle;
    for (int i = 0; i < size * size; ++i) {
        const auto x = static_cast<float>(i % size) / size;
        const auto y = static_cast<float>(i / size) / size;
        pixelsOfStyle.push_back({0.9F - 0.4F * y, 0.7F - 0.5F * x * x, 0.3F + 0.3F * x * y, 1});
    }
    StyleEntry entry;
    entry.id = "skin";
    entry.sphere = std::make_shared<const LitSphere>(size, std::move(pixelsOfStyle));
    scene.figure.styles = {entry};
    Layer& bone = scene.figure.layers.front();
    bone.shading = Shading::phong;
    bone.transfer.nodes = {{200, "", glm::dvec3(0.9, 0.85, 0.7)}, {1500, "", glm::dvec3(1, 1, 1)}};
    bone.transfer.opacity = {{150, 0}, {500, 0.8}};
    Layer skin;
    skin.name = "skin";
    skin.transfer.nodes = {{-200, "skin", std::nullopt}};
    skin.transfer.opacity = {{-300, 0}, {-100, 0.06}, {60, 0.06}, {120, 0}};
    scene.figure.layers.push_back(skin);
    return scene;
}

TEST_P(BackendContract, OneTileIsThirtyFiveBitForBit) {
    for (const int subPixels : {1, 2}) {
        AnalyticScene scene = head(isReference() ? 41 : 149);
        scene.request.subPixels = subPixels;
        const auto plan = planOf(scene);
        const Picture whole = renderWhole(backend(), *plan);
        EXPECT_EQ(testing::unsoundPixels(whole), 0);
        EXPECT_GT(whole.pixel(whole.size().x / 2, whole.size().y / 2)[3], 0);
        EXPECT_TRUE(testing::sameBits(whole, testing::renderTiles(backend(), *plan, {7, 5})));
    }
}

TEST_P(BackendContract, OneThreadIsManyBitForBit) {
    const auto plan = planOf(head(isReference() ? 40 : 128));
    const Picture many = renderWhole(backend(), *plan);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_TRUE(testing::sameBits(many, renderWhole(backend(), *plan)));
}

TEST_P(BackendContract, SubPixelsAreBoxAverages) {
    AnalyticScene scene = head(24);
    scene.figure.layers.pop_back(); // a lit sphere's resolution follows the pixels'
    for (const int n : {2, 4}) {
        scene.request.size = glm::ivec2(24);
        scene.request.subPixels = n;
        const Picture averaged = renderWhole(backend(), scene);
        scene.request.size = glm::ivec2(24 * n);
        scene.request.subPixels = 1;
        const Picture fine = renderWhole(backend(), scene);
        for (int i = 0; i < 24 * 24; ++i) {
            for (int c = 0; c < 4; ++c) {
                double sum = 0;
                for (int sub = 0; sub < n * n; ++sub) {
                    sum += fine.pixel(i % 24 * n + sub % n, i / 24 * n + sub / n)[c];
                }
                EXPECT_NEAR(averaged.pixel(i % 24, i / 24)[c], sum / (n * n), rounding(2e-7, 2e-5));
            }
        }
    }
}

TEST_P(BackendContract, LayersCompositeInDrawingOrderAtEverySample) {
    // Two surfaces in one place: the first drawn wins; two translucent media add their depths.
    const accuracy::ConstantMedium medium;
    AnalyticScene scene = medium.scene(0.125);
    Layer second = scene.figure.layers.front();
    second.transfer.nodes.front().rgb = glm::dvec3(1, 0, 0);
    scene.figure.layers.push_back(second);
    const Picture both = renderWhole(backend(), scene);
    EXPECT_NEAR(both.pixel(0, 0)[3], accuracy::opacityOfMedium(2 * medium.extinctionPerMm, medium.lengthMm), 6e-6);
    for (Layer& layer : scene.figure.layers) {
        layer.transfer.opacity.front().y = 1;
    }
    const Picture surfaces = renderWhole(backend(), scene);
    EXPECT_EQ(surfaces.pixel(0, 0)[3], 1);
    EXPECT_EQ(surfaces.pixel(0, 0)[0], 0.5F);
    EXPECT_EQ(surfaces.pixel(0, 0)[1], 0.5F);
    scene.figure.layers.front().visible = false;
    EXPECT_EQ(renderWhole(backend(), scene).pixel(0, 0)[1], 0);
}

TEST_P(BackendContract, LayerOpacityMultipliesTheCurve) {
    const accuracy::ConstantMedium medium;
    AnalyticScene scene = medium.scene(0.125);
    scene.figure.layers.front().opacity = 0.5;
    const double curve = scene.figure.layers.front().transfer.opacity.front().y;
    EXPECT_NEAR(renderWhole(backend(), scene).pixel(0, 0)[3], 1 - std::pow(1 - 0.5 * curve, 8), 6e-6); // 8 voxels long
}

TEST_P(BackendContract, LeavingOutChangesNothing) {
    AnalyticScene scene = head(isReference() ? 32 : 128);
    const Picture lean = renderWhole(backend(), scene);
    scene.request.kept = KeptIn::allOf(LeaveOutEquality::sameBits);
    EXPECT_TRUE(testing::sameBits(lean, renderWhole(backend(), scene)));
    scene.request.omit = false;
    const double early = scene.figure.quality.earlyTermination;
    EXPECT_LE(testing::largestDifference(lean, renderWhole(backend(), scene)), early + 1e-5);
}

TEST_P(BackendContract, CountsItsSamples) {
    const auto plan = planOf(accuracy::ConstantMedium().scene(0.1));
    Task task;
    const RenderResult result = backend().render(*plan, {{0, 0}, plan->size}, task);
    EXPECT_EQ(result.samples, 40U); // ten on each of four rays
    EXPECT_EQ(result.shaded, 40U);
}

TEST_P(BackendContract, ACancelledRenderThrows) {
    const auto plan = planOf(head(512));
    Task task;
    task.cancel();
    try {
        backend().render(*plan, {{0, 0}, plan->size}, task);
        FAIL() << "a cancelled render gave a picture";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::cancelled);
    }
}

TEST_P(BackendContract, CancellingStopsARenderUnderWay) {
    AnalyticScene scene = head(2048);
    scene.request.lattice = SampleLattice{0.05, 0.5, 0}; // minutes of work
    const auto plan = planOf(scene);
    Task task;
    std::thread canceller([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        task.cancel();
    });
    EXPECT_THROW(backend().render(*plan, {{0, 0}, plan->size}, task), Error);
    canceller.join();
}

} // namespace
} // namespace limner
