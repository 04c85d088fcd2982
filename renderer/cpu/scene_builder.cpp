#include "renderer/cpu/scene_builder.h"

#include "core/base/error.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace limner {

namespace {

constexpr glm::dvec3 kCellFromVoxel{1}; // cell coordinate = voxel coordinate + 1

/// Unit of the kernel's interpolated values (Field::kScale).
double kernelScale(VoxelType type) { return type == VoxelType::float32 ? 1.0 : 32767.0; }

void copy(const glm::dvec3& from, double (&to)[3]) {
    for (int i = 0; i < 3; ++i) {
        to[i] = from[i];
    }
}

} // namespace

BuiltScene::BuiltScene(const RenderPlan& plan) {
    setVolume(plan);
    setRays(plan);
    setClip(plan);
    setTables(plan);
    scene_.opaque = static_cast<float>(1 - plan.earlyTermination);
}

const float* BuiltScene::keep(std::vector<float> table) {
    table.push_back(table.back()); // linear interpolation at the last entry reads one more
    tables_.push_back(std::move(table));
    return tables_.back().data();
}

void BuiltScene::setVolume(const RenderPlan& plan) {
    const Volume& volume = *plan.volume;
    scene_.bricks = reinterpret_cast<const std::uint8_t*>(volume.bricks());
    scene_.type = volume.type();
    scene_.wide = volume.bytes() > static_cast<std::size_t>(std::numeric_limits<std::uint32_t>::max());
    scene_.brickStep[0] = 1;
    scene_.brickStep[1] = volume.layout().bricks.x;
    scene_.brickStep[2] = volume.layout().bricks.x * volume.layout().bricks.y;
    for (int i = 0; i < 3; ++i) {
        const int dim = volume.grid().dims[i];
        scene_.lastCell[i] = std::nextafter(static_cast<float>(dim), 0.0F);
        scene_.boxLow[i] = kCellFromVoxel[i] - 0.5 + plan.lattice.boxInset;
        scene_.boxHigh[i] = kCellFromVoxel[i] + dim - 0.5 - plan.lattice.boxInset;
        scene_.blocks[i] = plan.skip->blocks[i];
    }
    scene_.distance = plan.skip->distance.data();
    // Central differences span two voxels.
    const double perDifference = 0.5 / kernelScale(volume.type());
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            scene_.eyeFromGradient[row][column] =
                static_cast<float>(plan.rays.eyeFromGradient[column][row] * perDifference);
        }
    }
    scene_.gradientFloor = static_cast<float>(plan.gradientFloor);
}

void BuiltScene::setRays(const RenderPlan& plan) {
    const RayFrame& rays = plan.rays;
    const double perSubPixel = 1.0 / plan.subPixels;
    scene_.perspective = rays.perspective;
    copy(rays.originVoxel + kCellFromVoxel, scene_.origin);
    copy(rays.forwardVoxel, scene_.forward);
    copy(rays.rightVoxel * perSubPixel, scene_.right);
    copy(rays.downVoxel * perSubPixel, scene_.down);
    const glm::dmat3 eyeFromVoxel = rays.eyeFromMm * rays.mmFromVoxel;
    copy(eyeFromVoxel * rays.forwardVoxel, scene_.forwardEye);
    scene_.rightEye = rays.footprintMm * perSubPixel;
    scene_.downEye = -rays.footprintMm * perSubPixel;
    scene_.stepMm = plan.lattice.stepMm;
    scene_.phase = static_cast<float>(plan.lattice.phase);
    scene_.stepRatio = static_cast<float>(plan.lattice.stepMm / plan.referenceLengthMm);
}

void BuiltScene::addPlane(const RenderPlan& plan, const ClipPlane& plane) {
    if (scene_.planeCount == KernelScene::kMaxPlanes) {
        throw Error(ErrorKind::badInput,
                    {"the figure cannot be drawn", "/clip/planes", "more than 26 clip planes", "remove some of them"});
    }
    const Grid& grid = plan.volume->grid();
    const glm::dvec3 normal = glm::transpose(grid.voxelToMmMatrix()) * plane.normal;
    KernelPlane& out = scene_.planes[scene_.planeCount++];
    copy(normal, out.normal);
    out.offset = plane.offsetMm - glm::dot(plane.normal, grid.originMm) + glm::dot(normal, kCellFromVoxel);
}

void BuiltScene::setClip(const RenderPlan& plan) {
    if (plan.clip.boxMm) {
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 normal(0);
            normal[axis] = 1;
            addPlane(plan, {normal, plan.clip.boxMm->high[axis]});
            addPlane(plan, {-normal, -plan.clip.boxMm->low[axis]});
        }
    }
    for (const ClipPlane& plane : plan.clip.planes) {
        addPlane(plan, plane);
    }
}

glm::dvec3 BuiltScene::nodeColour(const PlanLayer& layer, double index) {
    if (layer.styles.nodeToStyle.empty()) {
        return glm::dvec3(0.5); // no nodes at all: mid grey
    }
    const auto node = static_cast<std::size_t>(std::max(index, 0.0));
    const std::size_t next = std::min(node + 1, layer.styles.nodeToStyle.size() - 1);
    const auto colour = [&](std::size_t n) {
        return layer.styles.styles[static_cast<std::size_t>(layer.styles.nodeToStyle[n])].rgb;
    };
    return glm::mix(colour(node), colour(next), index - static_cast<double>(node));
}

void BuiltScene::addColours(const PlanLayer& layer, KernelLayer& out) {
    const std::vector<float>& index = layer.table.index;
    std::vector<Colour> colours;
    colours.reserve(index.size() + 1);
    for (std::size_t entry = 0; entry <= index.size(); ++entry) { // one more: interpolation at the last entry reads it
        const glm::vec3 rgb(nodeColour(layer, index[std::min(entry, index.size() - 1)]));
        colours.push_back({{rgb.r, rgb.g, rgb.b, 1}});
    }
    colours_.push_back(std::move(colours));
    out.colours = colours_.back().front().rgba;
}

void BuiltScene::addLayer(const RenderPlan& plan, const PlanLayer& layer) {
    KernelLayer out;
    out.shading = layer.shading;
    out.twoSided = layer.twoSided;
    out.stepOpacity = keep(layer.stepOpacity);
    if (layer.shading == Shading::style) {
        std::vector<std::int32_t> slots;
        for (const int style : layer.styles.nodeToStyle) {
            slots.push_back(layer.atlasSlots[static_cast<std::size_t>(style)]);
        }
        const bool single = std::all_of(slots.begin(), slots.end(), [&](std::int32_t s) { return s == slots.front(); });
        out.singleSlot = single ? slots.front() : -1;
        out.lastNode = static_cast<std::int32_t>(slots.size()) - 1;
        out.index = keep(layer.table.index);
        out.directionalOpacity = plan.atlas->directionalOpacity &&
                                 std::any_of(layer.styles.styles.begin(), layer.styles.styles.end(), [](const auto& s) {
                                     return s.sphere && s.sphere->hasDirectionalOpacity();
                                 });
        if (out.directionalOpacity) {
            out.opacity = keep(layer.table.opacity);
        }
        slots_.push_back(std::move(slots));
        out.slotOfNode = slots_.back().data();
    } else {
        out.specularStrength = static_cast<float>(layer.specular.strength);
        out.specularExponent = static_cast<float>(layer.specular.exponent);
        addColours(layer, out);
    }
    layers_.push_back(out);
}

void BuiltScene::setTables(const RenderPlan& plan) {
    if (plan.atlas) {
        for (const Rgba& mean : plan.atlas->mean) {
            means_.insert(means_.end(), {mean.r, mean.g, mean.b, mean.a});
        }
        scene_.atlas = {plan.atlas->texels.data(), means_.data(), plan.atlas->size};
    }
    std::vector<float> visibility(2, 0.0F);
    double low = 0;
    double high = 1;
    if (!plan.layers.empty()) {
        const TransferTable& first = plan.layers.front().table;
        visibility.assign(first.opacity.size(), 0.0F);
        low = first.low;
        high = first.high;
    }
    for (const PlanLayer& layer : plan.layers) {
        assert(layer.table.opacity.size() == visibility.size() && layer.table.low == low && layer.table.high == high);
        std::transform(visibility.begin(), visibility.end(), layer.stepOpacity.begin(), visibility.begin(),
                       [](float a, float b) { return std::max(a, b); });
        addLayer(plan, layer);
    }
    const Volume::Contents& contents = plan.volume->contents();
    const double entries = static_cast<double>(visibility.size() - 1);
    const double perValue = high > low ? entries / (high - low) : 0;
    scene_.tableScale = static_cast<float>(contents.slope * perValue / kernelScale(contents.type));
    scene_.tableBias = static_cast<float>((contents.intercept - low) * perValue);
    const auto shows = [](float opacity) { return opacity > 0; };
    const auto firstVisible = std::find_if(visibility.begin(), visibility.end(), shows);
    const auto lastVisible = std::find_if(visibility.rbegin(), visibility.rend(), shows);
    // Interpolation reaches one entry beyond a visible one.
    scene_.visibleFrom = static_cast<float>(firstVisible - visibility.begin() - 1);
    scene_.visibleTo = static_cast<float>(visibility.rend() - lastVisible);
    scene_.visibility = keep(std::move(visibility));
    scene_.layers = layers_.data();
    scene_.layerCount = static_cast<int>(layers_.size());
}

} // namespace limner
