// What marks of ink cost (paper 004, Table 1): preparation, frames of a turning view at the paper's loads, and stills.
#include "bench_scene.h"

#include "renderer/marks/draw_marks.h"
#include "renderer/marks/lay_marks.h"
#include "renderer/marks/mark_field.h"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cstdio>
#include <iostream>

namespace limner::bench {
namespace {

constexpr int kPixels = 512;

/// Ink alone on as many dots' breadths of paper as the picture has pixels: a dot is a pixel wide, as the paper's are.
Figure inkFigure(const Scene& scene) {
    Figure figure;
    figure.volume.emplace().data = scene.volume;
    const glm::dvec3 size = scene.volume->grid().sizeMm();
    figure.camera.targetMm = scene.volume->grid().centreMm();
    figure.camera.heightMm = 1.2 * std::max({size.x, size.y, size.z});
    figure.output.widthMm = figure.output.heightMm = 180;
    Stipple& stipple = figure.stipple.emplace();
    stipple.layerOpacity = "alone";
    stipple.sizeMm = 180.0 / kPixels;
    stipple.tone = "count";
    stipple.hidden = "show"; // all points there are
    return figure;
}

struct Frames {
    double drawMs = 0;
    double layMs = 0;
    std::size_t dots = 0;
    std::size_t strokes = 0;
};

/// Mean over `rounds` views a degree apart.
Frames turn(Figure figure, int rounds) {
    Planner planner;
    Task task;
    PlanRequest request;
    request.size = {kPixels, kPixels};
    request.moving = true;
    Frames frames;
    for (int i = -1; i < rounds; ++i) { // the first one prepares
        const double angle = glm::radians(30.0 + i);
        figure.camera.direction = {std::sin(angle), std::cos(angle), -0.25};
        const auto plan = planner.plan(figure, request, task);
        const Stopwatch drawing;
        const Marks marks = drawMarks(*plan, task);
        const double drawn = drawing.ms();
        Picture picture(request.size);
        const Stopwatch laying;
        layMarks(marks, request.size, {{0, 0}, request.size}, picture);
        if (i >= 0) {
            frames.drawMs += drawn / rounds;
            frames.layMs += laying.ms() / rounds;
            frames.dots = marks.dotCount();
            frames.strokes = marks.strokeCount();
        }
    }
    return frames;
}

void print(const char* what, const Frames& frames) {
    const double ms = frames.drawMs + frames.layMs;
    std::printf("%-34s %9zu dots %8zu segments  %7.1f ms (%.1f drawing, %.1f laying)  %6.1f frames/s\n", what,
                frames.dots, frames.strokes, ms, frames.drawMs, frames.layMs, 1000 / ms);
}

/// The figure with about so many dots.
Figure withDots(Figure figure, double wished) {
    figure.stipple->kMax = 1;
    for (int i = 0; i < 3; ++i) {
        const double have = std::max<double>(1, static_cast<double>(turn(figure, 1).dots));
        figure.stipple->kMax = std::min(figure.stipple->kMax * wished / have, 64.0);
    }
    return figure;
}

void prepare(const Figure& figure, bool moving) {
    Task task;
    Planner planner;
    PlanRequest request;
    request.size = {kPixels, kPixels};
    request.moving = moving;
    const auto plan = planner.plan(figure, request, task);
    const Stopwatch watch;
    const auto field = computeMarkField(*plan, {markZoom(*plan), moving}, task);
    const glm::ivec3 d = field->grid.dims;
    std::printf("preparation, %-6s %4d x %4d x %4d cells, %8zu with marks: %7.0f ms\n", moving ? "moving" : "still",
                d.x, d.y, d.z, field->voxels.size(), watch.ms());
}

int runAll(int argc, char** argv) {
    const int rounds = std::stoi(option(argc, argv, "rounds", "10"));
    const Scene scene = loadScene(option(argc, argv, "volume", ""));
    std::cout << kPixels << "^2; " << machineFacts() << "; " << rounds << " views a degree apart\n";
    Figure figure = inkFigure(scene);
    figure.stipple->curves.emplace();
    prepare(figure, true);
    prepare(figure, false);
    Figure dots = figure;
    dots.stipple->curves.reset();
    for (const double load : {5e3, 5e4, 5e5, 2e6}) {
        print("dots", turn(withDots(dots, load), rounds));
    }
    Figure both = withDots(dots, 2e6);
    // Everything that has a gradient is a curve: as many segments as there are voxels with marks.
    both.stipple->curves = StippleCurves{100, 1, 0, 0.2, "even", "none"};
    print("2 million dots and all segments", turn(both, rounds));
    dots.stipple->hidden = "remove";
    dots.stipple->tone = "ink";
    dots.stipple->lighting.emplace();
    print("lit, hidden dots removed", turn(dots, rounds));
    return 0;
}

} // namespace
} // namespace limner::bench

int main(int argc, char** argv) { return limner::bench::runBench(limner::bench::runAll, argc, argv); }
