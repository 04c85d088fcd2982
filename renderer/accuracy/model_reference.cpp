#include "renderer/accuracy/model_reference.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace limner::accuracy {

namespace {

constexpr std::array<double, 3> kSteps = {1.0 / 8, 1.0 / 16, 1.0 / 32}; // voxels
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

} // namespace

double ModelReference::errorBar(ErrorMetric metric) const { return bar.of(metric) + arithmetic.of(metric); }

ModelReference makeModelReference(const Figure& figure, const PlanRequest& request, const Probe& probe,
                                  const Backend& backend, const Backend* judge, Planner& planner, Task& task) {
    ModelReference reference;
    std::array<Picture, 3> searched;
    std::array<Picture, 3> heldOut;
    Figure fine = figure;
    fine.quality.earlyTermination = 0;
    for (std::size_t i = 0; i < kSteps.size(); ++i) {
        fine.quality.stepVoxels = kSteps[i];
        const auto plan = planner.plan(fine, request, task);
        searched[i] = drawProbe(*plan, probe.searched, backend, {}, task).picture;
        heldOut[i] = drawProbe(*plan, probe.heldOut, backend, {}, task).picture;
        task.progress((static_cast<double>(i) + 1) / 4);
        if (i == 0 && judge != nullptr) {
            std::vector<Tile> judged;
            for (std::size_t k = 0; k < probe.searched.size(); k += kJudgedShare) {
                judged.push_back(probe.searched[k]);
            }
            reference.arithmetic = measureError(backend.renderTiles(*plan, judged, task).picture,
                                                judge->renderTiles(*plan, judged, task).picture, backgroundOf(figure));
        }
    }
    const PictureError coarse = measureError(searched[0], searched[1], backgroundOf(figure));
    const PictureError last = measureError(searched[1], searched[2], backgroundOf(figure));
    if (coarse.notFinite + last.notFinite > 0) {
        throw Error(ErrorKind::notFinite,
                    {"the error cannot be measured", "", "the finest picture has pixels that are not finite numbers",
                     "`limner validate` says what in the figure is extreme"});
    }
    reference.order = last.rmse > 0 ? std::log2(coarse.rmse / last.rmse) : 0;
    reference.extrapolated = reference.order >= 1.7 && reference.order <= 2.3;
    reference.bar = scaled(last, reference.extrapolated ? 1.25 / 3 : 3);
    reference.searched = reference.extrapolated ? extrapolate(searched[2], searched[1]) : searched[2];
    reference.heldOut = reference.extrapolated ? extrapolate(heldOut[2], heldOut[1]) : heldOut[2];
    return reference;
}

} // namespace limner::accuracy
