#include "widgets/measure_pictures.h"

#include "renderer/backend.h"
#include "renderer/export/picture_file.h"
#include "renderer/plan/planner.h"

namespace limner {
namespace {

struct Measure {
    const char* pointer;
    double ImportanceWeights::*weight;
    double strength; ///< brings its matter forward without hiding all else
};
constexpr Measure kMeasures[] = {
    {"/importance/weights/intensity", &ImportanceWeights::intensity, 6},
    {"/importance/weights/extinction", &ImportanceWeights::extinction, 3},
    {"/importance/weights/gradient", &ImportanceWeights::gradient, 6},
    {"/importance/weights/silhouette", &ImportanceWeights::silhouette, 6},
    {"/importance/weights/unocclusion", &ImportanceWeights::unocclusion, 0.3},
    {"/importance/weights/lighting", &ImportanceWeights::lighting, 2},
    {"/importance/weights/object", &ImportanceWeights::object, 6},
    {"/importance/weights/statistics", &ImportanceWeights::statistics, 6},
};

bool needsFieldOfItsOwn(const Measure& measure, const RenderPlan& shown) {
    if (measure.weight == &ImportanceWeights::object) {
        return !shown.labels || !shown.figure->importance || shown.figure->importance->objects.empty();
    }
    return measure.weight == &ImportanceWeights::statistics &&
           !(shown.figure->importance && shown.figure->importance->weights.statistics > 0);
}

/// The shown figure as cheap as it still shows what matters: its volume is cleaned up already.
Figure plainCopy(const RenderPlan& shown) {
    Figure figure = *shown.figure;
    figure.volume->data = shown.volume;
    figure.cleanup.clear();
    figure.quality.gradient = GradientEstimator::central;
    figure.quality.interpolation = Interpolation::linear;
    figure.quality.stepVoxels = 1;
    if (!figure.importance) {
        figure.importance.emplace();
    }
    figure.importance->global = 1;
    figure.importance->background = 0;
    figure.importance->lenses.clear();
    return figure;
}

QImage imageOf(const Picture& picture, const Figure& figure) {
    const std::vector<std::uint8_t> rgba = toRgba8(picture, pictureOptions(figure));
    const glm::ivec2 size = picture.size();
    return QImage(rgba.data(), size.x, size.y, 4 * size.x, QImage::Format_RGBA8888).copy(); // the bytes are ours
}

} // namespace

std::vector<std::pair<std::string, QImage>> measurePictures(const RenderPlan& shown, int edgePixels, Task& task) {
    Figure figure = plainCopy(shown);
    Planner planner;
    PlanRequest request;
    request.size = {edgePixels, edgePixels};
    request.subPixels = 2;
    const auto backend = makeCpuBackend();
    std::vector<std::pair<std::string, QImage>> pictures;
    for (const Measure& measure : kMeasures) {
        if (needsFieldOfItsOwn(measure, shown)) {
            continue;
        }
        figure.importance->weights = {};
        figure.importance->weights.*measure.weight = measure.strength;
        const auto plan = planner.plan(figure, request, task);
        const Picture picture = backend->render(*plan, {{0, 0}, request.size}, task).picture;
        pictures.emplace_back(measure.pointer, imageOf(picture, figure));
    }
    return pictures;
}

} // namespace limner
