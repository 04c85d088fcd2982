#include "core/figure/light_frame.h"

#include "core/figure/camera_moves.h"

#include <glm/geometric.hpp>

namespace limner {

glm::dvec3 lightSeen(const Light& light, const Camera& camera) {
    const double length = glm::length(light.direction);
    if (!(length > 0)) {
        return {0, 0, 1};
    }
    const glm::dvec3 to = light.direction / length;
    if (light.kind != "object") {
        return to;
    }
    const CameraFrame frame = cameraFrame(camera);
    return {glm::dot(to, frame.right), glm::dot(to, frame.up), -glm::dot(to, frame.forward)};
}

Light lightToBeSeen(const std::string& kind, const glm::dvec3& seen, const Camera& camera) {
    const CameraFrame frame = cameraFrame(camera);
    const glm::dvec3 fixed = frame.right * seen.x + frame.up * seen.y - frame.forward * seen.z;
    return {kind, kind == "object" ? fixed : seen};
}

} // namespace limner
