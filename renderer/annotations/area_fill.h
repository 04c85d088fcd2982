#pragma once

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include <span>
#include <vector>

namespace limner {

/// Rows of coverage: the share of each pixel that lies inside a polygon.
struct Coverage {
    glm::ivec2 origin{0}; ///< pixels
    glm::ivec2 size{0};   ///< empty where the polygon is not in the rows
    std::vector<float> shares;
};

/// Exact areas of closed polygons (one after the other, each of `counts` points, in pixels) for the rows first..end-1.
/// Contours that turn the same way add up, the other way they are holes. A pixel's share depends on the polygon alone,
/// not on which rows are asked for.
Coverage fillArea(std::span<const glm::dvec2> points, std::span<const std::size_t> counts, int firstRow, int endRow);

} // namespace limner
