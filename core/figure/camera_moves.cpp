#include "core/figure/camera_moves.h"

#include "core/style/transfer_function.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace limner {
namespace {

/// Lengths below this are taken as zero; directions are of order one.
constexpr double kTiny = 1e-12;

glm::dvec3 anyPerpendicular(const glm::dvec3& unit) {
    const glm::dvec3 other = std::abs(unit.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, -1, 0);
    return glm::normalize(other - unit * glm::dot(other, unit));
}

/// Rotates v about a unit axis (Rodrigues).
glm::dvec3 rotated(const glm::dvec3& v, const glm::dvec3& axis, double angle) {
    const double c = std::cos(angle);
    return v * c + glm::cross(axis, v) * std::sin(angle) + axis * (glm::dot(axis, v) * (1 - c));
}

Camera rotatedCamera(Camera camera, const glm::dvec3& axis, double angle) {
    const CameraFrame frame = cameraFrame(camera);
    camera.direction = glm::normalize(rotated(frame.forward, axis, angle));
    camera.up = glm::normalize(rotated(frame.up, axis, angle));
    return camera;
}

/// A picture position on the ball around the target: a sphere in the middle, a hyperbola outside, so that the surface
/// goes on smoothly to the picture's corners. Components along right, up and towards the viewer.
glm::dvec3 onBall(const glm::dvec2& position) {
    constexpr double kRadius = 0.45; // of the picture's height: nearly fills the shorter side
    const glm::dvec2 p = glm::dvec2(position.x, -position.y) / kRadius;
    const double r2 = glm::dot(p, p);
    const double z = r2 < 0.5 ? std::sqrt(1 - r2) : 0.5 / std::sqrt(r2);
    return glm::normalize(glm::dvec3(p, z));
}

Camera turnedOnBall(const Camera& camera, const glm::dvec2& from, const glm::dvec2& to) {
    const glm::dvec3 a = onBall(from);
    const glm::dvec3 b = onBall(to);
    const glm::dvec3 axisEye = glm::cross(a, b);
    if (glm::length(axisEye) < kTiny)
        return camera;
    const CameraFrame frame = cameraFrame(camera);
    const glm::dvec3 unit = glm::normalize(axisEye);
    const glm::dvec3 axis = frame.right * unit.x + frame.up * unit.y - frame.forward * unit.z;
    // The scene turns from a to b, so the camera turns back.
    return rotatedCamera(camera, axis, -std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0)));
}

Camera turnedOnTable(const Camera& camera, const glm::dvec2& by) {
    // The picture's height of drag is half a turn: the scene's front follows the pointer at about its own speed.
    const double yaw = -by.x * std::numbers::pi;
    const double pitch = -by.y * std::numbers::pi;
    const CameraFrame frame = cameraFrame(camera);
    // With the patient upside down the table still follows the hand.
    const double upright = frame.up.z < -kTiny ? -1 : 1;
    const Camera tilted = rotatedCamera(camera, frame.right, pitch);
    return rotatedCamera(tilted, glm::dvec3(0, 0, 1), yaw * upright);
}

/// Bounds of projected points in a camera's plane.
struct Bounds {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};
    void add(const glm::dvec3& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    [[nodiscard]] bool empty() const { return low.x > high.x; }
};

bool isVisible(const std::vector<Layer>& layers, double value) {
    constexpr double kVisible = 0.02; // below 2 % per voxel a haze does not count as something to fit
    return std::any_of(layers.begin(), layers.end(), [value](const Layer& layer) {
        return layer.visible && curveOpacityAt(layer.transfer, value) * layer.opacity > kVisible;
    });
}

Bounds visibleBounds(const CameraFrame& frame, const Volume& volume, const std::vector<Layer>& layers) {
    constexpr int kProbes = 64; // per axis: to 1.6 % of the box, less than the margin, in about 10 ms
    const Grid& grid = volume.grid();
    const glm::ivec3 stride = glm::max(glm::ivec3(1), grid.dims / kProbes);
    Bounds bounds;
    for (int z = 0; z < grid.dims.z; z += stride.z)
        for (int y = 0; y < grid.dims.y; y += stride.y)
            for (int x = 0; x < grid.dims.x; x += stride.x)
                if (isVisible(layers, volume.valueAt({x, y, z}))) {
                    const glm::dvec3 mm = grid.mmFromVoxel({x, y, z});
                    bounds.add({glm::dot(mm, frame.right), glm::dot(mm, frame.up), glm::dot(mm, frame.forward)});
                }
    return bounds;
}

Bounds boxBounds(const CameraFrame& frame, const Grid& grid) {
    Bounds bounds;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 end(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
        const glm::dvec3 mm = grid.mmFromVoxel(end * glm::dvec3(grid.dims) - 0.5);
        bounds.add({glm::dot(mm, frame.right), glm::dot(mm, frame.up), glm::dot(mm, frame.forward)});
    }
    return bounds;
}

} // namespace

CameraFrame cameraFrame(const Camera& camera) {
    CameraFrame frame;
    if (glm::length(camera.direction) > kTiny)
        frame.forward = glm::normalize(camera.direction);
    const glm::dvec3 up = camera.up - frame.forward * glm::dot(camera.up, frame.forward);
    frame.up = glm::length(up) > 1e-9 * std::max(1.0, glm::length(camera.up)) // parallel but for rounding
                   ? glm::normalize(up)
                   : anyPerpendicular(frame.forward);
    frame.right = glm::cross(frame.forward, frame.up);
    return frame;
}

Camera turned(const Camera& camera, TurnMode mode, const glm::dvec2& from, const glm::dvec2& to) {
    return mode == TurnMode::trackball ? turnedOnBall(camera, from, to) : turnedOnTable(camera, to - from);
}

Camera panned(const Camera& camera, const glm::dvec2& by) {
    const CameraFrame frame = cameraFrame(camera);
    Camera result = camera;
    result.targetMm -= (frame.right * by.x - frame.up * by.y) * camera.heightMm;
    return result;
}

Camera zoomed(const Camera& camera, double factor, const glm::dvec2& towards) {
    constexpr double kLowestMm = 0.01; // nothing scanned has finer detail; keeps the numbers far from zero
    constexpr double kHighestMm = 1e6; // a kilometre
    const double height = std::clamp(camera.heightMm * factor, kLowestMm, kHighestMm);
    Camera result = panned(camera, towards * (height / camera.heightMm - 1));
    result.heightMm = height;
    return result;
}

std::string directionLetters(const glm::dvec3& direction) {
    const double length = glm::length(direction);
    if (!(length > kTiny))
        return {};
    struct Part {
        double size;
        char letter;
    };
    std::array<Part, 3> parts = {Part{std::abs(direction.x), direction.x > 0 ? 'L' : 'R'},
                                 Part{std::abs(direction.y), direction.y > 0 ? 'P' : 'A'},
                                 Part{std::abs(direction.z), direction.z > 0 ? 'S' : 'I'}};
    std::stable_sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.size > b.size; });
    const double least = std::sin(std::numbers::pi / 12) * length; // 15 degrees
    std::string letters(1, parts[0].letter);
    for (std::size_t i = 1; i < parts.size(); ++i)
        if (parts[i].size > least)
            letters += parts[i].letter;
    return letters;
}

EdgeLetters edgeLetters(const Camera& camera) {
    const CameraFrame frame = cameraFrame(camera);
    return {directionLetters(-frame.right), directionLetters(frame.right), directionLetters(frame.up),
            directionLetters(-frame.up)};
}

Camera fitted(const Camera& camera, const Volume& volume, const std::vector<Layer>& layers, double aspect) {
    constexpr double kFill = 1.1; // 5 % of margin on each side
    const CameraFrame frame = cameraFrame(camera);
    Bounds bounds = visibleBounds(frame, volume, layers);
    if (bounds.empty())
        bounds = boxBounds(frame, volume.grid());
    const glm::dvec3 middle = (bounds.low + bounds.high) * 0.5;
    const glm::dvec3 size = bounds.high - bounds.low;
    Camera result = camera;
    result.targetMm = frame.right * middle.x + frame.up * middle.y + frame.forward * middle.z;
    const double least = volume.grid().smallestSpacingMm(); // a single visible voxel still gives a picture
    double height = std::max({size.y, size.x / std::max(aspect, 1e-3), least}) * kFill;
    if (camera.projection == Projection::perspective) // the near side of the matter is shown larger
        height += size.z * std::tan(camera.fovDeg * std::numbers::pi / 360);
    result.heightMm = height;
    return result;
}

} // namespace limner
