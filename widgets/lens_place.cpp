#include "widgets/lens_place.h"

#include "core/figure/camera_moves.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace limner {
namespace {

/// Distance of the eye from the plane of the target, mm.
double eyeDistanceMm(const Camera& camera) { return camera.heightMm / 2 / std::tan(glm::radians(camera.fovDeg) / 2); }

glm::dvec3 anchorAt(const Figure& figure, const glm::dvec2& place) {
    const CameraFrame frame = cameraFrame(figure.camera);
    const glm::dvec2 offset = (place - glm::dvec2(sheetAspect(figure), 1) / 2.0) * figure.camera.heightMm;
    return figure.camera.targetMm + frame.right * offset.x - frame.up * offset.y;
}

} // namespace

double sheetAspect(const Figure& figure) { return figure.output.widthMm / std::max(figure.output.heightMm, 1e-6); }

std::optional<glm::dvec2> lensOnSheet(const Figure& figure, const Lens& lens) {
    const double aspect = sheetAspect(figure);
    if (!lens.anchorMm)
        return glm::dvec2(lens.center.x * aspect, lens.center.y);
    const Camera& camera = figure.camera;
    const CameraFrame frame = cameraFrame(camera);
    const glm::dvec3 from = *lens.anchorMm - camera.targetMm;
    double shrink = 1;
    if (camera.projection == Projection::perspective) {
        const double eye = eyeDistanceMm(camera);
        const double depth = eye + glm::dot(from, frame.forward);
        if (depth <= 0)
            return std::nullopt;
        shrink = eye / depth;
    }
    const glm::dvec2 offset(glm::dot(from, frame.right), -glm::dot(from, frame.up));
    return glm::dvec2(aspect, 1) / 2.0 + offset * (shrink / camera.heightMm);
}

Lens lensMovedTo(const Figure& figure, Lens lens, const glm::dvec2& place) {
    lens.center = {place.x / sheetAspect(figure), place.y};
    if (lens.anchorMm)
        lens.anchorMm = anchorAt(figure, place);
    return lens;
}

Lens lensFollowing(const Figure& figure, Lens lens, bool follows) {
    const auto place = lensOnSheet(figure, lens);
    lens.anchorMm.reset();
    if (place)
        lens = lensMovedTo(figure, lens, *place);
    if (follows && place)
        lens.anchorMm = anchorAt(figure, *place);
    return lens;
}

} // namespace limner
