#pragma once

#include "core/style/extraction/artwork.h"
#include "core/style/extraction/forms.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace limner {

/// What finders look at: a part of a cut, reduced, as lightness and two chromas (CIE L*a*b*, so scaled that 1 is the
/// way from black to white), each times alpha, and alpha. Internal to the extraction.
struct Tones {
    int width = 0;
    int height = 0;
    std::vector<glm::vec4> pixels; ///< width * height, top row first
    glm::dvec2 origin{0, 0};       ///< artwork place of the top left corner
    double scale = 1;              ///< artwork pixels per pixel

    [[nodiscard]] const glm::vec4& at(int x, int y) const {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
    /// Between pixels' centres; beyond the edge, what is at the edge. `place` in pixels, continuous.
    [[nodiscard]] glm::vec4 between(glm::dvec2 place) const;
    [[nodiscard]] bool holds(glm::dvec2 place) const {
        return place.x >= 0 && place.y >= 0 && place.x < width && place.y < height;
    }
};

/// Of the part of a cut that lies in a box (artwork places), its longer side at most `longest` pixels; empty where
/// nothing lies in it.
Tones tonesOf(const ArtCut& cut, glm::dvec2 low, glm::dvec2 high, int longest);
/// Half as many pixels along each side, two at least; of what has fewer, itself.
Tones halved(const Tones& tones);

/// An ellipse in pixels of tones as its centre and the symmetric matrix that makes it of the unit circle, which knows
/// no angle that a circle would not have.
struct Oval {
    glm::dvec2 centre{0, 0};
    double xx = 1;
    double xy = 0;
    double yy = 1;

    [[nodiscard]] glm::dvec2 at(glm::dvec2 onCircle) const {
        return centre + glm::dvec2(xx * onCircle.x + xy * onCircle.y, xy * onCircle.x + yy * onCircle.y);
    }
    /// Outward, of length 1, where the unit circle has `onCircle`.
    [[nodiscard]] glm::dvec2 normal(glm::dvec2 onCircle) const;
    /// Of the circle of the same area.
    [[nodiscard]] double radius() const;
    [[nodiscard]] glm::dvec2 semiAxes() const; ///< the longer first
    /// Where a place would be on the unit disk.
    [[nodiscard]] glm::dvec2 toDisk(glm::dvec2 place) const;
};

Oval ovalOf(const Ellipse& ellipse, const Tones& tones);
/// Its first axis is the one nearer to `degrees`.
Ellipse ellipseOf(const Oval& oval, const Tones& tones, double degrees = 0);

} // namespace limner
