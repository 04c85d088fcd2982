#pragma once

#include "core/figure/camera.h"

namespace limner {

/// Where the viewer stands, as three angles in degrees that people can type.
struct ViewAngles {
    double turnDeg = 0; ///< round the patient's long axis: 0 before the face, 90 at the patient's left; -180..180
    double tiltDeg = 0; ///< above (90: looking straight down) or below the horizon; -90..90
    double rollDeg = 0; ///< of the picture, counter-clockwise as the head of the patient leans; -180..180
};

/// Straight above or below, turn and roll are one: all of it is the turn.
ViewAngles viewAngles(const Camera& camera);
/// The camera with these angles; target, height and projection stay.
Camera withViewAngles(const Camera& camera, const ViewAngles& angles);

} // namespace limner
