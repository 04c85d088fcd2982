#pragma once

#include "renderer/backend.h"
#include "renderer/marks/marks.h"

#include <cstdint>
#include <span>
#include <vector>

namespace limner {

/// A dot in a picture's pixels.
struct DotSplat {
    static constexpr int kUnits = 256; ///< of `x` and `y` in a pixel
    std::int32_t x = 0;                ///< from the picture's corner
    std::int32_t y = 0;
    float radius = 0;
    float opacity = 0;
    float depth = 0;
    InkColour rgb{0};
};

/// A stroke in a picture's pixels: an outline, curves as chords; or, without one, a short thin line.
struct StrokeSplat {
    std::uint32_t firstPlace = 0; ///< of the outline
    std::uint32_t places = 0;
    glm::vec2 from{0}; ///< the short thin line
    glm::vec2 to{0};
    float radius = 0;
    glm::ivec2 origin{0}; ///< of all places, in whole pixels of the picture
    glm::ivec2 extent{0}; ///< pixels from the origin to the right end, or the picture's, and to the lower end
    float opacity = 0;
    InkColour rgb{0};
};

/// Some of a group's marks, in its order, those of one kind that touch a band of rows together.
struct MarkChunk {
    std::size_t group = 0;
    std::vector<DotSplat> dots;
    std::vector<std::uint32_t> dotStart; ///< per band, one more at the end
    std::vector<StrokeSplat> strokes;
    std::vector<glm::vec2> places;
    std::vector<std::uint32_t> strokeStart;
    bool oneColour = true; ///< of all marks that the chunk looked at, in the tile or not
    InkColour rgb{0};

    [[nodiscard]] std::span<const DotSplat> dotsOf(std::size_t band) const {
        return std::span(dots).subspan(dotStart[band], dotStart[band + 1] - dotStart[band]);
    }
    [[nodiscard]] std::span<const StrokeSplat> strokesOf(std::size_t band) const {
        return std::span(strokes).subspan(strokeStart[band], strokeStart[band + 1] - strokeStart[band]);
    }
};

/// Marks sorted into bands of a tile's rows.
struct MarkBins {
    static constexpr int kBandRows = 16;
    std::vector<MarkChunk> chunks; ///< in drawing order; the same whatever the number of threads
    std::size_t bands = 0;
    bool oneColour = true; ///< of all the marks
    InkColour rgb{0};
};

/// Marks that are not finite or do not touch the tile are left out.
MarkBins sortIntoBands(const Marks& marks, glm::ivec2 size, const Tile& tile);

} // namespace limner
