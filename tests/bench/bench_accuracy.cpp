// What the search for a tolerance delivers (spec accuracy.md 1.9): for figures of every technique the error that it
// promises, the error of the whole picture, and its time beside the best setting that trying all of them finds.
//   bench_accuracy FIGURE...
// And what better reconstruction gains against the field itself (1.7), and costs:
//   bench_accuracy --gain
#include "core/base/error.h"
#include "core/project/project.h"
#include "core/project/sample_figures.h"
#include "renderer/accuracy/picture_error.h"
#include "renderer/accuracy/signal_peak.h"
#include "renderer/accuracy/tolerance.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>

namespace limner::accuracy {
namespace {

constexpr int kSize = 512;

/// The cheapest of all settings of the searched knobs that keeps the bound the search keeps.
double exhaustive(Bench& bench, const Tolerance& tolerance, const ToleranceChoice& found) {
    std::vector<Quality> all = {bench.best()};
    for (const KnobLevels& knob : bench.knobs()) {
        std::vector<Quality> next;
        for (std::size_t level = 0; knob.searched && level < knob.levels.size(); ++level) {
            for (const Quality& quality : all) {
                next.push_back(withLevel(quality, knob, level));
            }
        }
        all = knob.searched ? next : all;
    }
    double least = found.probeSeconds;
    for (const Quality& quality : all) {
        if (quality.stepVoxels > bench.limit(quality.preintegration).voxels || quality.stepVoxels < 0.1) {
            continue; // the finest steps are the dearest: never the cheapest that keeps a tolerance of these
        }
        const Measured& measured = bench.measure(quality);
        if (measured.error.of(tolerance.metric) <= tolerance.value) {
            least = std::min(least, measured.seconds);
        }
    }
    return least;
}

void tryFigure(const std::string& id, const SampleFigure& sample, const Backend& backend) {
    Task task;
    OpenOptions open;
    open.sample = id;
    const Document document = openDocument(findSampleScan(sample), open, task);
    PlanRequest request;
    const glm::dvec2 size(document.figure.output.sizePixels());
    request.size = glm::ivec2(size * (kSize / std::max(size.x, size.y)));
    for (const NamedTolerance& named : namedTolerances()) {
        if (named.tolerance.metric != ErrorMetric::ciede2000) {
            continue;
        }
        const auto start = std::chrono::steady_clock::now();
        Bench fresh(document.figure, request, backend, task);
        fresh.makeReference(named.tolerance, nullptr);
        std::printf("%-26s %-7s ", id.c_str(), named.name);
        try {
            const ToleranceChoice choice = chooseQuality(fresh, named.tolerance);
            const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            const double least = exhaustive(fresh, named.tolerance, choice);
            std::printf("asked %.2f delivered %.3f %s  time / best of all %.2f  answer in %.2f s  %s\n",
                        named.tolerance.value, choice.heldOutError, choice.reached ? "kept" : "NOT KEPT",
                        choice.probeSeconds / least, seconds, choice.words.c_str());
        } catch (const Error& error) {
            std::printf("%s\n", error.text().why.c_str());
        }
        std::fflush(stdout);
    }
}

struct Reconstruction {
    const char* name;
    Interpolation interpolation;
    GradientEstimator gradient;
};
constexpr Reconstruction kReconstructions[] = {
    {"linear, central", Interpolation::linear, GradientEstimator::central},
    {"linear, 4th order", Interpolation::linear, GradientEstimator::fourthOrder},
    {"linear, B-spline", Interpolation::linear, GradientEstimator::bspline},
    {"tricubic, central", Interpolation::tricubic, GradientEstimator::central},
    {"tricubic, 4th order", Interpolation::tricubic, GradientEstimator::fourthOrder},
    {"tricubic, B-spline", Interpolation::tricubic, GradientEstimator::bspline},
};

/// Errors against the truth, and times in turn: least of the rounds, to those of the first row.
void tabulateGain(const Backend& backend) {
    constexpr int pixels = 192;
    constexpr int rounds = 5;
    std::printf("A6 with a peak, 64^3, %d^2, step 0.125: RMSE to the field itself, by the first row's; time to it\n",
                pixels);
    for (const double width : {0.1, 0.02, 0.005}) {
        SignalPeak peak;
        peak.width = width;
        const Picture truth = peak.truth(pixels, 2048);
        std::vector<double> errors;
        std::vector<double> seconds(std::size(kReconstructions), 1e9);
        Planner planner;
        Task task;
        std::vector<std::shared_ptr<const RenderPlan>> plans;
        for (const Reconstruction& way : kReconstructions) {
            const AnalyticScene scene = peak.scene(way.interpolation, way.gradient, 0.125, pixels);
            plans.push_back(planner.plan(scene.figure, scene.request, task));
            const Picture picture = backend.render(*plans.back(), Tile{{0, 0}, glm::ivec2(pixels)}, task).picture;
            errors.push_back(measureError(picture, truth, glm::dvec3(0)).rmse);
        }
        for (int round = 0; round < rounds; ++round) {
            for (std::size_t i = 0; i < plans.size(); ++i) {
                const auto start = std::chrono::steady_clock::now();
                (void)backend.render(*plans[i], Tile{{0, 0}, glm::ivec2(pixels)}, task);
                const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
                seconds[i] = std::min(seconds[i], took.count());
            }
        }
        for (std::size_t i = 0; i < plans.size(); ++i) {
            std::printf("width %.3f  %-20s %.2e  %5.1f times less  %.2f times the time\n", width,
                        kReconstructions[i].name, errors[i], errors[0] / errors[i], seconds[i] / seconds[0]);
        }
    }
}

int runBench(int count, char** ids) {
    const auto backend = makeCpuBackend();
    if (count == 1 && std::strcmp(ids[0], "--gain") == 0) {
        tabulateGain(*backend);
        return 0;
    }
    for (const SampleFigure& sample : sampleFigures()) {
        for (int i = 0; i < count; ++i) {
            if (sample.id == ids[i] && !findSampleScan(sample).empty()) {
                tryFigure(sample.id, sample, *backend);
            }
        }
    }
    return 0;
}

} // namespace
} // namespace limner::accuracy

int main(int count, char** arguments) { return limner::accuracy::runBench(count - 1, arguments + 1); }
