#include "renderer/marks/curves.h"

#include "renderer/marks/neighbours.h"
#include "renderer/marks/pen.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace limner {

namespace {

/// A silhouette lies at the edge of matter, whose discs reach around it: it is seen where a place this far outside is.
constexpr float kOutsideVoxels[] = {0, 1, 2.2F};
/// Bends, in lines' radius on paper: thin lines where the form is flatter.
constexpr float kBendMm = 8;
constexpr float kThinnest = 0.4F;
constexpr float kThickest = 1.3F;
/// Moving: voxels further from the surface than this draw what their neighbours draw.
constexpr float kNearVoxels = 0.55F;
/// Still: |n.e| below which a voxel may be at a silhouette although none beside it turns the other way.
constexpr float kTurning = 0.12F;
constexpr double kShortestVoxels = 8;
/// Lines go on where the gradient is lower than asked for, down to this share.
constexpr float kGoesOn = 0.6F;
constexpr std::size_t kChunk = 1U << 14U;

struct DepthRange {
    float low = std::numeric_limits<float>::max();
    float high = std::numeric_limits<float>::lowest();
};

DepthRange depthsOf(const LineScene& scene) {
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, scene.field.voxels.size(), kChunk), DepthRange{},
        [&](const tbb::blocked_range<std::size_t>& part, DepthRange range) {
            for (std::size_t i = part.begin(); i < part.end(); ++i) {
                const float depth = scene.view.place(scene.field.placeMm(scene.field.voxels[i])).depthMm;
                range = {std::min(range.low, depth), std::max(range.high, depth)};
            }
            return range;
        },
        [](const DepthRange& a, const DepthRange& b) {
            return DepthRange{std::min(a.low, b.low), std::max(a.high, b.high)};
        });
}

/// Widths of silhouettes as shares of the pen's.
class SilhouetteWidth {
  public:
    SilhouetteWidth(const LineScene& scene, const std::string& by)
        : byDepth_(by == "depth"), byBend_(by == "curvature"), depths_(byDepth_ ? depthsOf(scene) : DepthRange{}) {}

    /// `bend`: of the surface along the view, 1/mm.
    [[nodiscard]] float at(const PlaceOnPaper& place, float bend) const {
        if (byDepth_) {
            const float t = (place.depthMm - depths_.low) / std::max(depths_.high - depths_.low, 1e-6F);
            return glm::mix(kThinnest, kThickest, std::clamp(t, 0.0F, 1.0F));
        }
        if (byBend_) {
            return glm::mix(kThinnest, kThickest, 1 - std::exp(-kBendMm * std::abs(bend) / place.scale));
        }
        return 1;
    }

  private:
    bool byDepth_;
    bool byBend_;
    DepthRange depths_;
};

/// A normal as a step on paper, y down.
glm::vec2 stepOnPaper(const MarkView& view, const glm::vec3& direction) {
    const glm::vec3 seen = view.seen(direction);
    return {seen.x, -seen.y};
}

float seenOutside(const LineScene& scene, const PlaceOnPaper& at, const glm::vec3& normal, float voxels) {
    const float step = voxels * static_cast<float>(scene.field.mmPerVoxel) * at.scale;
    return scene.depth.visible({at.mm + step * stepOnPaper(scene.view, normal), at.depthMm, at.scale});
}

float seenBeside(const LineScene& scene, const PlaceOnPaper& at, const glm::vec3& normal) {
    float shown = 0;
    for (const float voxels : kOutsideVoxels) {
        shown = std::max(shown, seenOutside(scene, at, normal, voxels));
    }
    return shown;
}

bool fits(const MarkVoxel& voxel, float facing, const StippleCurves& settings) {
    return voxel.value * voxel.edge < settings.log && std::abs(facing) < settings.eye &&
           voxel.gradient > settings.gradient;
}

/// One segment through a voxel that fits.
class MovingSilhouette {
  public:
    MovingSilhouette(const LineScene& scene, const StippleCurves& settings)
        : scene_(scene), settings_(settings), width_(scene, settings.widthBy) {}

    void add(std::size_t index, std::vector<PennedLines>& layers) const {
        const MarkVoxel& voxel = scene_.field.voxels[index];
        const auto voxelMm = static_cast<float>(scene_.field.mmPerVoxel);
        if (!(voxel.gradient > settings_.gradient) || std::abs(voxel.edgeOffsetMm) > kNearVoxels * voxelMm) {
            return;
        }
        const glm::dvec3 mm =
            scene_.field.placeMm(voxel) + glm::dvec3(voxel.normalMm) * static_cast<double>(voxel.edgeOffsetMm);
        const glm::vec3 eye = scene_.view.towardsEye(mm);
        const float facing = glm::dot(voxel.normalMm, eye);
        if (!fits(voxel, facing, settings_) || !scene_.view.kept(mm)) {
            return;
        }
        const PlaceOnPaper at = scene_.view.place(mm);
        const glm::vec3 along = glm::cross(voxel.normalMm, eye);
        const float length = glm::length(along);
        if (!(at.scale > 0) || !(length > 0)) {
            return;
        }
        const bool visible = seenOutside(scene_, at, voxel.normalMm, 1.5F) >= 0.5F;
        const bool dashes = settings_.hiddenLines == "dashed";
        if (!visible && (settings_.hiddenLines == "none" ||
                         (dashes && (voxel.cell.x / 3 + voxel.cell.y / 3 + voxel.cell.z / 3) % 2 != 0))) {
            return;
        }
        PennedLines& layer = layers[std::min<std::size_t>(voxel.layer, layers.size() - 1)];
        MarkGroup& group = visible ? layer.visible : layer.hidden;
        const float bend = scene_.field.curvatures.empty() ? 0 : scene_.field.curvatures[index].most;
        const float share = width_.at(at, bend) * (visible || dashes ? 1.0F : kThinnest);
        const float width = share * static_cast<float>(settings_.widthMm);
        const glm::vec2 half = stepOnPaper(scene_.view, along / length) * (0.6F * voxelMm * at.scale);
        const float fade = 4 * (1 - std::abs(facing) / static_cast<float>(settings_.eye));
        group.strokes.push_back({static_cast<std::uint32_t>(group.points.size()), 2, std::min(fade, 1.0F), scene_.ink});
        group.points.push_back({at.mm - half, width});
        group.points.push_back({at.mm + half, width});
    }

  private:
    const LineScene& scene_;
    const StippleCurves& settings_;
    SilhouetteWidth width_;
};

std::vector<PennedLines> movingSilhouettes(const LineScene& scene, const StippleCurves& settings) {
    const MovingSilhouette silhouette(scene, settings);
    const std::size_t layerCount = std::max<std::size_t>(scene.field.layerNames.size(), 1);
    const std::size_t count = scene.field.voxels.size();
    std::vector<std::vector<PennedLines>> parts((count + kChunk - 1) / kChunk, std::vector<PennedLines>(layerCount));
    tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t part) {
        for (std::size_t i = part * kChunk; i < std::min((part + 1) * kChunk, count); ++i) {
            silhouette.add(i, parts[part]);
        }
    });
    return inOneOrder(parts, layerCount);
}

/// How much the normals point to the eye.
std::vector<float> facings(const LineScene& scene, const std::vector<glm::vec3>& normals,
                           const std::vector<std::uint8_t>& use) {
    const MarkField& field = scene.field;
    std::vector<float> facing(field.voxels.size(), 1);
    tbb::parallel_for(std::size_t{0}, facing.size(), [&](std::size_t i) {
        if (use[i] != 0) {
            facing[i] = glm::dot(normals[i], scene.view.towardsEye(field.placeMm(field.voxels[i])));
        }
    });
    return facing;
}

/// Voxels whose cubes may hold a silhouette: one beside them turns the other way.
std::vector<std::uint8_t> turning(const MarkField& field, const std::vector<float>& facing) {
    std::vector<std::uint8_t> are(facing.size());
    tbb::parallel_for(std::size_t{0}, are.size(), [&](std::size_t i) {
        bool turns = std::abs(facing[i]) < kTurning;
        if (!turns) {
            forNeighbours(field, i, [&](std::uint32_t j, const glm::ivec3&) {
                turns = turns || facing[j] * std::copysign(1.0F, facing[i]) < kTurning;
            });
        }
        are[i] = turns ? 1 : 0;
    });
    return are;
}

std::vector<PennedLines> stillSilhouettes(const LineScene& scene, const StippleCurves& settings) {
    const MarkField& field = scene.field;
    const std::size_t count = field.voxels.size();
    std::vector<float> raw(count);
    std::vector<std::uint8_t> strong(count);
    std::vector<float> gradient(count);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
        const MarkVoxel& voxel = field.voxels[i];
        raw[i] = glm::dot(voxel.normalMm, scene.view.towardsEye(field.placeMm(voxel)));
        strong[i] = fits(voxel, raw[i], settings) ? 1 : 0;
        gradient[i] = voxel.gradient;
    });
    const std::vector<std::uint8_t> use = turning(field, raw);
    const float least = kGoesOn * static_cast<float>(settings.gradient);
    const SmoothSurface surface = smoothSurface(field, use);
    const std::vector<float> facing = facings(scene, surface.normals, use);
    std::vector<SurfaceLine> lines =
        zeroLines(field, {use, surface, facing, {}, gradient, least, strong}, kShortestVoxels);
    const SilhouetteWidth width(scene, settings.widthBy);
    const bool anythingHides = scene.depth.hides();
    return drawWithPen(scene, std::move(lines), {settings.widthMm, settings.hiddenLines, true},
                       [&](const LinePoint& point) {
                           PenPoint met{scene.view.place(point.mm), 1, -1};
                           if (!scene.view.kept(point.mm) || !(met.at.scale > 0)) {
                               return met;
                           }
                           const float bend = glm::dot(point.slope, scene.view.towardsEye(point.mm));
                           met.width = width.at(met.at, bend);
                           // Where the surface is hollow along the view, it hides its own silhouette.
                           met.shown = anythingHides && bend < 0 ? 0 : seenBeside(scene, met.at, point.normalMm);
                           return met;
                       });
}

} // namespace

std::vector<MarkGroup> drawSilhouettes(const LineScene& scene, const StippleCurves& settings) {
    if (scene.field.voxels.empty() || !(settings.widthMm > 0)) {
        return {};
    }
    return namedGroups(scene, scene.moving ? movingSilhouettes(scene, settings) : stillSilhouettes(scene, settings),
                       "Silhouettes");
}

} // namespace limner
