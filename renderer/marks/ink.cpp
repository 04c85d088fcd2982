#include "renderer/marks/ink.h"

#include "core/figure/light_frame.h"
#include "core/optics/stipple.h"
#include "renderer/marks/dot_pattern.h"
#include "renderer/reference/layer_optics.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limner {

namespace {

constexpr double kMostPoints = 5e7; ///< in all lists together (numerics 2e)

InkColour inkOf(const glm::dvec3& rgb) { return InkColour(glm::clamp(rgb, 0.0, 1.0) * 255.0 + 0.5); }

/// Half the depth of the volume's box along a direction, mm.
double halfDepth(const Grid& grid, const glm::dvec3& direction) {
    const glm::dvec3 along = glm::transpose(grid.direction) * direction;
    return 0.5 * glm::dot(glm::abs(along), grid.sizeMm());
}

/// The factors of a figure's stipples in one view.
class Factors {
  public:
    Factors(const Stipple& stipple, const InkView& view)
        : stipple_(stipple), view_(view), ofLayers_(stipple.matter == "layers") {}

    struct Result {
        float tone = 1;
        float count = 1;     ///< further factor on the number of dots
        float size = 1;      ///< share of the largest dot
        float shrinking = 1; ///< further factor on the size, which the tone does not make up for
    };

    /// `seen`: the normal in the frame of the viewer.
    [[nodiscard]] Result of(const MarkVoxel& voxel, const PlaceOnPaper& at, const glm::vec3& seen,
                            float cosineEye) const {
        Result result;
        result.size = voxel.gradient;
        if (ofLayers_) {
            result.tone = optics::smoothStep<float>(kFaintMatter, kFullMatter, voxel.value);
        }
        if (const auto& k = stipple_.boundary) {
            result.tone *= optics::boundaryFactor<float>(voxel.value, voxel.gradient, curve(k->kgc, k->kgs, k->kge));
        }
        if (const auto& k = stipple_.silhouette) {
            result.tone *= optics::silhouetteFactor<float>(voxel.value, cosineEye, curve(k->ksc, k->kss, k->kse));
        }
        if (const auto& k = stipple_.resolution) {
            addResolution(at.scale / view_.wholeScale, static_cast<float>(k->kre), result);
        }
        if (const auto& k = stipple_.distance; k && !view_.idle.distance) {
            const auto factor = optics::distanceFactor<float>(at.depthMm - view_.centreDepth, view_.halfDepth,
                                                              static_cast<float>(k->kde));
            result.tone *= factor;
            result.size *= factor;
        }
        if (const auto& k = stipple_.interior; k && !view_.idle.interior) {
            const auto factor = optics::interiorFactor<float>(voxel.gradient, static_cast<float>(k->kte));
            result.tone *= factor;
            result.size *= factor;
        }
        if (const auto& k = stipple_.lighting) {
            result.tone *= optics::lightingFactor<float>(glm::dot(view_.light, seen), static_cast<float>(k->kle));
        }
        return result;
    }

  private:
    static optics::StippleCurve<float> curve(double c, double s, double e) {
        return {static_cast<float>(c), static_cast<float>(s), static_cast<float>(e)};
    }

    /// Fewer dots from afar, and so small that the tone stays: dots times area goes with the view's area.
    static void addResolution(float nearness, float exponent, Result& result) {
        const auto factor = optics::resolutionFactor<float>(0, 1 / nearness, 1, exponent);
        result.count *= factor;
        if (nearness < 1) {
            result.shrinking *= std::min(nearness / std::sqrt(std::max(factor, 1e-12F)), 1.0F);
        }
    }

    const Stipple& stipple_;
    const InkView& view_;
    bool ofLayers_;
};

/// Expected dots of voxels that ask for full tone and face the viewer: k_max N_max (paper 004, eq. 1).
double densityOfFigure(const RenderPlan& plan, const MarkField& field, Task& task) {
    const Stipple& stipple = *plan.figure->stipple;
    const double dot = largestDotArea(stipple);
    if (!(dot > 0)) {
        return 0;
    }
    const double cell = field.mmPerVoxel * field.mmPerVoxel;
    const double scale = field.paperPerMm * field.zoom;
    const double all = stipple.kMax * cell * scale * scale / dot * static_cast<double>(field.voxels.size());
    if (all <= kMostPoints) {
        return stipple.kMax;
    }
    task.warn("stipples: " + std::to_string(static_cast<long>(all / 1e6)) +
              " million points are more than 50 million: /stipple/k_max counts as " +
              std::to_string(stipple.kMax * kMostPoints / all));
    return stipple.kMax * kMostPoints / all;
}

/// Dots for a tone: how many, of which size.
struct DotLaw {
    const DotPattern& pattern;
    const Stipple& stipple;
    double density; ///< k_max, or less

    void apply(const Factors::Result& factors, double points, VoxelInk& ink) const {
        const float size = std::max(factors.size, kSmallestDot);
        ink.tone = std::clamp(factors.tone, 0.0F, 1.0F);
        const double asked = density * static_cast<double>(factors.tone);
        double share = 0;
        if (stipple.tone == "ink") {
            share = pattern.densityFor(std::min(asked, kFullestTone)) / static_cast<double>(size * size);
        } else {
            const double shrunk = static_cast<double>(factors.size) / static_cast<double>(size);
            share = asked * shrunk * shrunk;
        }
        ink.dots = static_cast<float>(points * share * static_cast<double>(factors.count));
        ink.radiusMm = static_cast<float>(0.5 * stipple.sizeMm) * size * factors.shrinking;
    }
};

/// Colour that the layers have at a mark voxel.
InkColour colourAt(const RenderPlan& plan, const MarkField& field, const MarkView& view, const MarkVoxel& voxel) {
    const glm::dvec3 mm = field.placeMm(voxel);
    const glm::vec3 seen = view.seen(voxel.normalMm);
    const glm::vec3 eye = -view.towardsEye(mm);
    const glm::vec3 eyeSeen = view.seen(eye);
    reference::SampleFacts facts;
    facts.value = static_cast<double>(voxel.dataValue);
    facts.positionVoxel =
        glm::clamp(plan.volume->grid().voxelFromMm(mm), glm::dvec3(0), glm::dvec3(plan.volume->grid().dims - 1));
    facts.directionEye = eyeSeen;
    facts.directionMm = eye;
    facts.lengthMm = plan.referenceLengthMm;
    facts.surface.normalRay = {static_cast<double>(seen.x), static_cast<double>(seen.y), static_cast<double>(seen.z)};
    facts.surface.normalMm = voxel.normalMm;
    facts.surface.definedness = 1;
    facts.surface.magnitude = static_cast<double>(voxel.gradient);
    for (const PlanLayer& layer : plan.layers) {
        if (layer.contours) {
            facts.turns.emplace_back(layer.contours->probeMm, 0.0);
        }
    }
    if (plan.labels) {
        const glm::ivec3 nearest(facts.positionVoxel + 0.5);
        facts.membership = {{static_cast<int>(plan.labels->storedAt(nearest)), 1.0}};
    }
    glm::dvec3 sum(0);
    double weight = 0;
    for (const PlanLayer& layer : plan.layers) {
        const reference::LayerSample sample = reference::shadeLayer(plan, layer, facts);
        sum += sample.opacity * glm::dvec3(sample.colour.r, sample.colour.g, sample.colour.b);
        weight += sample.opacity;
    }
    return weight > 0 ? inkOf(sum / weight) : inkOf(plan.figure->stipple->inkRgb);
}

} // namespace

IdleFactors idleFactors(const Stipple& stipple) {
    // Not the one by resolution: whatever its exponent, dots from afar are smaller.
    return {stipple.distance && !(std::abs(stipple.distance->kde) > 0),
            stipple.interior && !(std::abs(stipple.interior->kte) > 0)};
}

InkView inkView(const RenderPlan& plan, const MarkField& field, const MarkView& view, Task& task) {
    const Stipple& stipple = *plan.figure->stipple;
    InkView ink;
    ink.wholeScale = static_cast<float>(field.paperPerMm);
    ink.halfDepth = static_cast<float>(halfDepth(plan.volume->grid(), view.frame().forward));
    ink.centreDepth = view.place(plan.volume->grid().centreMm()).depthMm;
    if (stipple.lighting) {
        ink.light = glm::vec3(lightSeen(stipple.lighting->light, plan.figure->camera));
    }
    ink.idle = plan.kept.has(LeaveOut::dotFactors) ? IdleFactors{} : idleFactors(stipple);
    ink.density = densityOfFigure(plan, field, task);
    ink.perFace = field.mmPerVoxel * field.mmPerVoxel / std::max(largestDotArea(stipple), 1e-12);
    ink.facingOnly = stipple.hidden == "remove" || stipple.lighting.has_value(); // paper 004, 5.5
    return ink;
}

InkColour plainInk(const Stipple& stipple) { return inkOf(stipple.inkRgb); }

double largestDotArea(const Stipple& stipple) { return 0.25 * std::numbers::pi * stipple.sizeMm * stipple.sizeMm; }

MarkScene makeMarkScene(const RenderPlan& plan, const MarkField& field, bool moving, Task& task) {
    const Stipple& stipple = *plan.figure->stipple;
    MarkScene scene{plan, stipple, field, MarkView(plan), {}, {}, {}, moving, plainInk(stipple)};
    if (stipple.hidden == "remove") {
        scene.depth = MarkDepth(field, scene.view, stipple.matter == "layers");
    }
    const InkView view = inkView(plan, field, scene.view, task);
    const Factors factors(stipple, view);
    const DotLaw law{dotPattern(), stipple, view.density};
    scene.ink.resize(field.voxels.size());
    scene.colours.resize(stipple.fromStyle ? field.voxels.size() : 0);
    tbb::parallel_for(std::size_t{0}, field.voxels.size(), [&](std::size_t i) {
        const MarkVoxel& voxel = field.voxels[i];
        VoxelInk& ink = scene.ink[i];
        if (!(voxel.share > 0)) {
            return;
        }
        const glm::dvec3 mm = field.placeMm(voxel);
        const float cosine = glm::dot(voxel.normalMm, scene.view.towardsEye(mm));
        if (view.facingOnly && cosine <= 0) {
            return;
        }
        ink.facing = std::abs(cosine);
        ink.at = scene.view.place(mm);
        if (!(ink.at.scale > 0) || scene.depth.hidesVoxel(ink.at, ink.facing) || !scene.view.kept(mm)) {
            return;
        }
        // From nearer than all of the volume shows, dots keep their distance on paper; from farther the volume keeps
        // its dots, and the resolution factor thins them (paper 004, 5.2).
        const double scale = std::max(static_cast<double>(ink.at.scale), field.paperPerMm);
        const double points = static_cast<double>(voxel.share * ink.facing) * view.perFace * scale * scale;
        law.apply(factors.of(voxel, ink.at, scene.view.seen(voxel.normalMm), cosine), points, ink);
        if (stipple.fromStyle && ink.tone > 0) {
            scene.colours[i] = colourAt(plan, field, scene.view, voxel);
        }
    });
    task.throwIfCancelled();
    return scene;
}

} // namespace limner
