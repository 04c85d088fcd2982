#pragma once

#include "renderer/backend.h"
#include "renderer/marks/dot_stencils.h"
#include "renderer/marks/edge_share.h"
#include "renderer/marks/mark_bins.h"
#include "renderer/marks/stroke_cells.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>
#include <vector>

namespace limner {

/// How much light a band of rows lets through: marks of one ink.
struct InkPixel {
    float through = 1;

    void cover(float share, const InkColour& /*rgb*/) { through *= std::max(1 - share, 0.0F); }
    static void coverFour(InkPixel* pixels, Four shares, const InkColour& /*rgb*/) {
        Four through;
        std::memcpy(&through, &pixels->through, sizeof through);
        through *= atLeast0(1 - shares);
        std::memcpy(&pixels->through, &through, sizeof through);
    }
};
static_assert(sizeof(InkPixel) == sizeof(float));

/// What lies on a band of rows, premultiplied: marks of several colours.
struct ColourPixel {
    Four rgba{};

    void cover(float share, const InkColour& rgb) {
        share = std::min(share, 1.0F);
        const Four ink{static_cast<float>(rgb.r) / 255, static_cast<float>(rgb.g) / 255,
                       static_cast<float>(rgb.b) / 255, 1};
        rgba = rgba * (1 - share) + ink * share;
    }
    static void coverFour(ColourPixel* pixels, Four shares, const InkColour& rgb) {
        for (int i = 0; i < 4; ++i)
            pixels[i].cover(shares[i], rgb);
    }
};

/// A tile's band, with a margin into which stencils may reach.
template <typename Pixel>
class BandCanvas {
  public:
    void begin(const Tile& band) {
        band_ = band;
        stride_ = static_cast<std::size_t>(band.size.x) + 2 * DotStencils::kEdge;
        pixels_.assign(stride_ * static_cast<std::size_t>(band.size.y + 2 * DotStencils::kEdge), Pixel());
    }
    /// In pixels of the picture; up to DotStencils::kEdge outside of the band.
    [[nodiscard]] Pixel* at(int x, int y) {
        return pixels_.data() + static_cast<std::size_t>(y - band_.origin.y + DotStencils::kEdge) * stride_ +
               static_cast<std::size_t>(x - band_.origin.x + DotStencils::kEdge);
    }
    [[nodiscard]] const Tile& band() const { return band_; }

    void lay(const DotSplat& dot, const InkColour& rgb) {
        if (dot.radius <= DotStencils::kLargestRadius)
            laySmall(dot, rgb);
        else
            layLarge(dot, rgb);
    }
    /// `places`: of the stroke's chunk.
    void lay(const StrokeSplat& stroke, std::span<const glm::vec2> places, StrokeCells& cells) {
        if (stroke.places == 0)
            return layLine(stroke);
        const int first = std::max(band_.origin.y - stroke.origin.y, 0);
        const int rows = std::min(band_.origin.y + band_.size.y - stroke.origin.y, stroke.extent.y) - first;
        if (stroke.extent.x <= 0 || rows <= 0)
            return;
        cells.begin(stroke.extent.x, first, rows);
        cells.outline(places.subspan(stroke.firstPlace, stroke.places));
        const int left = band_.origin.x - stroke.origin.x;
        cells.sweep([&](int x, int y, float coverage) {
            if (x >= left && x < left + band_.size.x)
                at(x + stroke.origin.x, y + stroke.origin.y)->cover(coverage * stroke.opacity, stroke.rgb);
        });
    }

  private:
    void laySmall(const DotSplat& dot, const InkColour& rgb);
    void layLarge(const DotSplat& dot, const InkColour& rgb);
    void layLine(const StrokeSplat& stroke);

    Tile band_;
    std::size_t stride_ = 0;
    std::vector<Pixel> pixels_;
};

template <typename Pixel>
void BandCanvas<Pixel>::laySmall(const DotSplat& dot, const InkColour& rgb) {
    constexpr int kUnitBits = DotSplat::kLog2Units - DotStencils::kLog2Phases;
    constexpr int kUnitsPerPhase = 1 << kUnitBits;
    constexpr int kInPixel = DotStencils::kPhases - 1;
    constexpr auto kReach = static_cast<int>(DotStencils::kLargestRadius * DotStencils::kPhases);
    const auto phases = [](int units) { return ((units + kUnitsPerPhase / 2) >> kUnitBits) - kReach; };
    const int phasesX = phases(dot.x);
    const int phasesY = phases(dot.y);
    const int x = phasesX >> DotStencils::kLog2Phases;
    const int y = phasesY >> DotStencils::kLog2Phases;
    // Rounding to a phase may move it out of a band, or beyond the margin where it begins outside.
    if (x <= band_.origin.x - DotStencils::kEdge || x >= band_.origin.x + band_.size.x ||
        y <= band_.origin.y - DotStencils::kEdge || y >= band_.origin.y + band_.size.y)
        return;
    const DotStencils::Stencil& stencil =
        DotStencils::instance().at(dot.radius, phasesX & kInPixel, phasesY & kInPixel);
    const float scale = DotStencils::scaleOf(dot.radius) * dot.opacity / DotStencils::kWhole;
    for (int row = 0; row < DotStencils::kEdge; ++row) {
        std::uint16_t __attribute__((vector_size(8))) shares;
        static_assert(DotStencils::kEdge == 4);
        std::memcpy(&shares, stencil.data() + row * 4, sizeof shares);
        Pixel::coverFour(at(x, y + row), __builtin_convertvector(shares, Four) * scale, rgb);
    }
}

/// A pixel sees the edge of a large disc as straight; what that adds to the area is taken off the radius.
template <typename Pixel>
void BandCanvas<Pixel>::layLarge(const DotSplat& dot, const InkColour& rgb) {
    const float radius = std::sqrt(dot.radius * dot.radius - 1.0F / 12);
    const auto whole = [](std::int32_t units) { return units >= 0 ? units / DotSplat::kUnits : -(-units / 256) - 1; };
    const int middleX = whole(dot.x);
    const int middleY = whole(dot.y);
    const float fractionX = static_cast<float>(dot.x - middleX * DotSplat::kUnits) / DotSplat::kUnits - 0.5F;
    const float fractionY = static_cast<float>(dot.y - middleY * DotSplat::kUnits) / DotSplat::kUnits - 0.5F;
    const int reach = static_cast<int>(radius) + 2;
    const int left = std::max(band_.origin.x - middleX, -reach);
    const int right = std::min(band_.origin.x + band_.size.x - 1 - middleX, reach);
    const int top = std::max(band_.origin.y - middleY, -reach);
    const int bottom = std::min(band_.origin.y + band_.size.y - 1 - middleY, reach);
    const float inner = std::max(radius - 0.75F, 0.0F); // half a pixel's diagonal, and a little
    const float outer = radius + 0.75F;
    for (int row = top; row <= bottom; ++row) {
        const float dy = static_cast<float>(row) - fractionY;
        Pixel* pixels = at(middleX, middleY + row);
        for (int column = left; column <= right; ++column) {
            const float dx = static_cast<float>(column) - fractionX;
            const float square = dx * dx + dy * dy;
            if (square >= outer * outer)
                continue;
            float share = 1;
            if (square > inner * inner) {
                const float distance = std::sqrt(square);
                share = halfPlane(radius - distance, dx / distance, dy / distance);
            }
            pixels[column].cover(share * dot.opacity, rgb);
        }
    }
}

/// A pixel sees the line's edge as a ramp of a pixel, whatever its direction: `halfLength` makes up for what that adds
/// to the ends.
template <typename Pixel>
void BandCanvas<Pixel>::layLine(const StrokeSplat& stroke) {
    constexpr int kLanes = 4;
    const glm::vec2 along = stroke.along;
    const glm::vec2 middle = stroke.middle;
    const float reach = stroke.radius + 0.5F;
    const Four most = Four{} + std::min(2 * stroke.radius, 1.0F);
    const glm::vec2 box = glm::abs(along) * stroke.halfLength + reach;
    const Tile tile{band_.origin - stroke.origin, band_.size};
    const auto firstPixel = [](float from) {
        const int cut = static_cast<int>(from + 0.5F); // std::floor is a call where the processor's set is small
        return cut - (from + 0.5F < static_cast<float>(cut) ? 1 : 0);
    };
    const int top = std::max(tile.origin.y, firstPixel(middle.y - box.y));
    const int bottom = std::min(tile.origin.y + tile.size.y, firstPixel(middle.y + box.y));
    // Along a row the line's sides are this far to both sides of its middle; a line along rows is only cut at its ends.
    const float perRow = 1 / (std::max(std::abs(along.y), 1e-3F) * (along.y < 0 ? -1.0F : 1.0F));
    const float half = reach * std::abs(perRow);
    for (int y = top; y < bottom; ++y) {
        const float dy = static_cast<float>(y) + 0.5F - middle.y;
        const float centre = dy * along.x * perRow;
        // Fours begin where they do in the whole picture: what a pixel gets does not depend on the tile.
        int left = firstPixel(middle.x + std::max(centre - half, -box.x));
        left += std::max(tile.origin.x - left, 0) / kLanes * kLanes;
        const int right = std::min(tile.origin.x + tile.size.x, firstPixel(middle.x + std::min(centre + half, box.x)));
        for (int x = left; x < right; x += kLanes) {
            const Four dx = Four{0.5F, 1.5F, 2.5F, 3.5F} + static_cast<float>(x) - middle.x;
            const Four t = dx * along.x + dy * along.y;
            const Four beyond = t - atMost(atLeast0(t + stroke.halfLength), Four{} + 2 * stroke.halfLength) +
                                stroke.halfLength; // of the ends
            const Four d = dy * along.x - dx * along.y;
            const Four shares = atMost(atLeast0(reach - squareRoot(beyond * beyond + d * d)), most);
            Pixel::coverFour(at(x + stroke.origin.x, y + stroke.origin.y), shares * stroke.opacity, stroke.rgb);
        }
    }
}

} // namespace limner
