#include "renderer/marks/mark_bins.h"

#include "renderer/marks/stroke_outline.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace limner {

namespace {

// Large enough that a chunk's parts of a band are worth a loop, small enough for the second-level cache.
constexpr std::size_t kDotsPerChunk = 4096;
constexpr std::size_t kStrokesPerChunk = 2048;
// Beyond any picture: such places are no drawing, and single precision does not count pixels there.
constexpr double kFarthest = 2e6;

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
    constexpr int kBandUnits = MarkBins::kBandRows * DotSplat::kUnits;
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

/// Puts items into the order of their bands: `start` becomes each band's first place in the order.
template <typename Item>
std::vector<Item> inBandOrder(const std::vector<Item>& items, const std::vector<BandRange>& ranges, std::size_t bands,
                              std::vector<std::uint32_t>& start) {
    start.assign(bands + 1, 0);
    for (const BandRange& range : ranges)
        for (int band = range.from; band < range.to; ++band)
            ++start[static_cast<std::size_t>(band) + 1];
    for (std::size_t band = 0; band < bands; ++band)
        start[band + 1] += start[band];
    std::vector<Item> ordered(start[bands]);
    std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
    for (std::size_t i = 0; i < items.size(); ++i)
        for (int band = ranges[i].from; band < ranges[i].to; ++band)
            ordered[next[static_cast<std::size_t>(band)]++] = items[i];
    return ordered;
}

void sortDots(std::span<const Dot> dots, const ToPixels& to, std::size_t bands, MarkChunk& chunk) {
    std::vector<DotSplat> splats;
    std::vector<BandRange> ranges;
    splats.reserve(dots.size());
    ranges.reserve(dots.size());
    const InkColour first = dots.front().rgb;
    bool oneColour = true;
    for (const Dot& dot : dots) {
        oneColour = oneColour && dot.rgb == first;
        const glm::dvec2 place = glm::dvec2(dot.placeMm) * to.scale;
        const double radius = dot.radiusMm * to.radiusScale;
        if (!(radius > 0 && dot.opacity > 0 && inReach(place, radius) && std::isfinite(dot.depthMm)) ||
            misses(place.x - radius - kDotMargin, place.x + radius + kDotMargin, to.tile))
            continue;
        const BandRange range =
            bandsOf(unitsOf(place.y - radius - kDotMargin), unitsOf(place.y + radius + kDotMargin), to.tile);
        if (range.from == range.to)
            continue;
        splats.push_back({unitsOf(place.x + 0.5 / DotSplat::kUnits), unitsOf(place.y + 0.5 / DotSplat::kUnits),
                          static_cast<float>(radius), std::min(dot.opacity, 1.0F), dot.depthMm, dot.rgb});
        ranges.push_back(range);
    }
    chunk.rgb = first;
    chunk.oneColour = oneColour;
    chunk.dots = inBandOrder(splats, ranges, bands, chunk.dotStart);
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

/// Whether the stroke is drawn as a short thin line: the ends' roundness is less than a pixel shows.
bool isShortLine(std::span<const StrokePoint> points, const ToPixels& to) {
    constexpr double kThin = 1.25;
    constexpr double kShort = 16;
    if (points.size() != 2 || points[0].widthMm != points[1].widthMm)
        return false;
    const double length =
        glm::distance(glm::dvec2(points[0].placeMm) * to.scale, glm::dvec2(points[1].placeMm) * to.scale);
    return points[0].widthMm * to.radiusScale <= kThin && length <= kShort && length > 0.01;
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
        if (!out.empty() && glm::distance(out.back().place, next.place) < 1e-3F)
            out.back().radius = std::max(out.back().radius, next.radius);
        else
            out.push_back(next);
    }
    return true;
}

void sortStrokes(const MarkGroup& group, std::size_t first, std::size_t end, const ToPixels& to, std::size_t bands,
                 MarkChunk& chunk) {
    std::vector<BandRange> ranges;
    std::vector<StrokeSplat> splats;
    std::vector<OutlinePoint> points;
    ChordSink sink(chunk.places);
    chunk.rgb = group.strokes[first].rgb;
    for (std::size_t i = first; i < end; ++i) {
        const Stroke& stroke = group.strokes[i];
        chunk.oneColour = chunk.oneColour && stroke.rgb == chunk.rgb;
        if (!(stroke.opacity > 0) || stroke.count == 0 ||
            stroke.first + std::size_t{stroke.count} > group.points.size())
            continue;
        Box box;
        glm::ivec2 origin;
        const auto middle = std::span(group.points).subspan(stroke.first, stroke.count);
        if (!strokePoints(middle, to, points, box, origin) || misses(box.low.x - 1, box.high.x + 1, to.tile))
            continue;
        const BandRange range = bandsOf(unitsOf(box.low.y - 1), unitsOf(box.high.y + 1), to.tile);
        if (range.from == range.to)
            continue;
        StrokeSplat splat;
        splat.firstPlace = static_cast<std::uint32_t>(chunk.places.size());
        if (isShortLine(middle, to)) {
            splat.from = points[0].place;
            splat.to = points[1].place;
            splat.radius = points[0].radius;
        } else
            traceStroke(points, sink);
        splat.places = static_cast<std::uint32_t>(chunk.places.size()) - splat.firstPlace;
        splat.origin = origin;
        splat.extent = {std::min(static_cast<int>(std::ceil(box.high.x)) + 1, to.size.x) - origin.x,
                        static_cast<int>(std::ceil(box.high.y)) + 1 - origin.y};
        splat.opacity = std::min(stroke.opacity, 1.0F);
        splat.rgb = stroke.rgb;
        splats.push_back(splat);
        ranges.push_back(range);
    }
    chunk.strokes = inBandOrder(splats, ranges, bands, chunk.strokeStart);
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

} // namespace

MarkBins sortIntoBands(const Marks& marks, glm::ivec2 size, const Tile& tile) {
    ToPixels to{glm::dvec2(size) / marks.paperMm, 1, tile, size};
    to.radiusScale = std::sqrt(to.scale.x * to.scale.y);
    MarkBins bins;
    bins.bands = static_cast<std::size_t>((tile.size.y + MarkBins::kBandRows - 1) / MarkBins::kBandRows);
    const std::vector<ChunkWork> works = cutIntoChunks(marks);
    bins.chunks.resize(works.size());
    tbb::parallel_for(std::size_t{0}, works.size(), [&](std::size_t i) {
        const ChunkWork& work = works[i];
        const MarkGroup& group = marks.groups[work.group];
        MarkChunk& chunk = bins.chunks[i];
        chunk.group = work.group;
        chunk.dotStart.assign(bins.bands + 1, 0);
        chunk.strokeStart.assign(bins.bands + 1, 0);
        if (work.strokes)
            sortStrokes(group, work.first, work.end, to, bins.bands, chunk);
        else
            sortDots(std::span(group.dots).subspan(work.first, work.end - work.first), to, bins.bands, chunk);
    });
    if (!bins.chunks.empty())
        bins.rgb = bins.chunks.front().rgb;
    for (const MarkChunk& chunk : bins.chunks)
        bins.oneColour = bins.oneColour && chunk.oneColour && chunk.rgb == bins.rgb;
    return bins;
}

} // namespace limner
