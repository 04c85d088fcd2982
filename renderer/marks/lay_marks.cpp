#include "renderer/marks/lay_marks.h"

#include "renderer/marks/band_canvas.h"
#include "renderer/marks/mark_bins.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace limner {

namespace {

/// The marks' premultiplied colour at a pixel.
struct Premultiplied {
    float rgba[4];
};
Premultiplied colourOf(const InkPixel& pixel, const InkColour& rgb) {
    const float alpha = 1 - pixel.through;
    const auto channel = [&](int i) { return static_cast<float>(rgb[i]) / 255 * alpha; };
    return {{channel(0), channel(1), channel(2), alpha}};
}
Premultiplied colourOf(const ColourPixel& pixel, const InkColour& /*rgb*/) {
    return {{pixel.rgba[0], pixel.rgba[1], pixel.rgba[2], pixel.rgba[3]}};
}

void compose(const Premultiplied& mark, MarkOrder order, float* to) {
    const bool under = order == MarkOrder::underLayers;
    const float share = 1 - (under ? to[3] : mark.rgba[3]);
    for (int i = 0; i < 4; ++i)
        to[i] = under ? to[i] + share * mark.rgba[i] : mark.rgba[i] + share * to[i];
}

template <typename Pixel>
void compose(BandCanvas<Pixel>& canvas, const Marks& marks, const InkColour& rgb, const Tile& tile, Picture& picture) {
    const Tile& band = canvas.band();
    for (int y = 0; y < band.size.y; ++y) {
        const Pixel* from = canvas.at(band.origin.x, band.origin.y + y);
        float* to = picture.pixel(0, band.origin.y - tile.origin.y + y);
        for (int x = 0; x < band.size.x; ++x, to += 4)
            compose(colourOf(from[x], rgb), marks.order, to);
    }
}

/// A band's dots of a group, the farthest first; equally far ones as they come.
std::vector<ColourDotSplat> farthestFirst(std::span<const MarkChunk<ColourDotSplat>> chunks, std::size_t band) {
    std::vector<ColourDotSplat> dots;
    for (const auto& chunk : chunks)
        dots.insert(dots.end(), chunk.dots.of(band).begin(), chunk.dots.of(band).end());
    std::stable_sort(dots.begin(), dots.end(),
                     [](const ColourDotSplat& a, const ColourDotSplat& b) { return a.depth < b.depth; });
    return dots;
}

void layDots(std::span<const MarkChunk<DotSplat>> chunks, std::size_t band, const InkColour& ink,
             BandCanvas<InkPixel>& canvas) {
    for (const auto& chunk : chunks)
        for (const DotSplat& dot : chunk.dots.of(band))
            canvas.lay(dot, ink);
}

void layDots(std::span<const MarkChunk<ColourDotSplat>> chunks, std::size_t band, const InkColour& /*ink*/,
             BandCanvas<ColourPixel>& canvas) {
    for (const ColourDotSplat& dot : farthestFirst(chunks, band))
        canvas.lay(dot, dot.rgb);
}

template <typename Pixel, typename AnyDotSplat>
class MarkLayer {
  public:
    MarkLayer(const Marks& marks, const InkColour& ink, const MarkBins<AnyDotSplat>& bins, const Tile& tile,
              Picture& picture)
        : marks_(marks), ink_(ink), bins_(bins), tile_(tile), picture_(picture) {}

    void lay() {
        tbb::parallel_for(std::size_t{0}, bins_.bands, [&](std::size_t band) { layBand(band); });
    }

  private:
    struct Space {
        BandCanvas<Pixel> canvas;
        StrokeCells cells;
    };

    [[nodiscard]] bool touched(std::size_t band) const {
        return std::any_of(bins_.chunks.begin(), bins_.chunks.end(), [&](const auto& chunk) {
            return !chunk.dots.of(band).empty() || !chunk.strokes.of(band).empty();
        });
    }

    void layBand(std::size_t band) {
        if (!touched(band))
            return;
        Space& space = spaces_.local();
        const int top = static_cast<int>(band) * kBandRows;
        space.canvas.begin(
            {tile_.origin + glm::ivec2(0, top), {tile_.size.x, std::min(kBandRows, tile_.size.y - top)}});
        const std::span<const MarkChunk<AnyDotSplat>> all(bins_.chunks);
        for (std::size_t from = 0; from < all.size();) {
            std::size_t to = from + 1;
            while (to < all.size() && all[to].group == all[from].group)
                ++to;
            layGroup(all.subspan(from, to - from), band, space);
            from = to;
        }
        compose(space.canvas, marks_, ink_, tile_, picture_);
    }

    void layGroup(std::span<const MarkChunk<AnyDotSplat>> chunks, std::size_t band, Space& space) {
        layDots(chunks, band, ink_, space.canvas);
        for (const auto& chunk : chunks)
            for (const StrokeSplat& stroke : chunk.strokes.of(band))
                space.canvas.lay(stroke, chunk.places, space.cells);
    }

    const Marks& marks_;
    const InkColour& ink_; ///< where all marks have one
    const MarkBins<AnyDotSplat>& bins_;
    const Tile& tile_;
    Picture& picture_;
    tbb::enumerable_thread_specific<Space> spaces_;
};

/// There is a mark.
InkColour firstColour(const Marks& marks) {
    const auto group = std::find_if(marks.groups.begin(), marks.groups.end(),
                                    [](const MarkGroup& g) { return !g.dots.empty() || !g.strokes.empty(); });
    return group->dots.empty() ? group->strokes.front().rgb : group->dots.front().rgb;
}

} // namespace

void layMarks(const Marks& marks, glm::ivec2 size, const Tile& tile, Picture& picture) {
    if (marks.empty() || !(marks.paperMm.x > 0 && marks.paperMm.y > 0) || tile.size.x < 1 || tile.size.y < 1)
        return;
    const InkColour ink = firstColour(marks);
    if (const auto bins = sortOneInk(marks, ink, size, tile))
        MarkLayer<InkPixel, DotSplat>(marks, ink, *bins, tile, picture).lay();
    else
        MarkLayer<ColourPixel, ColourDotSplat>(marks, ink, sortColours(marks, size, tile), tile, picture).lay();
}

void layInk(std::span<const float> through, const InkColour& ink, MarkOrder order, Picture& picture) {
    const int width = picture.size().x;
    tbb::parallel_for(0, picture.size().y, [&](int y) {
        const float* from = through.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
        float* to = picture.pixel(0, y);
        for (int x = 0; x < width; ++x, to += 4)
            if (from[x] < 1)
                compose(colourOf(InkPixel{from[x]}, ink), order, to);
    });
}

} // namespace limner
