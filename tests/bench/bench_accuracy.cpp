// What the search for a tolerance delivers (spec accuracy.md 1.9): for figures of every technique the error that it
// promises, the error of the whole picture, and its time beside the best setting that trying all of them finds.
//   bench_accuracy FIGURE...
#include "core/base/error.h"
#include "core/project/project.h"
#include "core/project/sample_figures.h"
#include "renderer/accuracy/tolerance.h"

#include <chrono>
#include <cstdio>

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

int runBench(int count, char** ids) {
    const auto backend = makeCpuBackend();
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
