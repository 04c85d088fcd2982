#include "app/studio/qt_context.h"

#include "core/base/error.h"
#include "core/figure/figure.h"
#include "core/volume/phantom.h"
#include "renderer/gl/gl_backend.h"
#include "renderer/plan/planner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <thread>

// A context by Qt draws what the processor draws, on the interface's thread and on another.

namespace limner {
namespace {

std::shared_ptr<const RenderPlan> headPlan() {
    Figure figure;
    figure.volume.emplace();
    figure.volume->data = makeHeadPhantom(32);
    Layer& layer = figure.layers.emplace_back();
    layer.shading = Shading::phong;
    const ValueRange range = figure.volume->data->range();
    layer.transfer.nodes = {{range.low, "", glm::dvec3(0.9, 0.8, 0.6)}};
    layer.transfer.opacity = {{range.low, 0}, {range.high, 1}};
    figure.camera.targetMm = figure.volume->data->grid().centreMm();
    Task task;
    PlanRequest request;
    request.size = {40, 40};
    return Planner().plan(figure, request, task);
}

double distance(const Picture& a, const Picture& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.rgba().size(); ++i)
        sum += std::pow(static_cast<double>(a.rgba()[i]) - b.rgba()[i], 2);
    return std::sqrt(sum / static_cast<double>(a.rgba().size()));
}

TEST(QtContexts, DrawTheProcessorsPictureOnAnyThread) {
    std::unique_ptr<GlBackend> gl;
    try {
        gl = makeGlBackend(qtContexts());
    } catch (const Error& error) {
        GTEST_SKIP() << error.what();
    }
    EXPECT_EQ(gl->facts().library, "qt");
    std::cout << gl->facts().renderer << '\n';
    const auto plan = headPlan();
    Task task;
    const Tile whole{{0, 0}, plan->size};
    const Picture expected = makeCpuBackend()->render(*plan, whole, task).picture;
    EXPECT_GT(distance(expected, Picture(plan->size)), 0.05) << "the picture is all but empty";
    EXPECT_LT(distance(gl->render(*plan, whole, task).picture, expected), 0.002);
    Picture other;
    std::thread thread([&] { other = gl->render(*plan, whole, task).picture; });
    thread.join();
    EXPECT_LT(distance(other, expected), 0.002);
}

} // namespace
} // namespace limner
