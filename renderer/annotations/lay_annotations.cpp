#include "renderer/annotations.h"
#include "renderer/annotations/area_fill.h"
#include "renderer/marks/lay_marks.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace limner {
namespace {

/// A tile of a picture, and how paper lies on it.
struct Ground {
    glm::dvec2 pixelsPerMm;
    const Tile& tile;
    Picture& picture;

    void cover(glm::ivec2 place, float share, const glm::vec3& rgb) const {
        const glm::ivec2 at = place - tile.origin;
        if (at.x < 0 || at.y < 0 || at.x >= tile.size.x || at.y >= tile.size.y || !(share > 0)) {
            return;
        }
        float* pixel = picture.pixel(at.x, at.y);
        for (int c = 0; c < 3; ++c) {
            pixel[c] = rgb[c] * share + pixel[c] * (1 - share);
        }
        pixel[3] = share + pixel[3] * (1 - share);
    }
    void cover(const Coverage& area, const glm::vec3& rgb) const {
        const float* share = area.shares.data();
        for (int y = 0; y < area.size.y; ++y) {
            for (int x = 0; x < area.size.x; ++x) {
                cover(area.origin + glm::ivec2(x, y), *share++, rgb);
            }
        }
    }
    [[nodiscard]] bool reaches(const glm::dvec2& lowMm, const glm::dvec2& highMm) const {
        const glm::dvec2 low = lowMm * pixelsPerMm - glm::dvec2(tile.origin);
        const glm::dvec2 high = highMm * pixelsPerMm - glm::dvec2(tile.origin);
        return high.x > -1 && high.y > -1 && low.x < tile.size.x + 1 && low.y < tile.size.y + 1;
    }
};

glm::vec3 floats(const InkColour& rgb) { return glm::vec3(rgb) / 255.0F; }

/// Outlines as polygons in pixels, curves in so many pieces that no piece is farther off than the eye or an eighth
/// of a grey level sees.
class Flattener {
  public:
    std::vector<glm::dvec2> points;
    std::vector<std::size_t> counts;

    template <class Map>
    void add(const GlyphOutline& outline, Map toPixels) {
        const glm::dvec2* next = outline.points.data();
        for (const GlyphOutline::Step step : outline.steps) {
            switch (step) {
            case GlyphOutline::Step::move:
                counts.push_back(0);
                put(toPixels(next[0]));
                next += 1;
                break;
            case GlyphOutline::Step::line:
                put(toPixels(next[0]));
                next += 1;
                break;
            case GlyphOutline::Step::conic: {
                const glm::dvec2 control = toPixels(next[0]);
                const glm::dvec2 end = toPixels(next[1]);
                const glm::dvec2 start = points.back();
                cubic(start + (control - start) * (2.0 / 3), end + (control - end) * (2.0 / 3), end);
                next += 2;
                break;
            }
            case GlyphOutline::Step::cubic:
                cubic(toPixels(next[0]), toPixels(next[1]), toPixels(next[2]));
                next += 3;
                break;
            }
        }
    }

  private:
    void put(const glm::dvec2& place) {
        points.push_back(place);
        ++counts.back();
    }
    void cubic(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& end) {
        const glm::dvec2 start = points.back();
        const double bend = std::max(glm::length(start - 2.0 * a + b), glm::length(a - 2.0 * b + end));
        constexpr double kOff = 0.02; // pixels
        const int pieces = std::clamp(static_cast<int>(std::ceil(std::sqrt(0.75 * bend / kOff))), 1, 64);
        for (int i = 1; i <= pieces; ++i) {
            const double t = static_cast<double>(i) / pieces;
            const double s = 1 - t;
            put(s * s * s * start + 3 * s * s * t * a + 3 * s * t * t * b + t * t * t * end);
        }
    }
};

void layText(const PaperText& text, const Ground& ground) {
    const glm::vec3 rgb = floats(text.rgb);
    for (const TextRun& run : text.block.runs) {
        const FaceMetrics& metrics = run.face->metrics();
        const double shear = run.face->source().slanted ? FontFace::kShear : 0;
        for (const ShapedGlyph& glyph : run.glyphs) {
            const glm::dvec2 origin = text.atMm + run.originMm + glm::dvec2(glyph.place.x, -glyph.place.y) * run.emMm;
            const glm::dvec2 low(metrics.lowest.x - 1, -metrics.highest.y);
            const glm::dvec2 high(metrics.highest.x + 1, -metrics.lowest.y);
            if (!ground.reaches(origin + low * run.emMm, origin + high * run.emMm)) {
                continue;
            }
            Flattener shape;
            shape.add(run.face->outline(glyph.id), [&](const glm::dvec2& em) {
                return (origin + glm::dvec2(em.x + shear * em.y, -em.y) * run.emMm) * ground.pixelsPerMm;
            });
            ground.cover(
                fillArea(shape.points, shape.counts, ground.tile.origin.y, ground.tile.origin.y + ground.tile.size.y),
                rgb);
        }
    }
}

void layBar(const PaperBar& bar, const Ground& ground) {
    const glm::dvec2 low = bar.box.lowMm * ground.pixelsPerMm;
    const glm::dvec2 high = bar.box.highMm * ground.pixelsPerMm;
    const glm::dvec2 corners[] = {low, {high.x, low.y}, high, {low.x, high.y}};
    const std::size_t count = std::size(corners);
    ground.cover(fillArea(corners, {&count, 1}, ground.tile.origin.y, ground.tile.origin.y + ground.tile.size.y),
                 floats(bar.rgb));
}

void layBall(const PaperBall& ball, const Ground& ground) {
    const glm::dvec2 centre = ball.centreMm * ground.pixelsPerMm;
    const glm::dvec2 radius = ball.radiusMm * ground.pixelsPerMm;
    const glm::ivec2 low = glm::max(glm::ivec2(glm::floor(centre - radius)), ground.tile.origin);
    const glm::ivec2 high = glm::min(glm::ivec2(glm::ceil(centre + radius)), ground.tile.origin + ground.tile.size);
    for (int y = low.y; y < high.y; ++y) {
        for (int x = low.x; x < high.x; ++x) {
            const glm::dvec2 place = (glm::dvec2(x, y) + 0.5 - centre) / radius;
            const double inside = radius.x * (1 - glm::length(place));
            glm::vec3 rgb = floats(ball.rgb);
            if (ball.sphere) {
                const Rgba c = ball.sphere->at(place.x, -place.y);
                rgb = glm::vec3(c.r, c.g, c.b) * c.a + (1 - c.a); // as it looks on white paper
            }
            ground.cover({x, y}, static_cast<float>(std::clamp(inside + 0.5, 0.0, 1.0)), rgb);
        }
    }
}

} // namespace

void layAnnotations(const DrawnAnnotations& annotations, glm::ivec2 size, const Tile& tile, Picture& picture) {
    if (annotations.empty()) {
        return;
    }
    layMarks(annotations.lines, size, tile, picture);
    const Ground ground{glm::dvec2(size) / annotations.paperMm, tile, picture};
    for (const PaperBar& bar : annotations.bars) {
        layBar(bar, ground);
    }
    for (const PaperBall& ball : annotations.balls) {
        layBall(ball, ground);
    }
    for (const PaperText& text : annotations.texts) {
        layText(text, ground);
    }
}

} // namespace limner
