#include "core/base/task.h"
#include "core/style/extraction/find.h"
#include "core/style/extraction/rim.h"
#include "core/style/extraction/round_candidates.h"
#include "core/style/extraction/round_scores.h"

#include <glm/geometric.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace limner {
namespace {

/// Longer side of what is looked at.
constexpr int kSide = 640;
/// Candidates that are looked at closely.
constexpr std::size_t kMostGuessed = 800;
constexpr std::size_t kMostLooked = 120;

/// Share of the smaller of two ovals that the larger covers.
double shared(const Oval& a, const Oval& b) {
    const bool first = a.radius() < b.radius();
    const Oval& smaller = first ? a : b;
    const Oval& larger = first ? b : a;
    int covered = 0;
    int all = 0;
    for (int y = -4; y <= 4; ++y) {
        for (int x = -4; x <= 4; ++x) {
            const glm::dvec2 p(x / 4.5, y / 4.5);
            if (glm::dot(p, p) <= 1) {
                const glm::dvec2 on = larger.toDisk(smaller.at(p));
                covered += glm::dot(on, on) <= 1 ? 1 : 0;
                ++all;
            }
        }
    }
    return covered / static_cast<double>(all);
}

struct Scored {
    Oval oval;
    double score = 0;
};

void sortByScore(std::vector<Scored>& ovals) {
    std::stable_sort(ovals.begin(), ovals.end(), [](const Scored& a, const Scored& b) { return a.score > b.score; });
}

template <typename Work>
void forEach(std::size_t count, const Work& work) {
    tbb::parallel_for(std::size_t{0}, count, work);
}

/// Moves and sizes an oval as long as that makes it likelier.
Scored climbed(Scored from, const RoundScores& scores) {
    constexpr int kMostSteps = 12;
    double step = 0.3;
    for (int i = 0; i < kMostSteps && step > 0.08; ++i) {
        Scored best = from;
        const double way = step * from.oval.radius();
        const auto attempt = [&](glm::dvec2 moved, double across, double down) {
            Oval oval = from.oval;
            oval.centre += moved * way;
            oval.xx *= across;
            oval.yy *= down;
            oval.xy *= std::sqrt(across * down);
            const double score = scores.guess(oval);
            if (score > best.score) {
                best = {oval, score};
            }
        };
        for (const glm::dvec2 direction : {glm::dvec2(1, 0), glm::dvec2(-1, 0), glm::dvec2(0, 1), glm::dvec2(0, -1)}) {
            attempt(direction, 1, 1);
            attempt(direction * 0.7, 1 + 0.7 * step, 1 + 0.7 * step);
        }
        attempt({0, 0}, 1 + step, 1 + step);
        attempt({0, 0}, 1 / (1 + step), 1 / (1 + step));
        attempt({0, 0}, 1 + step / 2, 1 / (1 + step / 2));
        attempt({0, 0}, 1 / (1 + step / 2), 1 + step / 2);
        if (best.score > 1.01 * from.score) {
            from = best;
        } else {
            step /= 2;
        }
    }
    return from;
}

/// The likeliest ones that lie apart, moved to where they are likelier still.
void addClimbed(std::vector<Scored>& candidates, const RoundScores& scores, const Task& task) {
    constexpr std::size_t kMostClimbed = 40;
    constexpr double kSame = 0.7;
    std::vector<Scored> starts;
    for (const Scored& one : candidates) {
        const bool known = std::any_of(starts.begin(), starts.end(), [&](const Scored& start) {
            return shared(start.oval, one.oval) > kSame &&
                   std::abs(std::log(start.oval.radius() / one.oval.radius())) < 0.3;
        });
        if (!known) {
            starts.push_back(one);
        }
        if (starts.size() == kMostClimbed) {
            break;
        }
    }
    forEach(starts.size(), [&](std::size_t i) {
        if (!task.cancelled()) {
            starts[i] = climbed(starts[i], scores);
        }
    });
    task.throwIfCancelled();
    candidates.insert(candidates.end(), starts.begin(), starts.end());
}

/// Each on its edge, where it has one, and as it is; best first.
std::vector<Scored> snapped(const std::vector<Scored>& candidates, const Tones& tones, const RoundScores& scores) {
    std::vector<Scored> both(2 * candidates.size());
    forEach(candidates.size(), [&](std::size_t i) {
        const Oval& oval = candidates[i].oval;
        if (const auto rim = followRim(tones, oval, {{0.15, 0.08}, 72})) {
            both[2 * i] = {rim->oval, scores.of(*rim)};
        }
        both[2 * i + 1] = {oval, scores.of(Rim{oval})};
    });
    sortByScore(both);
    return both;
}

} // namespace

std::vector<RoundThing> findRoundThings(const ArtCut& cut, Task& task, std::size_t most) {
    constexpr double kEverywhere = 1e9;
    const Tones tones = tonesOf(cut, glm::dvec2(-kEverywhere), glm::dvec2(kEverywhere), kSide);
    constexpr int kLeastSide = 16;
    if (std::min(tones.width, tones.height) < kLeastSide) {
        return {};
    }
    const RoundScores scores(tones);
    const std::vector<Oval> ovals = roundCandidates(tones, task, kMostGuessed);
    std::vector<Scored> candidates(ovals.size());
    forEach(ovals.size(), [&](std::size_t i) { candidates[i] = {ovals[i], scores.guess(ovals[i])}; });
    sortByScore(candidates);
    addClimbed(candidates, scores, task);
    sortByScore(candidates);
    candidates.resize(std::min(candidates.size(), kMostLooked));
    task.throwIfCancelled();
    const std::vector<Scored> scored = snapped(candidates, tones, scores);
    task.throwIfCancelled();
    constexpr double kLeastScore = 0.08;
    constexpr double kLeastOfBest = 0.25;
    const double least = scored.empty() ? 1 : std::max(kLeastScore, kLeastOfBest * scored.front().score);
    constexpr double kMuch = 0.4;
    std::vector<Scored> chosen;
    for (const Scored& one : scored) {
        if (chosen.size() == most || one.score < least) {
            break;
        }
        if (std::none_of(chosen.begin(), chosen.end(),
                         [&](const Scored& c) { return shared(c.oval, one.oval) > kMuch; })) {
            chosen.push_back(one);
        }
    }
    std::vector<RoundThing> things;
    for (const Scored& one : chosen) {
        things.push_back({ellipseOf(one.oval, tones), one.score});
    }
    return things;
}

} // namespace limner
