#include "renderer/marks/hatching.h"

#include "renderer/marks/hatch_map.h"
#include "renderer/marks/hatch_strokes.h"
#include "renderer/marks/mixed_bits.h"
#include "renderer/marks/pen.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>

namespace limner {

namespace {

constexpr float kFullest = 0.97F;
constexpr std::size_t kChunk = 1U << 13U;
/// Straight strokes leave a bent surface: at most this share of its radius.
constexpr float kStraight = 0.8F;

/// How a tone is shared between strokes and those that cross them: both at random cover 1 - (1 - a)(1 - b).
struct Shares {
    float cross;
    [[nodiscard]] float along(float tone) const { return std::min({tone, cross, kFullest}); }
    [[nodiscard]] float across(float tone) const {
        return tone > cross ? std::min((tone - cross) / (1 - cross), kFullest) : 0;
    }
};

/// Where strokes start: inked voxels in an order that has nothing to do with their places.
std::vector<glm::vec2> startsOf(const LineScene& scene, std::span<const float> tone, std::uint32_t seed) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> order;
    for (std::uint32_t i = 0; i < tone.size(); ++i) {
        if (tone[i] > 0) {
            order.emplace_back(mixedBits(i ^ mixedBits(seed)), i);
        }
    }
    tbb::parallel_sort(order.begin(), order.end());
    std::vector<glm::vec2> starts;
    starts.reserve(order.size());
    for (const auto& [key, i] : order) {
        const PlaceOnPaper at = scene.view.place(scene.field.placeMm(scene.field.voxels[i]));
        if (at.scale > 0) {
            starts.push_back(at.mm);
        }
    }
    return starts;
}

InkColour inkOf(const LineScene& scene, std::span<const InkColour> colours, std::size_t voxel) {
    return colours.empty() ? scene.ink : colours[voxel];
}

std::size_t layerOf(const LineScene& scene, std::size_t voxel, std::size_t layers) {
    return std::min<std::size_t>(scene.field.voxels[voxel].layer, layers - 1);
}

std::vector<PennedLines> stillStrokes(const LineScene& scene, const StippleHatching& settings,
                                      std::span<const float> tone, std::span<const InkColour> colours,
                                      std::uint32_t seed) {
    const HatchMap map(scene, tone);
    const std::vector<glm::vec2> starts = startsOf(scene, tone, seed);
    const Shares shares{static_cast<float>(std::clamp(settings.cross, 0.0, 1.0))};
    std::vector<PennedLines> layers(std::max<std::size_t>(scene.field.layerNames.size(), 1));
    for (const HatchMap::Family family : {HatchMap::Family::along, HatchMap::Family::across}) {
        const bool along = family == HatchMap::Family::along;
        if (!along && !(shares.cross < 1)) {
            continue;
        }
        const HatchPen pen{family, static_cast<float>(settings.lengthMm), static_cast<float>(settings.widthMm),
                           [&shares, along](float asked) { return along ? shares.along(asked) : shares.across(asked); },
                           seed + (along ? 0U : 1U)};
        for (const HatchStroke& stroke : layStrokes(map, pen, scene.view.paperMm(), starts)) {
            MarkGroup& group = layers[layerOf(scene, stroke.voxel, layers.size())].visible;
            group.strokes.push_back({static_cast<std::uint32_t>(group.points.size()),
                                     static_cast<std::uint32_t>(stroke.points.size()), 1,
                                     inkOf(scene, colours, stroke.voxel)});
            for (std::size_t i = 0; i < stroke.points.size(); ++i) {
                group.points.push_back({stroke.points[i], stroke.widths[i]});
            }
        }
    }
    return layers;
}

/// Straight strokes that belong to voxels.
class MovingStrokes {
  public:
    MovingStrokes(const LineScene& scene, const StippleHatching& settings, std::uint32_t seed)
        : scene_(scene), settings_(settings),
          seed_(mixedBits(seed)), shares_{static_cast<float>(std::clamp(settings.cross, 0.0, 1.0))},
          curved_(scene.field.curvatures.size() == scene.field.voxels.size()) {}

    /// Both families' strokes of a voxel.
    void add(std::size_t i, float tone, const InkColour& ink, MarkGroup& group) const {
        const MarkVoxel& voxel = scene_.field.voxels[i];
        const glm::dvec3 mm =
            scene_.field.placeMm(voxel) + glm::dvec3(voxel.normalMm) * static_cast<double>(voxel.edgeOffsetMm);
        const PlaceOnPaper at = scene_.view.place(mm);
        if (!(at.scale > 0) || !scene_.view.kept(mm)) {
            return;
        }
        const MarkCurvature bend = curved_ ? scene_.field.curvatures[i] : MarkCurvature{};
        glm::vec3 way = bend.directionMm;
        if (!(glm::dot(way, way) > 0.5F)) {
            const glm::vec3 up(scene_.view.frame().up);
            way = up - voxel.normalMm * glm::dot(up, voxel.normalMm);
        }
        const auto edge = static_cast<float>(scene_.field.mmPerVoxel) * at.scale;
        const float facing = std::abs(glm::dot(voxel.normalMm, scene_.view.towardsEye(mm)));
        const float area = edge * edge * facing * voxel.share; // of paper that is the voxel's
        const auto number = static_cast<std::uint32_t>(i) * 2U;
        addOne(at, way, bend.most, shares_.along(tone) * area, mixedBits(number ^ seed_), ink, group);
        addOne(at, glm::cross(voxel.normalMm, way), bend.least, shares_.across(tone) * area,
               mixedBits((number + 1) ^ seed_), ink, group);
    }

  private:
    void addOne(const PlaceOnPaper& at, const glm::vec3& way, float bend, float inkMm2, std::uint32_t hash,
                const InkColour& ink, MarkGroup& group) const {
        const glm::vec3 seen = scene_.view.seen(way);
        const float size = glm::length(glm::vec2(seen));
        if (!(size > 0.05F) || !(inkMm2 > 0)) {
            return;
        }
        const float radius = at.scale / std::max(std::abs(bend), 1e-6F);
        const auto width = static_cast<float>(settings_.widthMm);
        const float length =
            std::max(std::min(static_cast<float>(settings_.lengthMm), 2 * kStraight * radius) * size, 2 * width);
        const float expected = inkMm2 / (0.8F * length * width);
        const float shown = expected - static_cast<float>(hash >> 8U) / static_cast<float>(1U << 24U);
        if (shown <= 0) {
            return;
        }
        const glm::vec2 half = glm::vec2(seen.x, -seen.y) / size * (0.5F * length);
        group.strokes.push_back({static_cast<std::uint32_t>(group.points.size()), 3,
                                 std::min(shown / std::min(0.2F, 0.5F * expected), 1.0F), ink});
        group.points.push_back({at.mm - half, 0.4F * width});
        group.points.push_back({at.mm, 1.2F * width});
        group.points.push_back({at.mm + half, 0.4F * width});
    }

    const LineScene& scene_;
    const StippleHatching& settings_;
    std::uint32_t seed_;
    Shares shares_;
    bool curved_;
};

std::vector<PennedLines> movingStrokes(const LineScene& scene, const StippleHatching& settings,
                                       std::span<const float> tone, std::span<const InkColour> colours,
                                       std::uint32_t seed) {
    const MovingStrokes strokes(scene, settings, seed);
    const std::size_t layers = std::max<std::size_t>(scene.field.layerNames.size(), 1);
    std::vector<std::vector<PennedLines>> parts((tone.size() + kChunk - 1) / kChunk, std::vector<PennedLines>(layers));
    tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t part) {
        for (std::size_t i = part * kChunk; i < std::min((part + 1) * kChunk, tone.size()); ++i) {
            if (tone[i] > 0) {
                strokes.add(i, tone[i], inkOf(scene, colours, i), parts[part][layerOf(scene, i, layers)].visible);
            }
        }
    });
    return inOneOrder(parts, layers);
}

} // namespace

std::vector<MarkGroup> drawHatching(const LineScene& scene, const StippleHatching& settings,
                                    std::span<const float> tone, std::span<const InkColour> colours,
                                    std::uint32_t seed) {
    if (tone.empty() || tone.size() != scene.field.voxels.size() || !(settings.lengthMm > 0) ||
        !(settings.widthMm > 0)) {
        return {};
    }
    return namedGroups(scene,
                       scene.moving ? movingStrokes(scene, settings, tone, colours, seed)
                                    : stillStrokes(scene, settings, tone, colours, seed),
                       "Hatching");
}

} // namespace limner
