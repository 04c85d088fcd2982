#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace limner {

/// Marks of ink on a figure's paper: dots and strokes (paper 004). Places and widths are mm on paper, from its top left
/// corner, x to the right, y down: the same marks serve a picture of any size, any tile of it, and a vector file.

using InkColour = glm::u8vec3; ///< sRGB

struct Dot {
    glm::vec2 placeMm{0};
    float depthMm = 0; ///< distance of its place in the volume before the target plane: larger is nearer to the viewer
    float radiusMm = 0;
    float opacity = 1; ///< below 1 while it appears or leaves
    InkColour rgb{0};
};

struct StrokePoint {
    glm::vec2 placeMm{0};
    float widthMm = 0;
};

/// A line of at least two points: round ends and joins, the width linear between points.
struct Stroke {
    std::uint32_t first = 0; ///< of its points in the group
    std::uint32_t count = 0;
    float opacity = 1;
    InkColour rgb{0};
};

/// Marks of one kind from one layer: what a vector file keeps together. Drawn dots first, each in its order.
struct MarkGroup {
    std::string name; ///< for people and for a drawing program's layer: "Stipples", "Silhouettes - Bone"
    std::vector<Dot> dots;
    std::vector<StrokePoint> points;
    std::vector<Stroke> strokes;
};

/// How marks and the picture of the layers lie on one another.
enum class MarkOrder { underLayers, overLayers };

struct Marks {
    glm::dvec2 paperMm{0}; ///< width and height
    MarkOrder order = MarkOrder::underLayers;
    bool layersDrawn = false;      ///< false: the marks are alone
    std::vector<MarkGroup> groups; ///< in drawing order

    [[nodiscard]] bool empty() const;
    [[nodiscard]] std::size_t dotCount() const;
    [[nodiscard]] std::size_t strokeCount() const;
};

} // namespace limner
