#pragma once

#include "core/style/extraction/picture.h"

#include <glm/vec2.hpp>

#include <filesystem>
#include <vector>

namespace limner {

/// A ball on an artwork, seen as an ellipse: its disk is the unit disk of normals by the affine map that takes the
/// ellipse to a circle and keeps "up" up.
struct Ellipse {
    glm::dvec2 centre{0, 0};   ///< artwork pixels
    glm::dvec2 semiAxes{0, 0}; ///< artwork pixels, both > 0
    double degrees = 0;        ///< from +x to the first semi-axis, clockwise as seen (y goes down)
    friend bool operator==(const Ellipse&, const Ellipse&) = default;
};

/// A normal that a person knows at one place: a facing point, a rim.
struct NormalMark {
    glm::dvec2 at{0, 0};     ///< artwork pixels
    glm::dvec2 normal{0, 0}; ///< n_x to the right, n_y UP, in the unit disk; (0, 0) faces the viewer
    friend bool operator==(const NormalMark&, const NormalMark&) = default;
};

using ArtPath = std::vector<glm::dvec2>; ///< artwork pixels

/// A ridge (tilt > 0: the sides fall away from it) or a valley (tilt < 0).
struct Crease {
    ArtPath path;
    double tiltDegrees = 30; ///< of either side's normal away from the viewer, across the path; -90..90
    friend bool operator==(const Crease&, const Crease&) = default;
};

/// What a person adds to a region's outline.
struct FormMarks {
    std::vector<NormalMark> normals;
    std::vector<Crease> creases;
    std::vector<ArtPath> open; ///< along parts of the outline where the form goes on, hidden or cut off
    double depth = 1;          ///< of the form, where 1 is as deep as it is wide; 0.1..10
    friend bool operator==(const FormMarks&, const FormMarks&) = default;
};

/// Any shaded form: where it is, over the WHOLE artwork, at any resolution; and what is known of its normals.
struct FormRegion {
    Mask mask;
    FormMarks marks;
};

/// `{"normals": [{"at": [x, y], "normal": [nx, ny]}], "creases": [{"path": [[x, y], ...], "tilt_deg": 30}],
/// "open": [[[x, y], ...]], "depth": 1}`; each member may be absent. Throws Error(badInput).
FormMarks loadFormMarks(const std::filesystem::path& file);

} // namespace limner
