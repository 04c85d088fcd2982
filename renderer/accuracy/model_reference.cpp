#include "renderer/accuracy/model_reference.h"

#include "core/base/error.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace limner::accuracy {

namespace {

constexpr double kCoarsest = 1.0 / 8; // voxels
constexpr double kFinest = 1.0 / 256;
constexpr std::size_t kJudgedShare = 16;

PictureError scaled(PictureError error, double factor) {
    for (double* part :
         {&error.rmse, &error.largest, &error.most999, &error.meanColour, &error.p95Colour, &error.largestColour}) {
        *part *= factor;
    }
    return error;
}

/// (4 fine - coarse) / 3: the next order of a quadratic error.
Picture extrapolate(const Picture& fine, const Picture& coarse) {
    Picture out = fine;
    for (std::size_t i = 0; i < out.rgba().size(); ++i) {
        out.rgba()[i] += (fine.rgba()[i] - coarse.rgba()[i]) / 3;
    }
    return out;
}

glm::dvec3 backgroundOf(const Figure& figure) { return glm::dvec3(figure.background.rgba); }

/// Both halves of the probe at one step.
struct Level {
    Picture searched;
    Picture heldOut;
};

PictureError judgeTiles(const RenderPlan& plan, const Probe& probe, const Backend& backend, const Backend& judge,
                        Task& task) {
    std::vector<Tile> judged;
    for (std::size_t k = 0; k < probe.searched.size(); k += kJudgedShare) {
        judged.push_back(probe.searched[k]);
    }
    return measureError(backend.renderTiles(plan, judged, task).picture, judge.renderTiles(plan, judged, task).picture,
                        backgroundOf(*plan.figure));
}

/// The reference of three successive steps, the finest last, with its bar.
void finish(ModelReference& reference, const Level* three, const glm::dvec3& background) {
    const PictureError coarse = measureError(three[0].searched, three[1].searched, background);
    const PictureError last = measureError(three[1].searched, three[2].searched, background);
    if (coarse.notFinite + last.notFinite > 0) {
        throw Error(ErrorKind::notFinite,
                    {"the error cannot be measured", "", "the finest picture has pixels that are not finite numbers",
                     "`limner validate` says what in the figure is extreme"});
    }
    reference.order = last.rmse > 0 ? std::log2(coarse.rmse / last.rmse) : 0;
    reference.extrapolated = reference.order >= 1.7 && reference.order <= 2.3;
    reference.bar = scaled(last, reference.extrapolated ? 1.25 / 3 : 3);
    reference.searched = reference.extrapolated ? extrapolate(three[2].searched, three[1].searched) : three[2].searched;
    reference.heldOut = reference.extrapolated ? extrapolate(three[2].heldOut, three[1].heldOut) : three[2].heldOut;
}

} // namespace

double ModelReference::errorBar(ErrorMetric metric) const { return bar.of(metric) + arithmetic.of(metric); }

ModelReference makeModelReference(const Figure& figure, const PlanRequest& request, const Probe& probe,
                                  const WantedBar& wanted, const Backend& backend, const Backend* judge,
                                  Planner& planner, Task& task) {
    ModelReference reference;
    std::vector<Level> levels;
    for (double step = kCoarsest; step >= kFinest; step /= 2) {
        Figure fine = figure;
        fine.quality.earlyTermination = 0;
        fine.quality.stepVoxels = step;
        const auto plan = planner.plan(fine, request, task);
        levels.push_back({drawProbe(*plan, probe.searched, backend, {}, task).picture,
                          drawProbe(*plan, probe.heldOut, backend, {}, task).picture});
        reference.step = step;
        if (levels.size() == 1 && judge != nullptr) {
            reference.arithmetic = judgeTiles(*plan, probe, backend, *judge, task);
        }
        if (levels.size() >= 3) {
            finish(reference, levels.data() + levels.size() - 3, backgroundOf(figure));
            if (reference.errorBar(wanted.metric) <= wanted.value) {
                break;
            }
        }
    }
    return reference;
}

} // namespace limner::accuracy
