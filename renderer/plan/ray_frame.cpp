#include "renderer/plan/ray_frame.h"

#include "core/base/error.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>

namespace limner {

namespace {

[[noreturn]] void refuse(const char* key, const char* why, const char* remedy) {
    throw Error(ErrorKind::badInput, {"the camera sees nothing", std::string("/camera/") + key, why, remedy});
}

void checkCamera(const Camera& camera) {
    const auto finite = [](const glm::dvec3& v) {
        return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    };
    if (!finite(camera.direction) || !(glm::length(camera.direction) > 0)) {
        refuse("direction", "the view direction has no length", "give three numbers that are not all 0");
    }
    // Below this sine the picture's right is rounding noise.
    constexpr double smallestSine = 1e-6;
    if (!finite(camera.up) || !(glm::length(camera.up) > 0) ||
        !(glm::length(glm::cross(glm::normalize(camera.direction), glm::normalize(camera.up))) > smallestSine)) {
        refuse("up", "it points along the view direction", "choose another direction for up");
    }
    if (!(camera.heightMm > 0) || !std::isfinite(camera.heightMm)) {
        refuse("height_mm", "it must be above 0", "240 shows a head");
    }
    if (camera.projection == Projection::perspective && !(camera.fovDeg > 0 && camera.fovDeg < 180)) {
        refuse("fov_deg", "it must lie between 0 and 180", "30 looks natural");
    }
    if (!finite(camera.targetMm)) {
        refuse("target_mm", "it must be three finite numbers", "the middle of the volume is a good target");
    }
}

} // namespace

RayFrame makeRayFrame(const Camera& camera, const Volume& volume, glm::ivec2 size) {
    checkCamera(camera);
    const Grid& grid = volume.grid();
    const glm::dvec3 forward = glm::normalize(camera.direction);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::dvec3 up = glm::cross(right, forward);
    const double pixelMm = camera.heightMm / size.y;
    const glm::dvec3 corner = camera.targetMm - right * (0.5 * size.x * pixelMm) + up * (0.5 * size.y * pixelMm);
    const glm::dmat3 toVoxel = grid.mmToVoxelMatrix();

    RayFrame frame;
    frame.perspective = camera.projection == Projection::perspective;
    frame.footprintMm = pixelMm;
    frame.rightVoxel = toVoxel * (right * pixelMm);
    frame.downVoxel = toVoxel * (up * -pixelMm);
    if (frame.perspective) {
        const double distanceMm = 0.5 * camera.heightMm / std::tan(0.5 * glm::radians(camera.fovDeg));
        const glm::dvec3 eye = camera.targetMm - forward * distanceMm;
        frame.originVoxel = grid.voxelFromMm(eye);
        frame.forwardVoxel = toVoxel * (corner - eye);
    } else {
        frame.originVoxel = grid.voxelFromMm(corner);
        frame.forwardVoxel = toVoxel * forward;
    }
    frame.eyeFromMm = glm::transpose(glm::dmat3(right, up, -forward));
    frame.mmFromVoxel = grid.voxelToMmMatrix();
    frame.eyeFromGradient = frame.eyeFromMm * glm::transpose(toVoxel) * volume.contents().slope;
    return frame;
}

} // namespace limner
