#pragma once

#include "core/style/extraction/picture.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace limner {

/// Which pixels of a source become which of its reduced copy. Internal to the extraction.
struct Reduction {
    glm::dvec2 origin{0, 0}; ///< of the copy's top left corner, in pixels of the source
    double scale = 1;        ///< pixels of the source per pixel of the copy; at least 1
    int width = 0;           ///< of the copy; its last column and row may reach beyond what there is
    int height = 0;
    /// Pixels of the source that count: the columns from `left` on and before `right`, and rows likewise.
    int left = 0;
    int right = 0;
    int top = 0;
    int bottom = 0;
};

/// The reduction of a rectangle to at most `longest` pixels on its longer side. `width`, `height` >= 1.
Reduction reductionOf(glm::ivec2 corner, glm::ivec2 size, int longest);

/// Averages rows of a source, top to bottom, into a picture: the mean over the area under each of its pixels, colours
/// weighted with alpha. Whole rows are summed before anything is summed across, which is what makes it fast.
class AreaMeans {
  public:
    /// Writes rows `firstRow` on and before `endRow` of the copy, whose pixels are there already.
    AreaMeans(const Reduction& reduction, int firstRow, int endRow, ArtPicture& copy);

    /// Rows of the source that count for the rows asked for.
    [[nodiscard]] int top() const { return top_; }
    [[nodiscard]] int bottom() const { return bottom_; }
    /// Row `y` of the source, its columns `left` on and before `right`; in order, none left out.
    void addRow(int y, std::span<const Rgba> row);
    void finish();

  private:
    void add(std::span<const Rgba> row, float share);
    void store();

    struct Share {
        std::size_t first = 0; ///< pixels of the copy
        float here = 0;        ///< how much of the source's pixel falls on it
        float next = 0;        ///< and on the one after it
    };

    Reduction r_;
    ArtPicture& copy_;
    int current_;
    int end_;
    int top_ = 0;
    int bottom_ = 0;
    std::vector<Share> shares_;  ///< of the source's columns
    std::vector<float> weights_; ///< that the copy's columns get
    std::vector<Rgba> sums_;     ///< of the source's columns, premultiplied
    std::vector<Rgba> across_;   ///< of the copy's
    float weight_ = 0;           ///< of the rows summed
};

} // namespace limner
