#include "core/figure/view_frame.h"

#include "core/base/error.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>

namespace limner {

ViewFrame::ViewFrame(const Camera& camera, double aspect)
    : targetMm(camera.targetMm), heightMm(camera.heightMm), widthMm(camera.heightMm * aspect) {
    const glm::dvec3 across = glm::cross(camera.direction, camera.up);
    const double scale = glm::length(camera.direction) * glm::length(camera.up);
    constexpr double kParallel = 1e-9; // sine of the angle below which "up" says nothing
    if (!(glm::length(across) > kParallel * scale) || !(heightMm > 0) || !(aspect > 0)) {
        throw Error(ErrorKind::badInput, {"the camera has no view", "/camera", "direction and up are parallel or zero",
                                          "choose an up that is not along the direction"});
    }
    right = glm::normalize(across);
    forward = glm::normalize(camera.direction);
    up = glm::cross(right, forward);
    if (camera.projection == Projection::perspective) {
        eyeDistanceMm = 0.5 * heightMm / std::tan(glm::radians(0.5 * camera.fovDeg));
    }
}

glm::dvec3 ViewFrame::projectStep(const glm::dvec3& stepMm) const {
    const double w = eyeDistanceMm > 0 ? glm::dot(stepMm, forward) / eyeDistanceMm : 0;
    return {glm::dot(stepMm, right) / widthMm + 0.5 * w, -glm::dot(stepMm, up) / heightMm + 0.5 * w, w};
}

glm::dvec3 ViewFrame::project(const glm::dvec3& pointMm) const {
    return projectStep(pointMm - targetMm) + glm::dvec3(0.5, 0.5, 1);
}

} // namespace limner
