#pragma once

#include "renderer/backend.h"
#include "renderer/marks/marks.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace limner {

/// A dot in a picture's pixels.
struct DotSplat {
    static constexpr int kLog2Units = 8;
    static constexpr int kUnits = 1 << kLog2Units; ///< of `x` and `y` in a pixel
    std::int32_t x = 0;                            ///< from the picture's corner
    std::int32_t y = 0;
    float radius = 0;
    float opacity = 0;
};

/// One among dots of several colours.
struct ColourDotSplat : DotSplat {
    float depth = 0;
    InkColour rgb{0};
};

/// A stroke in a picture's pixels: an outline, curves as chords; or, without one, a short thin line.
struct StrokeSplat {
    std::uint32_t firstPlace = 0; ///< of the outline
    std::uint32_t places = 0;
    glm::ivec2 origin{0}; ///< of all places, in whole pixels of the picture
    glm::ivec2 extent{0}; ///< of the outline: pixels from the origin to its right end, or the picture's, and lower end
    glm::vec2 middle{0};  ///< of the line
    glm::vec2 along{0};   ///< unit
    float halfLength = 0;
    float radius = 0;
    float opacity = 0;
    InkColour rgb{0};
};

/// Marks of one kind in the order of the bands that they touch, within a band in their own.
template <typename Splat>
struct Banded {
    std::vector<Splat> splats;
    std::vector<std::uint32_t> start; ///< per band, one more at the end; empty: none

    [[nodiscard]] std::span<const Splat> of(std::size_t band) const {
        if (start.empty())
            return {};
        return std::span(splats).subspan(start[band], start[band + 1] - start[band]);
    }
};

/// Some of a group's marks, in its order.
template <typename AnyDotSplat>
struct MarkChunk {
    std::size_t group = 0;
    Banded<AnyDotSplat> dots;
    Banded<StrokeSplat> strokes;
    std::vector<glm::vec2> places; ///< of the outlines
};

/// Marks sorted into bands of a tile's rows.
template <typename AnyDotSplat>
struct MarkBins {
    std::vector<MarkChunk<AnyDotSplat>> chunks; ///< in drawing order; the same whatever the number of threads
    std::size_t bands = 0;
};
constexpr int kBandRows = 16;

/// Marks that are not finite or do not touch the tile are left out.
MarkBins<ColourDotSplat> sortColours(const Marks& marks, glm::ivec2 size, const Tile& tile);
/// The same of marks that all have this colour; absent where one has another.
std::optional<MarkBins<DotSplat>> sortOneInk(const Marks& marks, const InkColour& ink, glm::ivec2 size,
                                             const Tile& tile);

} // namespace limner
