#pragma once

#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <vector>

namespace limner {

/// Where the viewer stands and what is cut away. LPS mm, angles in degrees.

enum class Projection { orthographic, perspective };

/// The picture's right is `direction x up`. In perspective the plane through the target shows `heightMm`.
struct Camera {
    Projection projection = Projection::orthographic;
    glm::dvec3 targetMm{0};
    glm::dvec3 direction{0, 1, 0}; ///< the way the viewer looks; need not be unit
    glm::dvec3 up{0, 0, 1};
    double heightMm = 240;
    double fovDeg = 30; ///< full vertical angle; perspective only
    friend bool operator==(const Camera&, const Camera&) = default;
};

/// Cuts away where `dot(normal, position) > offsetMm`.
struct ClipPlane {
    glm::dvec3 normal{1, 0, 0};
    double offsetMm = 0;
    friend bool operator==(const ClipPlane&, const ClipPlane&) = default;
};

struct BoxMm {
    glm::dvec3 low{0};
    glm::dvec3 high{0};
    friend bool operator==(const BoxMm&, const BoxMm&) = default;
};

/// How the faces of a cut are drawn: flat, by the cut's own normal, in a style or a colour, or in what the transfer
/// functions give where neither is named.
struct CutFace {
    std::string style;
    std::optional<glm::dvec3> rgb;
    friend bool operator==(const CutFace&, const CutFace&) = default;
};

struct Clip {
    std::optional<BoxMm> boxMm; ///< JSON: [[x, y, z], [x, y, z]]; what is outside is cut away
    std::vector<ClipPlane> planes;
    std::optional<CutFace> face = {}; ///< absent: cuts show the data's own, noisy directions
    friend bool operator==(const Clip&, const Clip&) = default;
};

} // namespace limner
