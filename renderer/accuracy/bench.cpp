#include "renderer/accuracy/line_error.h"
#include "renderer/accuracy/tolerance.h"

#include <algorithm>

namespace limner::accuracy {

namespace {

glm::dvec3 backgroundOf(const Figure& figure) { return glm::dvec3(figure.background.rgba); }

/// A figure that may use every knob, to see which of them the planner takes.
Figure atItsBest(const Figure& figure) {
    Figure best = figure;
    best.quality.preintegration = true;
    best.quality.precision = VoxelPrecision::full;
    best.quality.earlyTermination = 0;
    return best;
}

} // namespace

Bench::Bench(Figure figure, PlanRequest request, const Backend& backend, Task& task)
    : figure_(std::move(figure)), request_(request), backend_(backend), task_(task) {
    const auto plan = planner_.plan(atItsBest(figure_), request_, task_);
    size_ = plan->size;
    knobs_ = knobsOf(figure_.quality, *plan);
    limitWith_ = stepLimit(*plan, true);
    limitWithout_ = stepLimit(*plan, false);
    probe_ = chooseProbe(figure_, *plan, backend_, planner_, task_);
}

void Bench::makeReference(const Tolerance& tolerance, const Backend* judge) {
    Figure best = figure_;
    best.quality = bestQuality(figure_.quality, knobs_);
    reference_ = makeModelReference(best, request_, probe_, {tolerance.metric, tolerance.value * kBarShare}, backend_,
                                    judge, planner_, task_);
}

std::shared_ptr<const RenderPlan> Bench::planOf(const Quality& quality) {
    Figure figure = figure_;
    figure.quality = quality;
    return planner_.plan(figure, request_, task_);
}

const Measured& Bench::measure(const Quality& quality) {
    for (const auto& known : measured_) {
        if (known->quality == quality) {
            return *known;
        }
    }
    const ProbePicture drawn = drawProbe(*planOf(quality), probe_.searched, backend_, repeats, task_);
    measured_.push_back(std::make_unique<Measured>(
        Measured{quality, measureError(drawn.picture, reference_.searched, backgroundOf(figure_)), drawn.seconds,
                 drawn.median, drawn.spread, drawn.samples}));
    return *measured_.back();
}

PictureError Bench::verify(const Quality& quality) {
    return measureError(drawProbe(*planOf(quality), probe_.heldOut, backend_, {}, task_).picture, reference_.heldOut,
                        backgroundOf(figure_));
}

Picture Bench::draw(const Quality& quality) {
    const auto plan = planOf(quality);
    return drawProbe(*plan, {{{0, 0}, plan->size}}, backend_, {}, task_).picture;
}

ProbePicture Bench::whole(const Quality& quality) {
    const auto plan = planOf(quality);
    return drawProbe(*plan, {{{0, 0}, plan->size}}, backend_, {2, 0.3}, task_);
}

bool Bench::hasLines() const {
    return std::any_of(figure_.layers.begin(), figure_.layers.end(),
                       [](const Layer& layer) { return layer.contours || layer.silhouette; });
}

std::vector<bool> Bench::linesOf(const Quality& quality, const Picture& picture) {
    Figure bare = figure_;
    bare.quality = quality;
    for (Layer& layer : bare.layers) {
        layer.contours.reset();
        layer.silhouette.reset();
    }
    const auto plan = planner_.plan(bare, request_, task_);
    return lineMask(picture, backend_.render(*plan, {{0, 0}, plan->size}, task_).picture);
}

} // namespace limner::accuracy
