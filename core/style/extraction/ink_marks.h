#pragma once

#include "core/style/extraction/picture.h"

#include <glm/vec2.hpp>

#include <cstdint>
#include <vector>

namespace limner {

/// How dark each pixel is, 0..1; or how light, where that is what ink is. Internal to the extraction.
struct InkPlane {
    int width = 0;
    int height = 0;
    std::vector<float> values; ///< 0: full ink, 1: none
    double scale = 1;          ///< pixels of the plane per pixel of the picture it was made of

    [[nodiscard]] float at(int x, int y) const {
        return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
    /// Between pixels' centres; `place` continuous, clamped to the plane.
    [[nodiscard]] float between(glm::dvec2 place) const;
};

/// A picture enlarged or reduced so that thin strokes are two pixels wide or so. Black ink is dark in every channel; a
/// red or blue line is none. `light`: the other way round.
InkPlane inkPlaneOf(const ArtPicture& picture, bool light);

/// A connected piece of ink. Lengths in pixels of the plane.
struct InkMark {
    int label = 0;
    glm::dvec2 centre{0, 0};
    std::vector<glm::vec2> hull; ///< corners of pixels
    double area = 0;
    double hullArea = 0;
    double stroke = 0;     ///< how wide its strokes are
    double thickest = 0;   ///< width of its thickest place
    double ink = 0;        ///< median value
    double around = 0;     ///< mean value right beside it
    glm::dvec2 axis{1, 0}; ///< along which it is longest
    double roundness = 0;  ///< of its spread across that axis to the one along it; 0: a line

    [[nodiscard]] double contrast() const { return around - ink; }
    /// From and to where it reaches along a direction of length 1.
    [[nodiscard]] glm::dvec2 reach(glm::dvec2 direction) const;
    [[nodiscard]] double extent(glm::dvec2 direction) const {
        const glm::dvec2 ends = reach(direction);
        return ends.y - ends.x;
    }
};

struct InkMarks {
    int width = 0;
    int height = 0;
    std::vector<std::int32_t> labels; ///< 0: no ink; others may belong to no mark below, too small or too large
    std::vector<InkMark> marks;
};

/// Pieces of ink that are darker than their surroundings, of a size that letters and lines have.
InkMarks inkMarksOf(const InkPlane& plane);

} // namespace limner
