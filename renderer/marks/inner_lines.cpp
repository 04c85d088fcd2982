#include "renderer/marks/inner_lines.h"

#include "renderer/marks/neighbours.h"
#include "renderer/marks/pen.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace limner {

namespace {

constexpr double kShortestVoxels = 6;
/// Lines go on where they are weaker than asked for, down to this share.
constexpr float kGoesOn = 0.6F;
/// Principal curvatures that differ by less than this share have no directions: a ball has no ridges.
constexpr float kLeastApart = 0.25F;
/// n.e below which a ridge all but lies on the silhouette.
constexpr float kLeastFacing = 0.35F;
/// Voxels of the surface's skirts know little of it.
constexpr float kBeyondVoxels = 4;
constexpr float kThinnest = 0.45F;

/// Curvature times the voxel as the surface's own: voxels beside it lie on parallel surfaces, which bend less outside
/// and more inside.
class Bends {
  public:
    explicit Bends(const MarkField& field)
        : field_(field), voxelMm_(static_cast<float>(field.mmPerVoxel)), mmFromVoxel_(field.grid.voxelToMmMatrix()),
          bends_(field.voxels.size(), 0) {
        tbb::parallel_for(std::size_t{0}, bends_.size(), [&](std::size_t i) {
            const float bend = field.curvatures[i].most;
            const float outside = -field.voxels[i].edgeOffsetMm;
            bends_[i] = bend / std::clamp(1 - bend * outside, 0.5F, 2.0F) * voxelMm_;
        });
        for (int step = 0; step < 2; ++step) {
            smooth();
        }
    }

    /// Positive: ridges.
    [[nodiscard]] const std::vector<float>& all() const { return bends_; }

    [[nodiscard]] bool known(std::size_t i) const {
        const MarkCurvature& c = field_.curvatures[i];
        return glm::dot(c.directionMm, c.directionMm) > 0.5F &&
               std::abs(c.most - c.least) > kLeastApart * std::abs(c.most);
    }

    [[nodiscard]] bool nearSurface(std::size_t i) const {
        return std::abs(field_.voxels[i].edgeOffsetMm) < kBeyondVoxels * voxelMm_;
    }

    /// How the bend changes along a voxel's direction, per voxel: a line through it and its neighbours.
    [[nodiscard]] float change(std::size_t index) const {
        const glm::vec3 direction = field_.curvatures[index].directionMm;
        glm::vec3 sums(0); // of weights, places, values
        float ofSquares = 0;
        float ofProducts = 0;
        forNeighbours(field_, index, [&](std::uint32_t j, const glm::ivec3& step) {
            const float weight = alike(index, j);
            const float along = glm::dot(mmFromVoxel_ * glm::vec3(step), direction) / voxelMm_;
            sums += weight * glm::vec3(1, along, bends_[j]);
            ofSquares += weight * along * along;
            ofProducts += weight * along * bends_[j];
        });
        const float spread = sums.x * ofSquares - sums.y * sums.y;
        return spread > 1e-6F * sums.x * sums.x ? (sums.x * ofProducts - sums.y * sums.z) / spread : 0;
    }

  private:
    [[nodiscard]] float alike(std::size_t a, std::size_t b) const {
        return std::max(glm::dot(field_.voxels[a].normalMm, field_.voxels[b].normalMm), 0.0F) *
               (field_.voxels[b].gradient + 1e-3F);
    }

    void smooth() {
        std::vector<float> smoother = bends_;
        tbb::parallel_for(std::size_t{0}, bends_.size(), [&](std::size_t i) {
            if (!nearSurface(i)) {
                return;
            }
            glm::vec2 sum(0);
            forNeighbours(field_, i,
                          [&](std::uint32_t j, const glm::ivec3&) { sum += alike(i, j) * glm::vec2(bends_[j], 1); });
            smoother[i] = sum.y > 0 ? sum.x / sum.y : 0;
        });
        bends_ = std::move(smoother);
    }

    const MarkField& field_;
    float voxelMm_;
    glm::mat3 mmFromVoxel_;
    std::vector<float> bends_;
};

/// `sign`: 1 for ridges, -1 for valleys.
void addLines(const MarkField& field, const Bends& bends, float sign, double asked, std::vector<SurfaceLine>& lines) {
    const std::size_t count = field.voxels.size();
    const float least = kGoesOn * static_cast<float>(asked);
    std::vector<std::uint8_t> use(count);
    std::vector<std::uint8_t> strong(count);
    std::vector<float> strength(count);
    std::vector<float> change(count, 0);
    std::vector<glm::vec3> axis(count, glm::vec3(0));
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
        strength[i] = sign * bends.all()[i];
        use[i] =
            bends.nearSurface(i) && bends.known(i) && sign * field.curvatures[i].most > 0 && strength[i] > 0.5F * least
                ? 1
                : 0;
        strong[i] = strength[i] >= static_cast<float>(asked) ? 1 : 0;
        axis[i] = field.curvatures[i].directionMm;
        change[i] = use[i] != 0 ? sign * bends.change(i) : 0;
    });
    const SmoothSurface surface = smoothSurface(field, use);
    const std::vector<SurfaceLine> found =
        zeroLines(field, {use, surface, change, axis, strength, least, strong}, kShortestVoxels);
    lines.insert(lines.end(), found.begin(), found.end());
}

} // namespace

std::vector<SurfaceLine> traceInnerLines(const MarkField& field, const StippleInnerLines& settings) {
    std::vector<SurfaceLine> lines;
    if (field.curvatures.size() != field.voxels.size() || field.voxels.empty()) {
        return lines;
    }
    const Bends bends(field);
    if (settings.ridges > 0) {
        addLines(field, bends, 1, settings.ridges, lines);
    }
    if (settings.valleys > 0) {
        addLines(field, bends, -1, settings.valleys, lines);
    }
    return lines;
}

std::vector<MarkGroup> drawInnerLines(const LineScene& scene, const std::vector<SurfaceLine>& traced,
                                      const StippleInnerLines& settings) {
    if (traced.empty() || !(settings.widthMm > 0)) {
        return {};
    }
    const double leastAsked = std::min(settings.ridges > 0 ? settings.ridges : settings.valleys,
                                       settings.valleys > 0 ? settings.valleys : settings.ridges);
    const Pen pen{settings.widthMm, "none", true};
    return namedGroups(scene,
                       drawWithPen(scene, traced, pen,
                                   [&](const LinePoint& point) {
                                       PenPoint met{scene.view.place(point.mm), 1, -1};
                                       const float facing = glm::dot(point.normalMm, scene.view.towardsEye(point.mm));
                                       if (!scene.view.kept(point.mm)) {
                                           return met;
                                       }
                                       const bool away = scene.depth.hides() && facing < kLeastFacing;
                                       met.shown = away ? 0 : scene.depth.visible(met.at);
                                       const float over = point.strength / static_cast<float>(leastAsked);
                                       met.width = std::clamp(0.5F * over, kThinnest, 1.0F);
                                       return met;
                                   }),
                       "Inner lines");
}

} // namespace limner
