#include "renderer/accuracy/probe.h"

#include <glm/common.hpp>

#include <algorithm>
#include <chrono>
#include <random>

namespace limner::accuracy {

namespace {

constexpr int kStrata = 8;      // an axis
constexpr int kExtraShare = 10; // one tile where the picture varies for so many others
/// Tiles begin where the ray casters' blocks do, so that a tile costs what its own rays cost, where the picture is
/// large enough for as many.
constexpr int kBlock = 32;
constexpr int kDraft = 128; // pixels of the small picture's longer edge

/// Variance of the pixels around, over all channels, of the small picture.
double varianceAt(const Picture& draft, glm::ivec2 low, glm::ivec2 high) {
    double variance = 0;
    for (int channel = 0; channel < 4; ++channel) {
        double sum = 0;
        double squares = 0;
        for (int y = low.y; y < high.y; ++y) {
            for (int x = low.x; x < high.x; ++x) {
                const double v = draft.pixel(x, y)[channel];
                sum += v;
                squares += v * v;
            }
        }
        const double count = static_cast<double>(high.x - low.x) * (high.y - low.y);
        variance += squares / count - (sum / count) * (sum / count);
    }
    return variance;
}

/// Where tiles may begin, and how varied the picture is there.
struct Candidate {
    Tile tile;
    int stratum = 0;
    double variance = 0;
};

std::vector<Candidate> candidatesOf(glm::ivec2 size, const Picture& draft) {
    std::vector<Candidate> all;
    const int spacing =
        std::clamp(std::min(size.x, size.y) / kStrata / Probe::kEdge * Probe::kEdge, Probe::kEdge, kBlock);
    const glm::ivec2 strata = glm::clamp((size + spacing - 1) / spacing, 1, kStrata);
    const glm::dvec2 perPixel = glm::dvec2(draft.size()) / glm::dvec2(size);
    for (int y = 0; y < size.y; y += spacing) {
        for (int x = 0; x < size.x; x += spacing) {
            Candidate c;
            c.tile = {{x, y}, glm::min(glm::ivec2(Probe::kEdge), size - glm::ivec2(x, y))};
            const glm::ivec2 low = glm::min(glm::ivec2(glm::dvec2(x, y) * perPixel), draft.size() - 1);
            const glm::ivec2 high = glm::clamp(
                glm::ivec2(glm::ceil(glm::dvec2(c.tile.origin + c.tile.size) * perPixel)) + 1, low + 1, draft.size());
            c.variance = varianceAt(draft, low, high);
            c.stratum = y * strata.y / size.y * strata.x + x * strata.x / size.x;
            all.push_back(c);
        }
    }
    return all;
}

} // namespace

double Probe::pixels() const {
    double sum = 0;
    for (const auto* tiles : {&searched, &heldOut}) {
        for (const Tile& tile : *tiles) {
            sum += static_cast<double>(tile.size.x) * tile.size.y;
        }
    }
    return sum;
}

Probe chooseProbe(const Figure& figure, const RenderPlan& plan, const Backend& backend, Planner& planner, Task& task) {
    PlanRequest request;
    const double scale = std::min(1.0, static_cast<double>(kDraft) / std::max(plan.size.x, plan.size.y));
    request.size = glm::max(glm::ivec2(glm::round(glm::dvec2(plan.size) * scale)), 1);
    request.subPixels = 1;
    const auto draftPlan = planner.plan(figure, request, task);
    const Picture draft = backend.render(*draftPlan, {{0, 0}, draftPlan->size}, task).picture;
    std::vector<Candidate> candidates = candidatesOf(plan.size, draft);
    std::mt19937 random(2007); // the same places every time
    std::shuffle(candidates.begin(), candidates.end(), random);
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.stratum < b.stratum; });
    std::vector<Candidate> chosen;
    std::vector<Candidate> rest;
    for (const Candidate& c : candidates) {
        (chosen.empty() || chosen.back().stratum != c.stratum ? chosen : rest).push_back(c);
    }
    std::stable_sort(rest.begin(), rest.end(),
                     [](const Candidate& a, const Candidate& b) { return a.variance > b.variance; });
    rest.resize(std::min(rest.size(), (chosen.size() + kExtraShare - 1) / kExtraShare));
    chosen.insert(chosen.end(), rest.begin(), rest.end());
    Probe probe;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        // Neighbours along a row of strata take turns, and rows begin with the other one.
        const bool held = (i + i / kStrata) % 2 == 1;
        (held ? probe.heldOut : probe.searched).push_back(chosen[i].tile);
    }
    if (probe.heldOut.empty()) {
        probe.heldOut = probe.searched; // a picture of one tile
    }
    return probe;
}

ProbePicture drawProbe(const RenderPlan& plan, const std::vector<Tile>& tiles, const Backend& backend,
                       const Repeats& repeats, Task& task) {
    using Clock = std::chrono::steady_clock;
    RenderResult result = backend.renderTiles(plan, tiles, task);
    ProbePicture out{std::move(result.picture), 0, 0, 0, result.samples};
    std::vector<double> times;
    const auto start = Clock::now();
    const auto since = [](Clock::time_point from) {
        return std::chrono::duration<double>(Clock::now() - from).count();
    };
    for (int i = 0; i < repeats.most && (i == 0 || since(start) < repeats.seconds); ++i) {
        const auto begin = Clock::now();
        backend.renderTiles(plan, tiles, task);
        times.push_back(since(begin));
    }
    if (!times.empty()) {
        std::sort(times.begin(), times.end());
        out.seconds = times.front();
        out.median = times[times.size() / 2];
        out.spread = times[times.size() * 3 / 4] - times[times.size() / 4];
    }
    return out;
}

} // namespace limner::accuracy
