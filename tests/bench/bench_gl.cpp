// The OpenGL backend: what a frame costs with styles and contours, what its shaders cost to make, and how far it is
// from the SIMD backend, side by side. Which library draws, and on what, is in the heading.
#include "bench_scene.h"

#include "core/base/error.h"
#include "renderer/gl/gl_backend.h"
#include "renderer/marks/draw_marks.h"
#include "renderer/marks/marked_picture.h"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>

namespace limner::bench {
namespace {

struct Row {
    std::string name;
    std::shared_ptr<const RenderPlan> plan;
    Times gl;
    Times cpu;
    double firstMs = 0; ///< shader compiled, data put on the card
    double rmse = 0;
};

std::shared_ptr<const RenderPlan> planOf(const Figure& figure, int size) {
    Planner planner;
    Task task;
    PlanRequest request;
    request.size = {size, size};
    return planner.plan(figure, request, task);
}

Figure withContours(Figure figure) {
    figure.layers.front().contours.emplace();
    return figure;
}

double timed(Row& row, const Backend& backend, Times* times, Picture* picture = nullptr) {
    Task task;
    const Stopwatch watch;
    RenderResult result = backend.render(*row.plan, Tile{{0, 0}, row.plan->size}, task);
    const double ms = watch.ms();
    if (times != nullptr) {
        times->add(watch);
    }
    if (picture != nullptr) {
        *picture = std::move(result.picture);
    }
    return ms;
}

/// Ink alone, a dot a pixel wide, seen by a moving view.
std::shared_ptr<const RenderPlan> inkPlan(Planner& planner, const Scene& scene, double kMax, double degrees) {
    constexpr int kPixels = 512;
    Figure figure = sceneFigure(scene, Shading::flat, 0.5);
    const double angle = glm::radians(degrees);
    figure.camera.projection = Projection::orthographic;
    const glm::dvec3 size = scene.volume->grid().sizeMm();
    figure.camera.heightMm = 1.2 * std::max({size.x, size.y, size.z});
    figure.camera.direction = {std::sin(angle), std::cos(angle), -0.25};
    figure.output.widthMm = figure.output.heightMm = 180;
    Stipple& stipple = figure.stipple.emplace();
    stipple.layerOpacity = "alone";
    stipple.sizeMm = 180.0 / kPixels;
    stipple.kMax = kMax;
    stipple.lighting.emplace();
    Task task;
    PlanRequest request;
    request.size = {kPixels, kPixels};
    request.moving = true;
    return planner.plan(figure, request, task);
}

/// Views a degree apart, each drawn by both.
void turnDots(const Backend& gl, const Backend& cpu, const Scene& scene, int rounds) {
    std::cout << "\nDots of a turning view, 512^2\n\n";
    printRow({"dots", "gl ms (min-max)", "processor ms", "first picture ms", "cpu ms (min-max)", "processor ms",
              "gl / cpu", "by processor"});
    printRow({"---", "---", "---", "---", "---", "---", "---", "---"});
    for (const double kMax : {0.05, 1.0}) {
        Planner planner;
        Times times[2];
        double firstMs = 0;
        std::size_t dots = 0;
        for (int round = -2; round < rounds; ++round) { // the first is the processor's, the second fills the card
            const auto plan = inkPlan(planner, scene, kMax, 30 + round);
            for (const bool card : {true, false}) {
                Task task;
                const Stopwatch watch;
                static_cast<void>(MarkedPicture(*plan, card ? gl : cpu, task).render({{0, 0}, plan->size}, task));
                if (round >= 0) {
                    times[card ? 0 : 1].add(watch);
                } else if (card) {
                    firstMs = watch.ms();
                }
            }
            Task task;
            dots = drawMarks(*plan, task).dotCount();
        }
        printRow({number(static_cast<double>(dots)), times[0].spread(), number(times[0].cpuMedian()), number(firstMs),
                  times[1].spread(), number(times[1].cpuMedian()), number(times[0].median() / times[1].median(), 2),
                  number(times[0].cpuMedian() / times[1].cpuMedian(), 2)});
    }
}

void run(const std::string& library, int rounds) {
    const auto gl = makeGlBackend(limner::gl::contextFactory(library));
    const auto cpu = makeCpuBackend();
    std::vector<Row> rows;
    const auto add = [&](const std::string& name, const Figure& figure, int size) {
        rows.push_back({name, planOf(figure, size), {}, {}, 0, 0});
    };
    const Scene scene = loadScene(std::filesystem::path(LIMNER_TEST_DATA) / "volumes/cthead_unc.nrrd");
    const Figure phong = sceneFigure(scene, Shading::phong, 0.5);
    const Figure style = sceneFigure(scene, Shading::style, 0.5);
    add("Phong, 512", phong, 512);
    add("lit spheres, 512", style, 512);
    add("lit spheres, contours, 512", withContours(style), 512);
    add("Phong, 256", phong, 256);
    for (Row& row : rows) {
        Picture drawn;
        Picture expected;
        row.firstMs = timed(row, *gl, nullptr, &drawn);
        timed(row, *cpu, nullptr, &expected);
        row.rmse = rmse(rgb8OverBlack(drawn), rgb8OverBlack(expected));
    }
    for (int round = 0; round < rounds; ++round) {
        for (Row& row : rows) {
            timed(row, *gl, &row.gl);
            timed(row, *cpu, &row.cpu);
        }
    }
    const auto facts = gl->facts();
    std::cout << "\nOpenGL by " << facts.library << ": " << facts.renderer << ", " << facts.version << "\n\n";
    printRow({"figure", "gl ms (min-max)", "processor ms", "first picture ms", "to Phong", "cpu ms (min-max)",
              "gl / cpu", "RMSE"});
    printRow({"---", "---", "---", "---", "---", "---", "---", "---"});
    for (const Row& row : rows) {
        printRow({row.name, row.gl.spread(), number(row.gl.cpuMedian(), 0), number(row.firstMs, 0),
                  number(row.gl.median() / rows.front().gl.median(), 2), row.cpu.spread(),
                  number(row.gl.median() / row.cpu.median(), 2), number(row.rmse, 6)});
    }
    turnDots(*gl, *cpu, scene, 2 * rounds);
}

} // namespace
} // namespace limner::bench

int main(int argc, char** argv) {
    using namespace limner::bench;
    std::cout << machineFacts() << '\n';
    const int rounds = argc > 2 ? std::atoi(argv[2]) : 5;
    try {
        run(argc > 1 ? argv[1] : "auto", rounds);
    } catch (const limner::Error& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
    return 0;
}
