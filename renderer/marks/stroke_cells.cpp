#include "renderer/marks/stroke_cells.h"

#include <utility>

namespace limner {

void StrokeCells::begin(int width, int firstRow, int rows) {
    width_ = width;
    firstRow_ = firstRow;
    rows_ = rows;
    stride_ = static_cast<std::size_t>(width) + 2;
    const std::size_t needed = stride_ * static_cast<std::size_t>(rows);
    if (cells_.size() < needed)
        cells_.resize(needed);
    touched_.assign(static_cast<std::size_t>(rows), {width + 2, 0});
}

void StrokeCells::rowPiece(int r, float x0, float x1, float height) {
    const auto limit = static_cast<float>(width_);
    x0 = std::clamp(x0, 0.0F, limit);
    x1 = std::clamp(x1, 0.0F, limit);
    if (x0 > x1)
        std::swap(x0, x1);
    const int first = static_cast<int>(x0);
    const int last = static_cast<int>(x1);
    float* cells = row(r);
    Touched& touched = touched_[static_cast<std::size_t>(r)];
    touched.from = std::min(touched.from, first);
    touched.to = std::max(touched.to, last + 2);
    if (first == last) {
        const float right = height * (0.5F * (x0 + x1) - static_cast<float>(first));
        cells[first] += height - right;
        cells[first + 1] += right;
        return;
    }
    // What lies right of the edge's piece grows quadratically in its first and last cell, evenly between.
    const float perCell = height / (x1 - x0);
    const float inFirst = static_cast<float>(first + 1) - x0;
    const float inLast = x1 - static_cast<float>(last);
    float before = 0.5F * perCell * inFirst * inFirst;
    cells[first] += before;
    for (int x = first + 1; x < last; ++x) {
        const float here = perCell * (static_cast<float>(x) + 0.5F - x0);
        cells[x] += here - before;
        before = here;
    }
    const float inLastCell = height - 0.5F * perCell * inLast * inLast;
    cells[last] += inLastCell - before;
    cells[last + 1] += height - inLastCell;
}

void StrokeCells::edge(glm::vec2 a, glm::vec2 b) {
    if (a.y == b.y)
        return;
    const float sign = a.y < b.y ? 1.0F : -1.0F;
    if (a.y > b.y)
        std::swap(a, b);
    const auto begin = static_cast<float>(firstRow_);
    const auto end = static_cast<float>(firstRow_ + rows_);
    if (b.y <= begin || a.y >= end)
        return;
    const float slope = (b.x - a.x) / (b.y - a.y);
    const int firstRow = static_cast<int>(std::max(a.y, begin));
    for (int y = firstRow; y < firstRow_ + rows_ && static_cast<float>(y) < b.y; ++y) {
        const float top = std::max(a.y, static_cast<float>(y));
        const float bottom = std::min(b.y, static_cast<float>(y + 1));
        const float xTop = top == a.y ? a.x : a.x + (top - a.y) * slope;
        const float xBottom = bottom == b.y ? b.x : a.x + (bottom - a.y) * slope;
        rowPiece(y - firstRow_, xTop, xBottom, sign * (bottom - top));
    }
}

void StrokeCells::outline(std::span<const glm::vec2> places) {
    for (std::size_t i = 1; i < places.size(); ++i)
        edge(places[i - 1], places[i]);
    edge(places.back(), places.front());
}

} // namespace limner
