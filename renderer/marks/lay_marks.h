#pragma once

#include "renderer/backend.h"
#include "renderer/marks/marks.h"

#include <span>

namespace limner {

/// Lays the marks into a rendered tile of a picture of `size` pixels, over or under what is drawn there. The share of a
/// pixel that a mark covers is its area's; marks of one colour count alike in any order; of several colours a group's
/// nearer dots lie over its farther ones, its strokes over its dots, and later groups over earlier ones, as in a vector
/// file. Parallel; any tiling gives the same bits.
void layMarks(const Marks& marks, glm::ivec2 size, const Tile& tile, Picture& picture);

/// Lays marks of one ink that let through so much of what is under them, a number for each pixel of the picture, the
/// top row first.
void layInk(std::span<const float> through, const InkColour& ink, MarkOrder order, Picture& picture);

} // namespace limner
