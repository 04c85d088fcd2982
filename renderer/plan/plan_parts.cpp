#include "renderer/plan/plan_parts.h"

#include "core/figure/light_frame.h"
#include "core/optics/layers.h"
#include "core/style/ramps.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <limits>

namespace limner {

namespace {

/// Place along a direction (mm) that is 0 and 1 at the ends of the volume's box, from a position in voxels.
glm::dvec4 placeAlong(const glm::dvec3& directionMm, const Grid& grid) {
    const glm::dvec3 perVoxel = glm::transpose(grid.voxelToMmMatrix()) * directionMm;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 share(corner & 1, corner >> 1 & 1, corner >> 2);
        const double at = glm::dot(perVoxel, share * glm::dvec3(grid.dims) - 0.5);
        low = std::min(low, at);
        high = std::max(high, at);
    }
    const double span = high > low ? high - low : 1;
    return {perVoxel / span, -low / span};
}

glm::dvec3 viewMm(const RayFrame& rays) { return -glm::transpose(rays.eyeFromMm)[2]; }

glm::dvec3 axisMm(const PositionRamp& ramp, const RayFrame& rays) {
    if (ramp.axis == "x" || ramp.axis == "y" || ramp.axis == "z") {
        glm::dvec3 axis(0);
        axis[ramp.axis.front() - 'x'] = 1;
        return axis;
    }
    return ramp.axis == "direction" ? ramp.direction : viewMm(rays);
}

bool drawsAny(const PlanParts& parts) {
    return parts.tone || parts.silhouette || parts.specular || parts.gradientOpacity || parts.position;
}

void bakeTables(PlanParts& parts) {
    if (parts.tone) {
        parts.toneTable = bakeTone(*parts.tone);
    }
    if (parts.position) {
        parts.positionTable = bakePositionTint(*parts.position);
    }
    if (parts.gradientOpacity) {
        parts.gradientTable = bakeUnitCurve(*parts.gradientOpacity);
    }
    if (parts.lineGradientOpacity) {
        parts.lineTable = bakeUnitCurve(*parts.lineGradientOpacity);
    }
}

/// Of a face: a plain colour, or a style's where the cut looks.
glm::dvec3 faceColour(const CutFace& face, const Figure& figure, const glm::dvec3& normalEye) {
    const StyleEntry* style = figure.findStyle(face.style);
    if (style == nullptr || style->sphere == nullptr) {
        return face.rgb.value_or(glm::dvec3(0.5));
    }
    const double towards = normalEye.z < 0 ? -1 : 1;
    const Rgba c = style->sphere->at(normalEye.x * towards, normalEye.y * towards);
    return {c.r, c.g, c.b};
}

} // namespace

std::optional<PlanParts> planParts(const Layer& source, const LayerSurroundings& around) {
    PlanParts parts;
    if (source.tone && !source.tone->keys.empty()) {
        parts.tone = source.tone;
        parts.lightEye = lightSeen(source.tone->light, around.figure.camera);
    }
    if (source.silhouette && source.silhouette->opacity > 0) {
        parts.silhouette = source.silhouette;
    }
    if (source.specular && source.specular->strength > 0 && source.shading != Shading::phong) {
        parts.specular = source.specular;
    }
    parts.gradientOpacity = source.gradientOpacity;
    if (parts.silhouette || parts.specular) {
        parts.lineGradientOpacity = source.lineGradientOpacity;
    }
    if (source.position && !source.position->ramp.empty()) {
        parts.position = source.position;
        parts.placeOfVoxel = placeAlong(axisMm(*source.position, around.rays), around.volume.grid());
    }
    if (!drawsAny(parts)) {
        return std::nullopt;
    }
    bakeTables(parts);
    return parts;
}

bool changesOpacity(const PlanParts& parts) {
    return parts.silhouette || parts.gradientOpacity || (parts.position && changesOpacity(*parts.position));
}

double greatestOpacity(const PlanParts& parts, double opacity) {
    double fade = 1;
    if (parts.position) {
        fade = 0;
        for (const RampKey& key : parts.position->ramp) {
            fade = std::max(fade, key.rgba.a);
        }
    }
    const double shading = std::min(1.0, opacity * fade);
    const double line = parts.silhouette ? std::min(1.0, opacity * parts.silhouette->opacity * fade) : 0;
    return optics::withLine(shading, line);
}

std::optional<PlanFocus> planFocus(const Layer& source, const LayerSurroundings& around) {
    if (!source.depthOfField || !(source.depthOfField->strength > 0)) {
        return std::nullopt;
    }
    return PlanFocus{placeAlong(viewMm(around.rays), around.volume.grid()), source.depthOfField->focus,
                     source.depthOfField->strength};
}

bool cutsAnything(const Clip& clip) { return clip.boxMm || !clip.planes.empty(); }

PlanCut planCut(const Clip& clip, const Figure& figure, const RayFrame& rays) {
    PlanCut cut;
    cut.faces = clip.face.has_value();
    cut.coloured = cut.faces && (clip.face->rgb || !clip.face->style.empty());
    const auto add = [&](const glm::dvec3& normal, double offset) {
        const double length = glm::length(normal);
        PlanCut::Plane plane{normal / length, offset / length, glm::dvec3(0)};
        if (cut.coloured) {
            plane.rgb = faceColour(*clip.face, figure, rays.eyeFromMm * plane.normalMm);
        }
        cut.planes.push_back(plane);
    };
    for (int axis = 0; clip.boxMm && axis < 3; ++axis) {
        glm::dvec3 normal(0);
        normal[axis] = 1;
        add(normal, clip.boxMm->high[axis]);
        add(-normal, -clip.boxMm->low[axis]);
    }
    for (const ClipPlane& plane : clip.planes) {
        if (glm::length(plane.normal) > 0) {
            add(plane.normal, plane.offsetMm);
        }
    }
    return cut;
}

double keptShare(const PlanCut& cut, const glm::dvec3& p, const glm::dvec3& directionMm, double lengthMm) {
    double share = 1;
    for (const PlanCut::Plane& plane : cut.planes) {
        const double inside = plane.offsetMm - glm::dot(plane.normalMm, p);
        share =
            std::min(share, optics::keptByPlane(inside, std::abs(glm::dot(plane.normalMm, directionMm)) * lengthMm));
    }
    return share;
}

} // namespace limner
