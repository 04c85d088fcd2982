#include "renderer/scene/scene_builder.h"

#include "core/base/error.h"
#include "core/style/ramps.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace limner {

/// What the kernel reads of layers' parts, cut faces, depth of field and depth cues.

namespace {

float number(double v) { return static_cast<float>(v); }

/// A function that is linear in voxels, of cells.
void copyLinear(const glm::dvec4& ofVoxel, float (&ofCell)[4]) {
    copyTo(glm::dvec3(ofVoxel), ofCell);
    ofCell[3] = number(ofVoxel.w - glm::dot(glm::dvec3(ofVoxel), kCellFromVoxel));
}

} // namespace

const float* BuiltScene::keepColours(const std::vector<glm::vec4>& table) {
    std::vector<Colour> colours;
    for (const glm::vec4& c : table) {
        colours.push_back({{c.r, c.g, c.b, c.a}});
    }
    colours.push_back(colours.back()); // linear interpolation at the last entry reads one more
    colours_.push_back(std::move(colours));
    return colours_.back().front().rgba;
}

void BuiltScene::addParts(const RenderPlan& plan, const PlanLayer& layer, KernelLayer& out) {
    if (layer.cut) {
        out.cut = addCut(plan, *layer.cut);
    }
    if (layer.focus) {
        out.focus = number(layer.focus->focus);
        out.focusStrength = number(layer.focus->strength);
        copyLinear(layer.focus->depthOfVoxel, out.depthFromCell);
    }
    if (!layer.parts) {
        return;
    }
    const PlanParts& from = *layer.parts;
    KernelParts& to = out.parts;
    to.any = true;
    to.lastEntry = kRampEntries - 1;
    copyTo(from.lightEye, to.light);
    to.ownLight = from.tone.has_value();
    to.tone = from.tone ? keepColours(from.toneTable) : nullptr;
    if (from.position) {
        to.position = keepColours(from.positionTable);
        copyLinear(from.placeOfVoxel, to.placeFromCell);
    }
    to.gradientOpacity = from.gradientOpacity ? keep(from.gradientTable) : nullptr;
    to.lineOpacity = from.lineGradientOpacity ? keep(from.lineTable) : nullptr;
    if (from.silhouette) {
        to.silhouetteOpacity = number(from.silhouette->opacity);
        to.silhouetteFull = number(from.silhouette->range.x);
        to.silhouetteNone = number(from.silhouette->range.y);
        copyTo(from.silhouette->rgb, to.silhouetteRgb);
    }
    if (from.specular) {
        to.specularStrength = number(from.specular->strength);
        to.specularExponent = number(from.specular->exponent);
    }
}

const KernelCut* BuiltScene::addCut(const RenderPlan& plan, const PlanCut& cut) {
    if (cut.planes.size() > KernelCut::kMaxPlanes) {
        throw Error(ErrorKind::badInput,
                    {"the figure cannot be drawn", "/layers", "more than 66 clip planes", "remove some of them"});
    }
    const Grid& grid = plan.volume->grid();
    KernelCut& out = cuts_.emplace_back();
    out.faces = cut.faces;
    out.coloured = cut.coloured;
    out.perVoxel = number(1 / plan.referenceLengthMm);
    for (const PlanCut::Plane& plane : cut.planes) {
        KernelCut::Plane& to = out.planes[out.count++];
        const glm::dvec3 perVoxel = glm::transpose(grid.voxelToMmMatrix()) * plane.normalMm;
        copyLinear({-perVoxel, plane.offsetMm - glm::dot(plane.normalMm, grid.originMm)}, to.insideFromCell);
        copyTo(plan.rays.eyeFromMm * plane.normalMm, to.normalEye);
        copyTo(plane.rgb, to.rgb);
    }
    return &out;
}

void BuiltScene::setBlurs(const RenderPlan& plan) {
    const double stored = std::abs(plan.volume->contents().slope);
    for (std::size_t i = 0; i < plan.blurs.size(); ++i) {
        const Volume::Contents& contents = plan.blurs[i]->contents();
        KernelBlur& out = scene_.blurs[i];
        out.bricks = reinterpret_cast<const std::uint8_t*>(plan.blurs[i]->bricks());
        const double perValue = valuePerEntry_ > 0 ? 1 / valuePerEntry_ : 0;
        out.entryScale = number(contents.slope * perValue);
        out.entryBias = number((contents.intercept - firstValue_) * perValue);
        const double scale = contents.slope / plan.volume->contents().slope / stored;
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column) {
                out.eyeFromSlope[row][column] = number(plan.rays.eyeFromGradient[column][row] * scale);
            }
        }
    }
}

void BuiltScene::setCues(const RenderPlan& plan) {
    if (!plan.cues) {
        return;
    }
    const PlanDepthCues& from = *plan.cues;
    KernelCues& to = scene_.cues;
    to.any = true;
    const double spacing = plan.volume->grid().smallestSpacingMm();
    const auto set = [spacing](const std::shared_ptr<const CueField>& field, KernelCue& out) {
        if (!field) {
            return;
        }
        out.values = field->values.data();
        for (int i = 0; i < 3; ++i) {
            out.dims[i] = field->dims[i];
        }
        const double per = field->voxelsPerCell;
        out.perCell = number(1 / per);
        out.bias = number((0.5 - kCellFromVoxel.x) / per - 0.5);
        out.outMm = number(per * spacing);
    };
    set(from.ambient, to.ambient);
    set(from.shadow, to.shadow);
    set(from.halo, to.halo);
    to.ambientStrength = from.ambient ? number(from.source->ambientOcclusion->strength) : 0;
    to.shadowStrength = from.shadow ? number(from.source->shadow->strength) : 0;
    copyTo(from.lightEye, to.light);
    if (from.halo) {
        to.haloStrength = number(from.source->halo->strength);
        copyTo(from.source->halo->rgb, to.haloRgb);
    }
}

} // namespace limner
