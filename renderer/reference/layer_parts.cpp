#include "renderer/reference/layer_parts.h"

#include "core/optics/layers.h"
#include "core/style/ramps.h"
#include "core/style/transfer_function.h"
#include "renderer/plan/plan_parts.h"
#include "renderer/reference/field.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace limner::reference {

namespace {

double placeOf(const glm::dvec4& ofVoxel, const SampleFacts& facts) {
    return std::clamp(glm::dot(ofVoxel, glm::dvec4(facts.positionVoxel, 1)), 0.0, 1.0);
}

glm::dvec3 normalEyeOf(const RenderPlan& plan, const SampleFacts& facts) {
    return plan.rays.eyeFromMm * facts.surface.normalMm;
}

/// Turned to the viewer where both sides are drawn alike.
double towards(const SampleFacts& facts, bool twoSided) { return twoSided && facts.surface.normalRay.z < 0 ? -1 : 1; }

/// Highlight of the light that the layer's tone has, or else the viewer's.
double highlightOf(const RenderPlan& plan, const PlanParts& parts, const SampleFacts& facts, double sign) {
    const glm::dvec3 light = parts.tone ? parts.lightEye : -facts.directionEye;
    const double half = optics::halfway(sign * glm::dot(normalEyeOf(plan, facts), light),
                                        sign * facts.surface.normalRay.z, glm::dot(light, -facts.directionEye));
    return facts.surface.definedness * parts.specular->strength * optics::powc(half, parts.specular->exponent);
}

double curveAt(const std::optional<std::vector<glm::dvec2>>& curve, double at) {
    return curve ? opacityAt(*curve, at) : 1;
}

/// One channel of a cue's field.
double cueAt(const CueField& field, const glm::dvec3& positionVoxel, int channel) {
    const double per = field.voxelsPerCell;
    const glm::dvec3 cell = glm::clamp((positionVoxel + 0.5) / per - 0.5, glm::dvec3(0), glm::dvec3(field.dims - 1));
    const glm::ivec3 low(glm::floor(cell));
    const glm::dvec3 f = cell - glm::dvec3(low);
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 step(corner & 1, corner >> 1 & 1, corner >> 2);
        const glm::ivec3 at = glm::min(low + step, field.dims - 1);
        const glm::dvec3 w = glm::mix(1.0 - f, f, glm::dvec3(step));
        const auto index =
            (static_cast<std::size_t>(at.z) * static_cast<std::size_t>(field.dims.y) + static_cast<std::size_t>(at.y)) *
                static_cast<std::size_t>(field.dims.x) +
            static_cast<std::size_t>(at.x);
        sum += w.x * w.y * w.z *
               field.values[index * static_cast<std::size_t>(field.channels) + static_cast<std::size_t>(channel)];
    }
    return sum;
}

/// A cell out of the surface.
glm::dvec3 outside(const RenderPlan& plan, const CueField& field, const SampleFacts& facts) {
    const Grid& grid = plan.volume->grid();
    const double mm = field.voxelsPerCell * grid.smallestSpacingMm() * facts.surface.definedness;
    return facts.positionVoxel + grid.mmToVoxelMatrix() * (mm * facts.surface.normalMm);
}

/// How much of a colour's light the cues leave.
double litShare(const RenderPlan& plan, const PlanDepthCues& cues, const SampleFacts& facts) {
    const SurfaceSample& surface = facts.surface;
    double lit = 1;
    if (cues.ambient) {
        const glm::dvec3 place = outside(plan, *cues.ambient, facts);
        const auto at = [&](int channel) { return cueAt(*cues.ambient, place, channel); };
        const double along = glm::dot(surface.normalMm, glm::dvec3(at(1), at(2), at(3)));
        lit *=
            1 - cues.source->ambientOcclusion->strength * optics::ambientOcclusion(at(0), along, surface.definedness);
    }
    if (cues.shadow) {
        lit *= 1 - cues.source->shadow->strength *
                       optics::shadowed(cueAt(*cues.shadow, outside(plan, *cues.shadow, facts), 0),
                                        glm::dot(normalEyeOf(plan, facts), cues.lightEye), surface.definedness);
    }
    return lit;
}

} // namespace

void layOntoFace(const RenderPlan& plan, const PlanCut& cut, SampleFacts& facts) {
    const glm::dvec3 p = plan.volume->grid().mmFromVoxel(facts.positionVoxel);
    const PlanCut::Plane* nearest = nullptr;
    double least = 0;
    for (const PlanCut::Plane& plane : cut.planes) {
        const double inside = plane.offsetMm - glm::dot(plane.normalMm, p);
        if (nearest == nullptr || inside < least) {
            nearest = &plane;
            least = inside;
        }
    }
    const double share = nearest != nullptr ? optics::cutFaceShare(least / plan.referenceLengthMm) : 0;
    if (!(share > 0)) {
        return;
    }
    SurfaceSample& surface = facts.surface;
    const glm::dvec3 mixed = glm::mix(surface.definedness * surface.normalMm, nearest->normalMm, share);
    const double length = glm::length(mixed);
    surface.normalMm = length > 1e-6 ? mixed / length : nearest->normalMm;
    const glm::dvec3 eye = normalEyeOf(plan, facts);
    surface.normalRay = optics::normalInRayFrame<double>(
        {eye.x, eye.y, eye.z}, {facts.directionEye.x, facts.directionEye.y, facts.directionEye.z});
    surface.definedness = glm::mix(surface.definedness, 1.0, share);
    surface.bend *= 1 - share;
    for (auto& turn : facts.turns) {
        turn.second *= 1 - share;
    }
    if (cut.coloured) {
        facts.faces.emplace_back(share, nearest->rgb);
    }
}

void blur(const RenderPlan& plan, const PlanFocus& focus, SampleFacts& facts) {
    const double level = optics::blurLevel(placeOf(focus.depthOfVoxel, facts), focus.focus, focus.strength);
    const int low = std::min(static_cast<int>(level), optics::kBlurLevels - 1);
    const double share = level - low;
    const glm::dvec3& p = facts.positionVoxel;
    const auto copy = [&](int i) -> const Volume& { return *plan.blurs[static_cast<std::size_t>(i - 1)]; };
    const double sharp = facts.value;
    const auto valueOf = [&](int i) { return i == 0 ? sharp : trilinearAt(copy(i), p); };
    facts.value = glm::mix(valueOf(low), valueOf(low + 1), share);
    if (!readsNormal(plan)) {
        return;
    }
    const auto gradientOf = [&](int i) {
        if (i == 0) {
            return eyeGradient(plan, p);
        }
        // eyeFromGradient is for the volume's stored units.
        const double unit = copy(i).contents().slope / plan.volume->contents().slope;
        const glm::dvec3 slope = trilinearSlope(copy(i), p) / copy(i).contents().slope;
        return plan.rays.eyeFromGradient *
               (unit *
                glm::dvec3(optics::slopeOfCopy(slope.x), optics::slopeOfCopy(slope.y), optics::slopeOfCopy(slope.z)));
    };
    const double bend = facts.surface.bend;
    facts.surface = surfaceOf(plan, facts.directionEye, glm::mix(gradientOf(low), gradientOf(low + 1), share));
    facts.surface.bend = bend;
}

LayerSample withParts(const RenderPlan& plan, const PlanLayer& layer, const SampleFacts& facts,
                      const LayerSample& classified) {
    LayerSample sample = classified;
    const double kept = layer.cut ? keptShare(*layer.cut, plan.volume->grid().mmFromVoxel(facts.positionVoxel),
                                              facts.directionMm, facts.lengthMm)
                                  : 1;
    sample.lengthRatio = kept * facts.lengthMm / plan.referenceLengthMm;
    glm::dvec3 c(sample.colour.r, sample.colour.g, sample.colour.b);
    for (const auto& [share, rgb] : facts.faces) {
        c = glm::mix(c, rgb, share);
    }
    if (layer.parts) {
        const PlanParts& parts = *layer.parts;
        const SurfaceSample& surface = facts.surface;
        const double sign = towards(facts, layer.twoSided);
        if (parts.tone) {
            const double toLight = sign * glm::dot(normalEyeOf(plan, facts), parts.lightEye);
            c *= toneAt(*parts.tone, optics::tonePlace(toLight, surface.definedness));
        }
        const double gradient = std::min(surface.magnitude, 1.0);
        const double lineMap = curveAt(parts.lineGradientOpacity, gradient);
        const glm::dvec4 tint =
            parts.position ? positionTintAt(*parts.position, placeOf(parts.placeOfVoxel, facts)) : glm::dvec4(1);
        double line = 0;
        if (parts.silhouette) {
            const Silhouette& s = *parts.silhouette;
            line = std::min(
                1.0, sample.opacity * s.opacity * lineMap * tint.a *
                         optics::silhouetteShare(surface.normalRay.z, s.range.x, s.range.y, surface.definedness));
        }
        const double shading = std::min(1.0, sample.opacity * curveAt(parts.gradientOpacity, gradient) * tint.a);
        if (parts.silhouette) {
            c = glm::mix(c, parts.silhouette->rgb, optics::lineShare(shading, line));
        }
        if (parts.specular) {
            c += lineMap * highlightOf(plan, parts, facts, sign);
        }
        c = glm::min(c * glm::dvec3(tint), 1.0);
        sample.opacity = optics::withLine(shading, line);
    }
    sample.colour = {c.r, c.g, c.b};
    return sample;
}

LayerSample withCues(const RenderPlan& plan, const SampleFacts& facts, LayerSample sample) {
    if (!plan.cues) {
        return sample;
    }
    const double lit = litShare(plan, *plan.cues, facts);
    double halo = 0;
    glm::dvec3 haloRgb(0);
    if (plan.cues->halo) {
        halo = plan.cues->source->halo->strength * cueAt(*plan.cues->halo, facts.positionVoxel, 0);
        haloRgb = plan.cues->source->halo->rgb;
    }
    const glm::dvec3 c = glm::mix(lit * glm::dvec3(sample.colour.r, sample.colour.g, sample.colour.b), haloRgb, halo);
    sample.colour = {c.r, c.g, c.b};
    return sample;
}

} // namespace limner::reference
