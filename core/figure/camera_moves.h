#pragma once

#include "core/figure/figure.h"

#include <string>

namespace limner {

/// Turning, panning and zooming as functions from camera to camera, and what the picture's edges mean to the patient.
/// Picture offsets are in units of the picture's height, x to the right, y *down*, from the picture's middle.

/// The camera's orthonormal frame in physical space (LPS). `right = direction x up`.
struct CameraFrame {
    glm::dvec3 right{1, 0, 0};
    glm::dvec3 up{0, 0, 1};
    glm::dvec3 forward{0, 1, 0};
};

/// A camera whose up is parallel to its direction (or either is zero) gets some frame with the same direction.
CameraFrame cameraFrame(const Camera& camera);

enum class TurnMode {
    turntable, ///< sideways turns about the patient's long axis, up and down tilts: the horizon stays
    trackball, ///< the point under the pointer stays under it, on a ball around the target
};

/// The camera after a drag from one picture position to another; the target stays.
Camera turned(const Camera& camera, TurnMode mode, const glm::dvec2& from, const glm::dvec2& to);
/// The scene follows the pointer: `by` is the way it went.
Camera panned(const Camera& camera, const glm::dvec2& by);
/// Multiplies the shown height by `factor` (< 1: closer); what is at `towards` stays there.
Camera zoomed(const Camera& camera, double factor, const glm::dvec2& towards);

/// Letters of a direction in the patient: R or L, A or P, I or S, the largest component first; further ones only where
/// the direction leans to them by more than 15 degrees ("LA"). Empty for a zero vector.
std::string directionLetters(const glm::dvec3& direction);

struct EdgeLetters {
    std::string left, right, top, bottom;
    friend bool operator==(const EdgeLetters&, const EdgeLetters&) = default;
};

/// What lies towards the four edges of the picture.
EdgeLetters edgeLetters(const Camera& camera);

/// The camera moved so that all that is visible of the volume fills the picture but for a margin of 5 % on each side;
/// its direction stays. Without anything visible, or without layers, the volume's box is taken. `aspect`: width over
/// height of the picture.
Camera fitted(const Camera& camera, const Volume& volume, const std::vector<Layer>& layers, double aspect);

} // namespace limner
