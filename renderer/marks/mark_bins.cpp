#include "renderer/marks/mark_bins.h"

#include "renderer/marks/stroke_outline.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <type_traits>

namespace limner {

namespace {

// Large enough that a chunk's parts of a band are worth a loop, small enough for the second-level cache.
constexpr std::size_t kDotsPerChunk = 4096;
constexpr std::size_t kStrokesPerChunk = 2048;
// Beyond any picture: such places are no drawing, and single precision does not count pixels there.
constexpr double kFarthest = 2e6;
// Points of an outlined stroke that are nearer to one another, in pixels, count as one: a line that turns back on
// itself within that would be drawn twice.
constexpr float kSamePlace = 0.05F;

// Rounded places and straight edges reach that many pixels farther than the dots themselves.
constexpr double kDotMargin = 0.25;

struct ToPixels {
    glm::dvec2 scale;
    double radiusScale;
    Tile tile;
    glm::ivec2 size;
};

struct BandRange {
    int from = 0;
    int to = 0; ///< exclusive
};

/// The bands between two rows, in units of dots' places; none where they miss the tile.
BandRange bandsOf(std::int32_t top, std::int32_t bottom, const Tile& tile) {
    constexpr int kBandUnits = kBandRows * DotSplat::kUnits;
    const std::int32_t first = tile.origin.y * DotSplat::kUnits;
    const std::int32_t from = std::max(top - first, 0);
    const std::int32_t to = std::min(bottom - first, tile.size.y * DotSplat::kUnits - 1);
    return from <= to ? BandRange{from / kBandUnits, to / kBandUnits + 1} : BandRange{};
}

/// Rounded down, for numbers within kFarthest.
std::int32_t unitsOf(double pixels) {
    constexpr auto kLift = static_cast<std::int32_t>(kFarthest);
    return static_cast<std::int32_t>((pixels + kLift) * DotSplat::kUnits) - kLift * DotSplat::kUnits;
}

bool inReach(const glm::dvec2& place, double radius) {
    return std::abs(place.x) < kFarthest && std::abs(place.y) < kFarthest && radius < kFarthest;
}

bool misses(double left, double right, const Tile& tile) {
    return !(right > tile.origin.x && left < tile.origin.x + tile.size.x);
}

/// Puts items into the order of their bands.
template <typename Splat>
Banded<Splat> inBandOrder(std::span<const Splat> items, std::span<const BandRange> ranges, std::size_t bands) {
    Banded<Splat> banded;
    std::vector<std::uint32_t> next(bands + 1, 0);
    for (const BandRange& range : ranges)
        for (int band = range.from; band < range.to; ++band)
            ++next[static_cast<std::size_t>(band) + 1];
    for (std::size_t band = 0; band < bands; ++band)
        next[band + 1] += next[band];
    banded.start = next;
    banded.splats.resize(next[bands]);
    for (std::size_t i = 0; i < items.size(); ++i)
        for (int band = ranges[i].from; band < ranges[i].to; ++band)
            banded.splats[next[static_cast<std::size_t>(band)]++] = items[i];
    return banded;
}

template <typename AnyDotSplat>
Banded<AnyDotSplat> sortDots(std::span<const Dot> dots, const ToPixels& to, std::size_t bands) {
    std::vector<AnyDotSplat> splats;
    std::vector<BandRange> ranges;
    splats.reserve(dots.size());
    ranges.reserve(dots.size());
    for (const Dot& dot : dots) {
        const glm::dvec2 place = glm::dvec2(dot.placeMm) * to.scale;
        const double radius = dot.radiusMm * to.radiusScale;
        if (!(radius > 0 && dot.opacity > 0 && inReach(place, radius) && std::isfinite(dot.depthMm)) ||
            misses(place.x - radius - kDotMargin, place.x + radius + kDotMargin, to.tile))
            continue;
        const BandRange range =
            bandsOf(unitsOf(place.y - radius - kDotMargin), unitsOf(place.y + radius + kDotMargin), to.tile);
        if (range.from == range.to)
            continue;
        AnyDotSplat& splat = splats.emplace_back();
        splat.x = unitsOf(place.x + 0.5 / DotSplat::kUnits);
        splat.y = unitsOf(place.y + 0.5 / DotSplat::kUnits);
        splat.radius = static_cast<float>(radius);
        splat.opacity = std::min(dot.opacity, 1.0F);
        if constexpr (std::is_same_v<AnyDotSplat, ColourDotSplat>) {
            splat.depth = dot.depthMm;
            splat.rgb = dot.rgb;
        }
        ranges.push_back(range);
    }
    return inBandOrder<AnyDotSplat>(splats, ranges, bands);
}

/// Takes an outline apart into the places of its chords.
class ChordSink {
  public:
    explicit ChordSink(std::vector<glm::vec2>& places) : places_(places) {}
    void moveTo(glm::vec2 place) { places_.push_back(place); }
    void lineTo(glm::vec2 place) { places_.push_back(place); }
    /// Chords at most 1/30 pixel off, their inner places moved out so that they enclose the arc's area.
    void arcTo(glm::vec2 centre, float radius, glm::vec2 from, glm::vec2 to) {
        constexpr float kFew = 3;
        const float angle = arcAngle(from, to);
        const float parts = std::max(kFew, std::ceil(angle * std::sqrt(1.8F * radius)));
        const float step = angle / parts;
        const float sine = std::sin(step);
        const float cosine = std::cos(step);
        const float wanted = parts * step / sine; // (parts - 2) g^2 + 2 g, g the factor on the inner radii
        const float out = radius * (std::sqrt(1 + (parts - 2) * wanted) - 1) / (parts - 2);
        glm::vec2 at = from;
        for (float part = 1; part < parts; ++part) {
            at = {at.x * cosine + at.y * sine, at.y * cosine - at.x * sine};
            places_.push_back(centre + at * out);
        }
        places_.push_back(centre + to * radius);
    }

  private:
    std::vector<glm::vec2>& places_;
};

struct Box {
    glm::dvec2 low{kFarthest};
    glm::dvec2 high{-kFarthest};
};

/// A stroke that is drawn as a short thin line: a pixel shows little of its edges' direction. False: it is not.
bool shortLine(std::span<const StrokePoint> points, const ToPixels& to, StrokeSplat& splat) {
    constexpr double kThin = 2;
    constexpr double kShort = 16;
    constexpr double kPoint = 0.01;
    constexpr double kPi = std::numbers::pi;
    if (points.size() != 2 || points[0].widthMm != points[1].widthMm)
        return false;
    const double width = points[0].widthMm * to.radiusScale;
    const glm::dvec2 a = glm::dvec2(points[0].placeMm) * to.scale;
    const glm::dvec2 step = glm::dvec2(points[1].placeMm) * to.scale - a;
    const double square = glm::dot(step, step);
    if (!(width > 0 && width <= kThin && square <= kShort * kShort && square > kPoint * kPoint && inReach(a, width)))
        return false;
    const double length = std::sqrt(square);
    const double radius = 0.5 * width;
    const glm::dvec2 middle = a + 0.5 * step;
    splat.origin = glm::ivec2(unitsOf(middle.x), unitsOf(middle.y)) / DotSplat::kUnits;
    splat.middle = glm::vec2(middle - glm::dvec2(splat.origin));
    splat.along = glm::vec2(step / length);
    splat.radius = static_cast<float>(radius);
    // Edges that are ramps of a pixel make a round end larger by that much; the line is shorter for it, or fainter.
    const double wanted = width * length + kPi * radius * radius;
    const double ends =
        radius < 0.5 ? kPi * (radius / 2 + 2 * radius * radius * radius / 3) : kPi * (radius * radius + 1.0 / 12);
    const double left = std::max((wanted - ends) / width, 0.0);
    splat.halfLength = static_cast<float>(0.5 * left);
    splat.opacity *= static_cast<float>(std::min(wanted / ends, 1.0));
    return true;
}

/// The stroke's points in pixels without repeated places; false where one is not finite or out of all reach.
bool strokePoints(std::span<const StrokePoint> points, const ToPixels& to, std::vector<OutlinePoint>& out, Box& box,
                  glm::ivec2& origin) {
    out.clear();
    for (const StrokePoint& point : points) {
        const glm::dvec2 place = glm::dvec2(point.placeMm) * to.scale;
        const double radius = 0.5 * point.widthMm * to.radiusScale;
        if (!(radius >= 0 && inReach(place, radius)))
            return false;
        box.low = glm::min(box.low, place - radius);
        box.high = glm::max(box.high, place + radius);
    }
    origin = {std::clamp(static_cast<int>(std::floor(box.low.x)), 0, to.size.x),
              static_cast<int>(std::floor(box.low.y))};
    for (const StrokePoint& point : points) {
        const OutlinePoint next{glm::vec2(glm::dvec2(point.placeMm) * to.scale - glm::dvec2(origin)),
                                static_cast<float>(0.5 * point.widthMm * to.radiusScale)};
        if (!out.empty() && glm::distance(out.back().place, next.place) < kSamePlace)
            out.back().radius = std::max(out.back().radius, next.radius);
        else
            out.push_back(next);
    }
    return true;
}

/// The bands that a stroke touches, and its splat; none where it is not to be drawn.
class StrokeSorter {
  public:
    StrokeSorter(const ToPixels& to, std::vector<glm::vec2>& places) : to_(to), places_(places) {}

    BandRange place(std::span<const StrokePoint> middle, StrokeSplat& splat) {
        if (shortLine(middle, to_, splat)) {
            // A pixel's middle sees the line from a pixel's width away, at most.
            const glm::vec2 reach = glm::abs(splat.along) * splat.halfLength + (splat.radius + 1);
            return bandsOf(glm::dvec2(splat.middle - reach) + glm::dvec2(splat.origin),
                           glm::dvec2(splat.middle + reach) + glm::dvec2(splat.origin));
        }
        Box box;
        if (!strokePoints(middle, to_, points_, box, splat.origin))
            return {};
        const BandRange range = bandsOf(box.low - 1.0, box.high + 1.0);
        if (range.from == range.to)
            return {};
        splat.firstPlace = static_cast<std::uint32_t>(places_.size());
        ChordSink sink(places_);
        traceStroke(points_, sink);
        splat.places = static_cast<std::uint32_t>(places_.size()) - splat.firstPlace;
        splat.extent = {std::min(static_cast<int>(std::ceil(box.high.x)) + 1, to_.size.x) - splat.origin.x,
                        static_cast<int>(std::ceil(box.high.y)) + 1 - splat.origin.y};
        return range;
    }

  private:
    [[nodiscard]] BandRange bandsOf(const glm::dvec2& low, const glm::dvec2& high) const {
        if (misses(low.x, high.x, to_.tile))
            return {};
        return limner::bandsOf(unitsOf(low.y), unitsOf(high.y), to_.tile);
    }

    const ToPixels& to_;
    std::vector<glm::vec2>& places_;
    std::vector<OutlinePoint> points_;
};

Banded<StrokeSplat> sortStrokes(const MarkGroup& group, std::size_t first, std::size_t end, const ToPixels& to,
                                std::size_t bands, std::vector<glm::vec2>& places) {
    std::vector<StrokeSplat> splats(end - first);
    std::vector<BandRange> ranges(end - first);
    std::size_t count = 0;
    StrokeSorter sorter(to, places);
    for (std::size_t i = first; i < end; ++i) {
        const Stroke& stroke = group.strokes[i];
        if (!(stroke.opacity > 0) || stroke.count == 0 ||
            stroke.first + std::size_t{stroke.count} > group.points.size())
            continue;
        StrokeSplat& splat = splats[count];
        splat.places = 0;
        splat.opacity = std::min(stroke.opacity, 1.0F);
        splat.rgb = stroke.rgb;
        ranges[count] = sorter.place(std::span(group.points).subspan(stroke.first, stroke.count), splat);
        if (ranges[count].from != ranges[count].to)
            ++count;
    }
    return inBandOrder<StrokeSplat>(std::span(splats).first(count), std::span(ranges).first(count), bands);
}

/// Dots [first, end) of a group, or its strokes.
struct ChunkWork {
    std::size_t group = 0;
    bool strokes = false;
    std::size_t first = 0;
    std::size_t end = 0;
};

std::vector<ChunkWork> cutIntoChunks(const Marks& marks) {
    std::vector<ChunkWork> works;
    const auto cut = [&](std::size_t group, bool strokes, std::size_t count, std::size_t length) {
        for (std::size_t first = 0; first < count; first += length)
            works.push_back({group, strokes, first, std::min(first + length, count)});
    };
    for (std::size_t g = 0; g < marks.groups.size(); ++g) {
        cut(g, false, marks.groups[g].dots.size(), kDotsPerChunk);
        cut(g, true, marks.groups[g].strokes.size(), kStrokesPerChunk);
    }
    return works;
}

bool allHave(const MarkGroup& group, const ChunkWork& work, const InkColour& ink) {
    const auto same = [&](const auto& marks) {
        return std::all_of(marks.begin() + static_cast<std::ptrdiff_t>(work.first),
                           marks.begin() + static_cast<std::ptrdiff_t>(work.end),
                           [&](const auto& mark) { return mark.rgb == ink; });
    };
    return work.strokes ? same(group.strokes) : same(group.dots);
}

/// Absent where `ink` is given and a mark has another colour.
template <typename AnyDotSplat>
std::optional<MarkBins<AnyDotSplat>> sorted(const Marks& marks, glm::ivec2 size, const Tile& tile,
                                            const InkColour* ink) {
    ToPixels to{glm::dvec2(size) / marks.paperMm, 1, tile, size};
    to.radiusScale = std::sqrt(to.scale.x * to.scale.y);
    MarkBins<AnyDotSplat> bins;
    bins.bands = static_cast<std::size_t>((tile.size.y + kBandRows - 1) / kBandRows);
    const std::vector<ChunkWork> works = cutIntoChunks(marks);
    bins.chunks.resize(works.size());
    std::atomic<bool> otherColour{false};
    tbb::parallel_for(std::size_t{0}, works.size(), [&](std::size_t i) {
        const ChunkWork& work = works[i];
        const MarkGroup& group = marks.groups[work.group];
        MarkChunk<AnyDotSplat>& chunk = bins.chunks[i];
        chunk.group = work.group;
        if (ink != nullptr && (otherColour || !allHave(group, work, *ink))) {
            otherColour = true;
            return;
        }
        if (work.strokes)
            chunk.strokes = sortStrokes(group, work.first, work.end, to, bins.bands, chunk.places);
        else
            chunk.dots =
                sortDots<AnyDotSplat>(std::span(group.dots).subspan(work.first, work.end - work.first), to, bins.bands);
    });
    if (otherColour)
        return std::nullopt;
    return bins;
}

} // namespace

MarkBins<ColourDotSplat> sortColours(const Marks& marks, glm::ivec2 size, const Tile& tile) {
    return *sorted<ColourDotSplat>(marks, size, tile, nullptr);
}

std::optional<MarkBins<DotSplat>> sortOneInk(const Marks& marks, const InkColour& ink, glm::ivec2 size,
                                             const Tile& tile) {
    return sorted<DotSplat>(marks, size, tile, &ink);
}

} // namespace limner
