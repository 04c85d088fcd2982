#include "core/figure/camera_angles.h"

#include "core/figure/camera_moves.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace limner {
namespace {

/// -180 for a negative zero would be a surprise.
double angleOf(double across, double along) { return std::atan2(across + 0.0, along); }

constexpr double kPole = 1e-6; // cosine of a tilt this near 90 degrees: turn and roll cannot be told apart

/// From the target to a viewer, and what is up for one whose picture does not roll.
struct Stand {
    glm::dvec3 outward;
    glm::dvec3 up;
};

Stand standAt(double turn, double tilt) {
    const glm::dvec3 level(std::sin(turn), -std::cos(turn), 0);
    const glm::dvec3 above(0, 0, 1);
    return {level * std::cos(tilt) + above * std::sin(tilt), above * std::cos(tilt) - level * std::sin(tilt)};
}

} // namespace

ViewAngles viewAngles(const Camera& camera) {
    const CameraFrame frame = cameraFrame(camera);
    const glm::dvec3 outward = -frame.forward;
    const double tilt = std::asin(std::clamp(outward.z, -1.0, 1.0));
    if (std::hypot(outward.x, outward.y) < kPole) {
        const glm::dvec3 level = outward.z > 0 ? -frame.up : frame.up;
        return {glm::degrees(angleOf(level.x, -level.y)), glm::degrees(tilt), 0};
    }
    const double turn = angleOf(outward.x, -outward.y);
    const Stand stand = standAt(turn, tilt);
    const glm::dvec3 left = glm::cross(stand.up, frame.forward);
    const double roll = std::atan2(glm::dot(frame.up, left), glm::dot(frame.up, stand.up));
    return {glm::degrees(turn), glm::degrees(tilt), glm::degrees(roll)};
}

Camera withViewAngles(const Camera& camera, const ViewAngles& angles) {
    const double tilt = glm::radians(std::clamp(angles.tiltDeg, -90.0, 90.0));
    const double roll = glm::radians(angles.rollDeg);
    const Stand stand = standAt(glm::radians(angles.turnDeg), tilt);
    const glm::dvec3 left = glm::cross(stand.up, -stand.outward);
    Camera result = camera;
    result.direction = -stand.outward;
    result.up = stand.up * std::cos(roll) + left * std::sin(roll);
    return result;
}

} // namespace limner
