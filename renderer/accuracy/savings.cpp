#include "renderer/accuracy/savings.h"

#include "renderer/marks/marked_picture.h"

#include <glm/common.hpp>

#include <algorithm>
#include <chrono>
#include <limits>
#include <memory>
#include <numeric>

namespace limner::accuracy {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kLargest = 512;  ///< pixels an edge that are drawn
constexpr int kFewest = 2;     ///< rounds: the first of them warms caches and compiles shaders
constexpr int kMost = 7;       ///< more make the least time no better
constexpr double kSeconds = 4; ///< after which no further round begins

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// The plan's own and the scan, as far as rays sample it.
std::uint64_t heldBytes(const RenderPlan& plan) {
    const bool counted = plan.volume != plan.figure->volume->data;
    const bool sampled = plan.field == plan.volume || plan.gradientField == plan.volume;
    const std::uint64_t voxels = plan.volume->bytes();
    return plan.bytes + (sampled ? voxels : 0) - (counted ? voxels : 0);
}

/// A plan and the least time that its picture took.
struct Variant {
    std::shared_ptr<const RenderPlan> plan;
    double ms = std::numeric_limits<double>::infinity();

    void draw(const Backend& backend, const Tile& tile, Task& task) {
        const auto start = Clock::now();
        static_cast<void>(MarkedPicture(*plan, backend, task).render(tile, task));
        ms = std::min(ms, 1000 * secondsSince(start));
    }
};

} // namespace

double Savings::sumMs() const {
    return std::accumulate(rules.begin(), rules.end(), 0.0, [](double sum, const Saving& s) { return sum + s.ms; });
}

std::int64_t Savings::sumBytes() const {
    return std::accumulate(rules.begin(), rules.end(), std::int64_t{0},
                           [](std::int64_t sum, const Saving& s) { return sum + s.bytes; });
}

Savings measureSavings(const Figure& figure, const Backend& backend, const PlanRequest& request, Task& task) {
    Planner planner;
    const auto planKeeping = [&](const KeptIn& kept) {
        PlanRequest one = request;
        one.omit = true;
        one.kept = kept;
        return Variant{planner.plan(figure, one, task)};
    };
    task.beginPhase("Planning");
    std::vector<Variant> variants{planKeeping({})};
    const RenderPlan& lean = *variants.front().plan;
    for (const LeftOut& out : lean.leftOut) {
        variants.push_back(planKeeping({out.rule}));
    }
    variants.push_back(planKeeping(KeptIn::everything()));

    task.beginPhase("Measuring");
    Savings savings;
    savings.backend = backend.name();
    savings.pixels = glm::min(lean.size, glm::ivec2(kLargest));
    const Tile tile{(lean.size - savings.pixels) / 2, savings.pixels};
    const auto start = Clock::now();
    while (savings.rounds < kFewest || (savings.rounds < kMost && secondsSince(start) < kSeconds)) {
        for (Variant& variant : variants) {
            task.throwIfCancelled();
            variant.draw(backend, tile, task);
        }
        task.progress(static_cast<double>(++savings.rounds) / kMost);
    }
    savings.ms = variants.front().ms;
    savings.bytes = heldBytes(lean);
    for (std::size_t i = 0; i < lean.leftOut.size(); ++i) {
        const Variant& kept = variants[i + 1];
        savings.rules.push_back(
            {lean.leftOut[i], kept.ms, kept.ms - savings.ms,
             static_cast<std::int64_t>(heldBytes(*kept.plan)) - static_cast<std::int64_t>(savings.bytes)});
    }
    savings.keptMs = variants.back().ms;
    savings.keptBytes = heldBytes(*variants.back().plan);
    return savings;
}

} // namespace limner::accuracy
