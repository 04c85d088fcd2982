#include "renderer/marks/hatch_strokes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <tuple>

namespace limner {

namespace {

/// Share of paper below which there are no strokes at all.
constexpr float kLeastShare = 0.02F;
/// Distance of strokes in widths per share; growing strokes may come nearer than new ones.
constexpr float kApart = 0.8F;
constexpr float kGrowing = 0.65F;
/// Gap between the ends of strokes that follow one another, in widths.
constexpr float kGapWidths = 2;
/// Most turning per step that a hand makes.
constexpr float kLeastCosine = 0.85F;
/// Strokes shorter than this share of the length are not worth the pen.
constexpr float kShortest = 0.2F;
constexpr float kEndWidth = 0.35F;
constexpr float kTaper = 0.3F; ///< share of a stroke's length, at each end
constexpr float kThinnest = 0.4F;
constexpr float kThickest = 1.8F;
constexpr double kMostRaster = 6e6;

float hashed(std::uint32_t x) {
    x ^= x >> 16U;
    x *= 0x7FEB352DU;
    x ^= x >> 15U;
    x *= 0x846CA68BU;
    x ^= x >> 16U;
    return static_cast<float>(x >> 8U) / static_cast<float>(1U << 24U);
}

struct Sample {
    glm::vec2 mm{0};
    glm::vec2 direction{0};
    std::uint32_t stroke = 0;
    std::uint32_t point = 0;
};

/// Samples of strokes by their place on paper.
class SampleGrid {
  public:
    SampleGrid(const glm::dvec2& paperMm, float cellMm)
        : cellMm_(cellMm), size_(glm::ivec2(paperMm / static_cast<double>(cellMm)) + 1),
          cells_(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y)) {}

    void add(const Sample& sample) {
        const glm::ivec2 c = glm::clamp(glm::ivec2(glm::floor(sample.mm / cellMm_)), glm::ivec2(0), size_ - 1);
        cells_[indexOf(c)].push_back(sample);
    }

    /// Stops where `use` returns true.
    template <typename Use>
    bool any(const glm::vec2& mm, float radius, const Use& use) const {
        const glm::ivec2 low = glm::max(glm::ivec2(glm::floor((mm - radius) / cellMm_)), glm::ivec2(0));
        const glm::ivec2 high = glm::min(glm::ivec2(glm::floor((mm + radius) / cellMm_)), size_ - 1);
        for (int y = low.y; y <= high.y; ++y) {
            for (int x = low.x; x <= high.x; ++x) {
                for (const Sample& sample : cells_[indexOf({x, y})]) {
                    if (use(sample)) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

  private:
    [[nodiscard]] std::size_t indexOf(const glm::ivec2& c) const {
        return static_cast<std::size_t>(c.y) * static_cast<std::size_t>(size_.x) + static_cast<std::size_t>(c.x);
    }
    float cellMm_;
    glm::ivec2 size_;
    std::vector<std::vector<Sample>> cells_;
};

class Sheet {
  public:
    Sheet(const HatchMap& map, const HatchPen& pen, const glm::dvec2& paperMm)
        : map_(map), pen_(pen), paperMm_(paperMm), stepMm_(std::max(std::min(pen.lengthMm / 12, pen.widthMm), 0.02F)),
          grid_(paperMm, std::max(3 * pen.widthMm, 0.4F)) {}

    void start(const glm::vec2& from) {
        std::deque<std::uint32_t> fresh;
        if (tryStroke(from)) {
            fresh.push_back(static_cast<std::uint32_t>(strokes_.size() - 1));
        }
        for (; !fresh.empty(); fresh.pop_front()) {
            const std::vector<glm::vec2> points = strokes_[fresh.front()].points;
            for (std::size_t i = 0; i < points.size(); i += 3) {
                const std::optional<HatchPlace> place = map_.at(points[i], pen_.family);
                const float share = place ? pen_.share(place->tone) : 0;
                if (share < kLeastShare) {
                    continue;
                }
                const glm::vec2 aside = glm::vec2(-place->direction.y, place->direction.x) * (1.02F * apart(share));
                for (const glm::vec2& beside : {points[i] + aside, points[i] - aside}) {
                    if (tryStroke(beside)) {
                        fresh.push_back(static_cast<std::uint32_t>(strokes_.size() - 1));
                    }
                }
            }
        }
    }

    std::vector<HatchStroke> finish() {
        setWidths();
        return std::move(strokes_);
    }

  private:
    [[nodiscard]] float apart(float share) const { return kApart * pen_.widthMm / share; }

    /// Whether another stroke is too near: beside by the distance, ahead by a gap.
    [[nodiscard]] bool crowded(const glm::vec2& mm, const glm::vec2& direction, float beside) const {
        const float ahead = std::min(beside, kGapWidths * pen_.widthMm + 0.1F * beside);
        return grid_.any(mm, beside, [&](const Sample& sample) {
            const glm::vec2 d = sample.mm - mm;
            const float along = glm::dot(d, direction) / ahead;
            const float across = (d.x * direction.y - d.y * direction.x) / beside;
            return along * along + across * across < 1;
        });
    }

    bool tryStroke(const glm::vec2& from) {
        const std::optional<HatchPlace> place = map_.at(from, pen_.family);
        const float share = place ? pen_.share(place->tone) : 0;
        if (share < kLeastShare || crowded(from, place->direction, apart(share))) {
            return false;
        }
        const auto number = static_cast<std::uint32_t>(strokes_.size());
        const float length = pen_.lengthMm * (0.75F + 0.5F * hashed(number * 2 + pen_.seed * 7919U));
        // The longer part lies on either side.
        const float before = length * (0.3F + 0.4F * hashed(number * 2 + 1 + pen_.seed * 7919U));
        std::vector<glm::vec2> points = grow(from, *place, -place->direction, before);
        std::reverse(points.begin(), points.end());
        points.push_back(from);
        const float grown = static_cast<float>(points.size() - 1) * stepMm_;
        const std::vector<glm::vec2> after = grow(from, *place, place->direction, length - grown);
        points.insert(points.end(), after.begin(), after.end());
        if (points.size() < 3 || static_cast<float>(points.size() - 1) * stepMm_ < kShortest * pen_.lengthMm) {
            return false;
        }
        for (std::size_t i = 0; i < points.size(); ++i) {
            const glm::vec2 way = points[std::min(i + 1, points.size() - 1)] - points[i > 0 ? i - 1 : 0];
            grid_.add({points[i], glm::normalize(way), number, static_cast<std::uint32_t>(i)});
        }
        strokes_.push_back({std::move(points), {}, place->voxel});
        return true;
    }

    /// Points after the first one, in steps, as far as the surface, the tone and other strokes let it go.
    [[nodiscard]] std::vector<glm::vec2> grow(const glm::vec2& from, const HatchPlace& start, glm::vec2 direction,
                                              float length) const {
        std::vector<glm::vec2> points;
        glm::vec2 mm = from;
        float depth = start.depthMm;
        const auto steps = static_cast<int>(length / stepMm_);
        for (int step = 0; step < steps; ++step) {
            const std::optional<HatchPlace> middle = map_.at(mm + 0.5F * stepMm_ * direction, pen_.family, depth);
            if (!middle) {
                break;
            }
            const float cosine = glm::dot(middle->direction, direction);
            if (std::abs(cosine) < kLeastCosine) {
                break;
            }
            direction = cosine > 0 ? middle->direction : -middle->direction;
            const glm::vec2 next = mm + stepMm_ * direction;
            const std::optional<HatchPlace> place = map_.at(next, pen_.family, depth);
            const float share = place ? pen_.share(place->tone) : 0;
            if (share < kLeastShare || next.x < 0 || next.y < 0 || next.x > static_cast<float>(paperMm_.x) ||
                next.y > static_cast<float>(paperMm_.y) || crowded(next, direction, kGrowing * apart(share))) {
                break;
            }
            mm = next;
            depth = place->depthMm;
            points.push_back(mm);
        }
        return points;
    }

    /// The point of a stroke that lays the ink of a place.
    struct Owner {
        std::uint32_t stroke = 0;
        std::uint32_t point = 0;
        float ink = 0;
    };

    [[nodiscard]] Owner nearestTo(const glm::vec2& mm, float reach, float ink) const {
        Owner owner;
        float nearest = reach * reach;
        grid_.any(mm, reach, [&](const Sample& sample) {
            const glm::vec2 d = sample.mm - mm;
            const float far = glm::dot(d, d);
            if (far < nearest || (far == nearest && owner.ink > 0 &&
                                  std::tie(sample.stroke, sample.point) < std::tie(owner.stroke, owner.point))) {
                nearest = far;
                owner = {sample.stroke, sample.point, ink};
            }
            return false;
        });
        return owner;
    }

    /// Ink that every point's stroke has to lay: the share of the paper that is nearest to it.
    [[nodiscard]] std::vector<std::vector<double>> inkOfPoints() const {
        const double rasterMm =
            std::max(0.6 * static_cast<double>(pen_.widthMm), std::sqrt(paperMm_.x * paperMm_.y / kMostRaster));
        const glm::ivec2 size(glm::ceil(paperMm_ / rasterMm));
        std::vector<std::vector<double>> ink(strokes_.size());
        for (std::size_t i = 0; i < strokes_.size(); ++i) {
            ink[i].resize(strokes_[i].points.size(), 0);
        }
        constexpr int band = 64;
        std::vector<Owner> owners(static_cast<std::size_t>(size.x) * band);
        for (int top = 0; top < size.y; top += band) {
            const int rows = std::min(band, size.y - top);
            tbb::parallel_for(0, rows, [&](int row) {
                for (int x = 0; x < size.x; ++x) {
                    const glm::vec2 mm((glm::dvec2(x, top + row) + 0.5) * rasterMm);
                    const float share = pen_.share(map_.toneAt(mm));
                    Owner owner;
                    if (share >= kLeastShare) {
                        // Most paper has a stroke beside it.
                        for (const float reach : {0.6F * apart(share), 1.6F * apart(share)}) {
                            owner = nearestTo(mm, reach, share);
                            if (owner.ink > 0) {
                                break;
                            }
                        }
                    }
                    owners[static_cast<std::size_t>(row) * static_cast<std::size_t>(size.x) +
                           static_cast<std::size_t>(x)] = owner;
                }
            });
            const std::size_t count = static_cast<std::size_t>(rows) * static_cast<std::size_t>(size.x);
            for (std::size_t i = 0; i < count; ++i) {
                if (owners[i].ink > 0) {
                    ink[owners[i].stroke][owners[i].point] += static_cast<double>(owners[i].ink) * rasterMm * rasterMm;
                }
            }
        }
        return ink;
    }

    void setWidths() {
        const std::vector<std::vector<double>> ink = inkOfPoints();
        tbb::parallel_for(std::size_t{0}, strokes_.size(), [&](std::size_t i) { setWidthsOf(strokes_[i], ink[i]); });
    }

    /// Smooth along the stroke, thin at its ends, with all the ink that was asked for.
    void setWidthsOf(HatchStroke& stroke, const std::vector<double>& ink) const {
        const auto count = static_cast<int>(stroke.points.size());
        const int reach = std::max(count / 4, 1);
        const auto at = [](auto& all, int i) -> auto& { return all[static_cast<std::size_t>(i)]; };
        std::vector<float> widths(stroke.points.size());
        double asked = 0;
        double laid = 0;
        for (int i = 0; i < count; ++i) {
            double sum = 0;
            double weights = 0;
            for (int k = std::max(i - reach, 0); k <= std::min(i + reach, count - 1); ++k) {
                const double weight = reach + 1 - std::abs(k - i);
                sum += weight * at(ink, k);
                weights += weight;
            }
            const float end = static_cast<float>(std::min(i, count - 1 - i)) / (kTaper * static_cast<float>(count - 1));
            const float t = std::min(end, 1.0F);
            at(widths, i) = static_cast<float>(sum / weights) * (kEndWidth + (1 - kEndWidth) * t * (2 - t));
            asked += at(ink, i);
            laid += static_cast<double>(at(widths, i)) * (i == 0 || i == count - 1 ? 0.5 : 1);
        }
        const auto factor = static_cast<float>(laid > 0 ? asked / laid : 0) / stepMm_;
        for (float& width : widths) {
            width = std::clamp(width * factor, kThinnest * kEndWidth * pen_.widthMm, kThickest * pen_.widthMm);
        }
        stroke.widths = std::move(widths);
    }

    const HatchMap& map_;
    const HatchPen& pen_;
    glm::dvec2 paperMm_;
    float stepMm_;
    SampleGrid grid_;
    std::vector<HatchStroke> strokes_;
};

} // namespace

std::vector<HatchStroke> layStrokes(const HatchMap& map, const HatchPen& pen, const glm::dvec2& paperMm,
                                    const std::vector<glm::vec2>& starts) {
    Sheet sheet(map, pen, paperMm);
    for (const glm::vec2& start : starts) {
        sheet.start(start);
    }
    return sheet.finish();
}

} // namespace limner
