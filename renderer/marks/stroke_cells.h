#pragma once

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace limner {

/// Exact area coverage of closed outlines, cell by cell, in some rows of a picture: what every edge encloses to its
/// right is added up (the way font rasterisers do). What a row gets does not depend on which other rows there are.
class StrokeCells {
  public:
    /// Rows [firstRow, firstRow + rows) of `width` cells.
    void begin(int width, int firstRow, int rows);
    /// One edge of an outline.
    void edge(glm::vec2 a, glm::vec2 b);
    /// Closed through all places.
    void outline(std::span<const glm::vec2> places);
    /// Hands out the coverage of every cell that is not empty, paint(x, row, coverage), and clears.
    template <typename Paint>
    void sweep(Paint paint) {
        for (int r = 0; r < rows_; ++r) {
            float* cells = row(r);
            const Touched touched = touched_[static_cast<std::size_t>(r)];
            float sum = 0;
            for (int x = touched.from; x < touched.to; ++x) {
                sum += cells[x];
                cells[x] = 0;
                const float coverage = std::min(std::abs(sum), 1.0F);
                if (coverage > kNothing && x < width_)
                    paint(x, firstRow_ + r, coverage);
            }
        }
    }

  private:
    struct Touched {
        int from = 0;
        int to = 0;
    };
    static constexpr float kNothing = 1e-5F; ///< what is left of a sum of floats that should be 0

    [[nodiscard]] float* row(int r) { return cells_.data() + static_cast<std::size_t>(r) * stride_; }
    void rowPiece(int r, float x0, float x1, float height);

    int width_ = 0;
    int firstRow_ = 0;
    int rows_ = 0;
    std::size_t stride_ = 0;
    std::vector<float> cells_; ///< all 0 between strokes
    std::vector<Touched> touched_;
};

} // namespace limner
