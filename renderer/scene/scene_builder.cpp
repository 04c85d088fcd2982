#include "renderer/scene/scene_builder.h"

#include "core/base/error.h"
#include "core/optics/measures.h"
#include "renderer/plan/plan_importance.h"
#include "renderer/plan/plan_layer.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace limner {

namespace {

bool leavesOutLookups(const RenderPlan& plan, const PlanLayer& layer) {
    return !plan.kept.has(LeaveOut::colourLookups) && hasOneColour(layer);
}

/// `entries`: where the nodes lie. Farther away than single precision counts they are left to the table.
KernelNodes kernelNodes(const std::vector<double>& entries) {
    constexpr double kFarthest = 1e30;
    KernelNodes nodes;
    const auto far = [](double entry) { return !(std::abs(entry) <= kFarthest); };
    if (entries.empty() || entries.size() > kMostLanes || !std::is_sorted(entries.begin(), entries.end()) ||
        std::any_of(entries.begin(), entries.end(), far)) {
        return nodes;
    }
    nodes.count = static_cast<int>(entries.size());
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const double width = i + 1 < entries.size() ? entries[i + 1] - entries[i] : 0;
        const bool jump = i > 0 && entries[i] == entries[i - 1];
        // A value that lies on a jump is behind it, however its entry was rounded.
        nodes.from[i] = static_cast<float>(jump ? entries[i] - 1.0 / 512 : entries[i]);
        nodes.perEntry[i] = width > 0 ? static_cast<float>(std::min(1 / width, kFarthest)) : 0.0F;
    }
    return nodes;
}

} // namespace

BuiltScene::BuiltScene(const RenderPlan& plan) {
    setVolume(plan);
    setGradients(plan);
    setBends(plan);
    setRays(plan);
    setClip(plan);
    setTables(plan);
    setImportance(plan);
    setBlurs(plan);
    setCues(plan);
    if (plan.faces) {
        scene_.faces = addCut(plan, *plan.faces);
    }
    scene_.opaque = static_cast<float>(1 - plan.earlyTermination);
}

const float* BuiltScene::keep(std::vector<float> table) {
    table.push_back(table.back()); // linear interpolation at the last entry reads one more
    tables_.push_back(std::move(table));
    return tables_.back().data();
}

void BuiltScene::setVolume(const RenderPlan& plan) {
    const Volume& field = *plan.field;
    scene_.bricks = reinterpret_cast<const std::uint8_t*>(field.bricks());
    scene_.type = field.type();
    scene_.spline = plan.interpolation != Interpolation::linear;
    // A store beside the voxels may take more room than they do.
    std::size_t largest = std::max(field.bytes(), plan.gradientField->bytes());
    largest = std::max(largest, plan.secondVolume ? plan.secondVolume->bytes() : 0);
    largest = std::max(largest, plan.bendField ? plan.bendField->bytes() : 0);
    largest = std::max(largest, plan.blurs.empty() ? 0 : plan.blurs.front()->bytes());
    for (const auto* measures : {&plan.importance, &plan.axisMeasures}) {
        largest = std::max(largest, *measures && (*measures)->statistics ? (*measures)->statistics->bytes() : 0);
    }
    for (const PlanLayer& layer : plan.layers) {
        largest = std::max(largest, layer.distance ? layer.distance->bytes() : 0);
    }
    scene_.wide = largest > static_cast<std::size_t>(std::numeric_limits<std::uint32_t>::max());
    scene_.brickStep[0] = 1;
    scene_.brickStep[1] = field.layout().bricks.x;
    scene_.brickStep[2] = field.layout().bricks.x * field.layout().bricks.y;
    for (int i = 0; i < 3; ++i) {
        const int dim = field.grid().dims[i];
        scene_.lastCell[i] = std::nextafter(static_cast<float>(dim), 0.0F);
        scene_.boxLow[i] = kCellFromVoxel[i] - 0.5 + plan.lattice.boxInset;
        scene_.boxHigh[i] = kCellFromVoxel[i] + dim - 0.5 - plan.lattice.boxInset;
        scene_.blocks[i] = plan.skip->blocks[i];
    }
    scene_.distance = plan.skip->distance.data();
    if (plan.labels) {
        scene_.labels = reinterpret_cast<const std::uint8_t*>(plan.labels->bricks());
    }
}

void BuiltScene::setGradients(const RenderPlan& plan) {
    // Gradients are counted in the volume's stored unit: squares of the data's own may leave single precision.
    const double stored = std::abs(plan.volume->contents().slope);
    const double unit = plan.gradientField->contents().slope / plan.volume->contents().slope;
    double scale = unit;
    switch (plan.gradient) {
    case GradientEstimator::sobel: scene_.gradientTaps = KernelTaps::sobel; break;
    case GradientEstimator::neumann: scene_.gradientTaps = KernelTaps::neumann; break;
    case GradientEstimator::bspline: scene_.gradientTaps = KernelTaps::spline; break;
    case GradientEstimator::fourthOrder:
    case GradientEstimator::automatic:
    case GradientEstimator::central:
        scale = unit * 0.5 / kernelScale(plan.field->type()); // central differences span two voxels
        break;
    }
    const bool central = plan.gradient == GradientEstimator::central;
    scene_.gradient = central                                           ? KernelGradient::central
                      : plan.gradient == GradientEstimator::fourthOrder ? KernelGradient::fourthOrder
                                                                        : KernelGradient::taps;
    scene_.gradientBricks = reinterpret_cast<const std::uint8_t*>(plan.gradientField->bricks());
    scene_.gradientOfOwnType = plan.gradientField->type() == plan.field->type();
    const glm::dmat3 cellFromEye = glm::inverse(plan.rays.eyeFromMm * plan.rays.mmFromVoxel);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            scene_.eyeFromGradient[row][column] =
                static_cast<float>(plan.rays.eyeFromGradient[column][row] / stored * scale);
            scene_.cellFromEye[row][column] = static_cast<float>(cellFromEye[column][row]);
        }
    }
    const glm::dmat3 mmFromVoxel = plan.volume->grid().voxelToMmMatrix();
    const glm::dvec3 origin = plan.volume->grid().originMm - mmFromVoxel * kCellFromVoxel;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            scene_.mmFromEye[row][column] = static_cast<float>(plan.rays.eyeFromMm[row][column]);
            scene_.mmFromCell[row][column] = static_cast<float>(mmFromVoxel[column][row]);
        }
        scene_.mmFromCell[row][3] = static_cast<float>(origin[row]);
    }
    scene_.gradientRounding = static_cast<float>(plan.gradientRounding);
    scene_.gradientFloor = static_cast<float>(plan.gradientFloor / stored);
    scene_.perGradientMax = static_cast<float>(stored / plan.gradientMax);
    scene_.readsNormal = readsNormal(plan);
    scene_.readsGradientScale = readsGradientScale(plan);
}

void BuiltScene::setBends(const RenderPlan& plan) {
    if (!plan.bendField) {
        return;
    }
    scene_.readsBend = true;
    scene_.bendBricks = reinterpret_cast<const std::uint8_t*>(plan.bendField->bricks());
    scene_.bendOfOwnType = plan.bendField->type() == plan.field->type();
    const double slope = plan.volume->contents().slope; // a curvature has nothing of the data's unit
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            scene_.eyeFromBend[row][column] = static_cast<float>(plan.rays.eyeFromGradient[column][row] / slope);
        }
    }
}

void BuiltScene::setMeasures(const PlanImportance& from, KernelImportance& out) const {
    const Importance& settings = *from.source;
    const ImportanceWeights& w = settings.weights;
    const auto number = [](double v) { return static_cast<float>(v); };
    out.intensity = number(w.intensity);
    out.gradient = number(w.gradient);
    out.silhouette = number(w.silhouette);
    out.lighting = number(w.lighting);
    out.object = number(w.object);
    const ValueRange& intensity = from.intensity;
    const double span = intensity.high - intensity.low;
    out.intensityScale = number(span > 0 ? valuePerEntry_ / span : 0);
    out.intensityBias = number(span > 0 ? (firstValue_ - intensity.low) / span : 0);
    out.silhouetteExponent = number(settings.silhouette.exponent);
    out.silhouetteLow = number(settings.silhouette.range.x);
    out.silhouetteHigh = number(settings.silhouette.range.y);
    out.highlight = static_cast<unsigned>(settings.lighting.highlight);
    out.diffuse = static_cast<unsigned>(settings.lighting.diffuse);
    out.flat = static_cast<unsigned>(settings.lighting.gradient);
    for (int i = 0; i < 3; ++i) {
        out.light[i] = number(from.lightEye[i]);
    }
    if (!from.weightOfSlot.empty()) {
        out.weightOfSlot = from.weightOfSlot.data();
    }
    if (from.statistics) {
        out.statisticsWeight = number(w.statistics * from.statistics->contents().slope);
        out.statistics = reinterpret_cast<const std::uint8_t*>(from.statistics->bricks());
    }
}

void BuiltScene::setImportance(const RenderPlan& plan) {
    if (plan.axisMeasures) {
        setMeasures(*plan.axisMeasures, scene_.axisImportance);
    }
    if (!plan.importance) {
        return;
    }
    const Importance& settings = *plan.importance->source;
    KernelImportance& out = scene_.importance;
    setMeasures(*plan.importance, out);
    const auto number = [](double v) { return static_cast<float>(v); };
    out.global = number(settings.global);
    out.actsPerWeight = number(settings.global > 0 ? 1 / settings.global : 0);
    out.extinction = number(settings.weights.extinction);
    out.unocclusion = number(settings.weights.unocclusion);
    out.background = number(settings.background);
    out.settles = settlesImportance(plan) && !plan.kept.has(LeaveOut::importanceOfRest);
    out.limit = number(std::min(settings.cap, optics::kGreatestImportance));
    out.noiseFloor = number(settings.noiseFloor);
    out.darkening = number(settings.silhouette.darkening);
    for (const PlanLayer& layer : plan.layers) {
        out.layerMost = std::max(out.layerMost, number(layer.source->importanceWeight));
    }
    ahead_.emplace(plan);
    const std::array<double, 4>& slab = ahead_->slabFromVoxel();
    const glm::dvec3 perCell(slab[0], slab[1], slab[2]);
    for (int i = 0; i < 3; ++i) {
        out.slabFromCell[i] = number(perCell[i]);
    }
    out.slabFromCell[3] = number(slab[3] - glm::dot(perCell, kCellFromVoxel));
}

void BuiltScene::setRays(const RenderPlan& plan) {
    const RayFrame& rays = plan.rays;
    const double perSubPixel = 1.0 / plan.subPixels;
    scene_.perspective = rays.perspective;
    copyTo(rays.originVoxel + kCellFromVoxel, scene_.origin);
    copyTo(rays.forwardVoxel, scene_.forward);
    copyTo(rays.rightVoxel * perSubPixel, scene_.right);
    copyTo(rays.downVoxel * perSubPixel, scene_.down);
    const glm::dmat3 eyeFromVoxel = rays.eyeFromMm * rays.mmFromVoxel;
    copyTo(eyeFromVoxel * rays.forwardVoxel, scene_.forwardEye);
    scene_.rightEye = rays.footprintMm * perSubPixel;
    scene_.downEye = -rays.footprintMm * perSubPixel;
    scene_.stepMm = plan.lattice.stepMm;
    scene_.phase = static_cast<float>(plan.lattice.phase);
    scene_.stepRatio = static_cast<float>(plan.lattice.stepMm / plan.referenceLengthMm);
    if (rays.perspective) {
        const double toPlane = (eyeFromVoxel * rays.forwardVoxel).z;
        const glm::dvec3 perCell(eyeFromVoxel[0].z / toPlane, eyeFromVoxel[1].z / toPlane, eyeFromVoxel[2].z / toPlane);
        for (int i = 0; i < 3; ++i) {
            scene_.depthFromCell[i] = static_cast<float>(perCell[i]);
        }
        scene_.depthFromCell[3] = static_cast<float>(-glm::dot(perCell, rays.originVoxel + kCellFromVoxel));
    }
}

void BuiltScene::addPlane(const RenderPlan& plan, const ClipPlane& plane) {
    if (scene_.planeCount == KernelScene::kMaxPlanes) {
        throw Error(ErrorKind::badInput,
                    {"the figure cannot be drawn", "/clip/planes", "more than 66 clip planes", "remove some of them"});
    }
    const Grid& grid = plan.volume->grid();
    const glm::dvec3 normal = glm::transpose(grid.voxelToMmMatrix()) * plane.normal;
    KernelPlane& out = scene_.planes[scene_.planeCount++];
    copyTo(normal, out.normal);
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

void BuiltScene::addColours(const PlanLayer& layer, KernelLayer& out) {
    std::vector<Colour> nodes;
    for (const int style : layer.styles.nodeToStyle) {
        const glm::vec3 rgb(layer.styles.styles[static_cast<std::size_t>(style)].rgb);
        nodes.push_back({{rgb.r, rgb.g, rgb.b, 1}});
    }
    if (layer.table.rows == 0) {
        const std::vector<float>& index = layer.table.index;
        std::vector<Colour> entries;
        for (std::size_t i = 0; i <= index.size(); ++i) { // one more: interpolation at the last entry reads it
            const float at = std::max(index[std::min(i, index.size() - 1)], 0.0F);
            const auto node = static_cast<std::size_t>(at);
            const Colour& low = nodes[node];
            const Colour& high = nodes[std::min(node + 1, nodes.size() - 1)];
            Colour mixed{};
            for (int c = 0; c < 4; ++c) {
                mixed.rgba[c] = glm::mix(low.rgba[c], high.rgba[c], at - static_cast<float>(node));
            }
            entries.push_back(mixed);
        }
        colours_.push_back(std::move(entries));
        out.colours = colours_.back().front().rgba;
    }
    colours_.push_back(std::move(nodes));
    out.nodeColours = colours_.back().front().rgba;
}

KernelAxis BuiltScene::axis(const RenderPlan& plan, const PlanLayer& layer, TransferAxis which,
                            const AxisEntries& entries) const {
    KernelAxis axis;
    axis.axis = which;
    axis.last = static_cast<float>(entries.count - 1);
    if (which == TransferAxis::value) {
        axis.scale =
            static_cast<float>(static_cast<double>(entries.count - 1) / static_cast<double>(valueEntries_ - 1));
        return axis;
    }
    const double perUnit = entries.high > entries.low ? (entries.count - 1) / (entries.high - entries.low) : 0;
    const auto* stored = which == TransferAxis::second ? plan.secondVolume.get() : layer.distance.get();
    double slope = 1;
    double intercept = 0;
    if ((which == TransferAxis::second || which == TransferAxis::distance) && stored != nullptr) {
        assert(stored->type() == VoxelType::int16);
        axis.bricks = reinterpret_cast<const std::uint8_t*>(stored->bricks());
        slope = stored->contents().slope;
        intercept = stored->contents().intercept;
    } else if (which == TransferAxis::distance) {
        const Grid& grid = plan.volume->grid();
        const glm::dvec3 from = grid.voxelFromMm(layer.distanceFromMm.value_or(glm::dvec3(0))) + kCellFromVoxel;
        const glm::dmat3 matrix = grid.voxelToMmMatrix();
        for (int row = 0; row < 3; ++row) {
            axis.from[row] = static_cast<float>(from[row]);
            for (int column = 0; column < 3; ++column) {
                axis.mmFromCell[row][column] = static_cast<float>(matrix[column][row]);
            }
        }
    }
    axis.scale = static_cast<float>(slope * perUnit);
    axis.bias = static_cast<float>((intercept - entries.low) * perUnit);
    return axis;
}

void BuiltScene::addTransfer(const RenderPlan& plan, const PlanLayer& layer, KernelLayer& out) {
    const TransferTable& table = layer.table;
    const auto entries = static_cast<std::int64_t>(table.opacity.size());
    out.opacityByValue = opacityByValue(layer);
    out.x = axis(plan, layer, table.axisX, {table.low, table.high, entries});
    out.x.nodes = kernelNodes(table.nodeEntries);
    out.index = keep(table.index);
    if (table.rows == 0) {
        out.stepOpacity = keep(layer.stepOpacity);
        out.slabs = plan.preintegrated ? layer.slabs.data() : nullptr;
        out.opacity = keep(table.opacity);
    } else {
        out.y = axis(plan, layer, table.axisY, {table.lowY, table.highY, table.rows});
        out.y.nodes = kernelNodes(table.nodeRows);
        out.rows = table.rows;
        out.rowStride = static_cast<std::int32_t>(entries);
        out.opacity2d = keep(table.opacity2d);
        out.rowIndex = keep(table.rowIndex);
    }
    out.lastColumn = table.nodesX - 1;
    out.lastRow = table.nodesY - 1;
    out.columnStride = table.nodeStrideX;
    out.nodeRowStride = table.nodeStrideY;
    if (!layer.rowOfSlot.empty()) {
        out.rowOfSlot = layer.rowOfSlot.data();
    }
    if (!layer.shownSlots.empty()) {
        out.shownSlots = layer.shownSlots.data();
    }
}

void BuiltScene::addLook(const RenderPlan& plan, const PlanLayer& layer, KernelLayer& out) {
    out.shading = layer.shading;
    out.twoSided = layer.twoSided;
    out.illustrative = layer.illustrative;
    if (layer.contours) {
        out.contours = {true,
                        layer.contours->curvatureControlled,
                        layer.contours->curvature == CurvatureEstimator::normals,
                        static_cast<float>(layer.contours->thicknessMm),
                        static_cast<float>(layer.contours->fixedWidth),
                        static_cast<float>(layer.contours->probeMm)};
    }
    if (layer.shading != Shading::style) {
        out.ambient = static_cast<float>(layer.light.ambient);
        out.diffuse = static_cast<float>(layer.light.diffuse);
        out.specularStrength = static_cast<float>(layer.specular.strength);
        out.specularExponent = static_cast<float>(layer.specular.exponent);
        addColours(layer, out);
        out.oneColour = leavesOutLookups(plan, layer);
        return;
    }
    out.curvedLevels = bendsLevels(layer);
    std::vector<std::int32_t> slots;
    for (const int style : layer.styles.nodeToStyle) {
        slots.push_back(layer.atlasSlots[static_cast<std::size_t>(style)]);
    }
    out.singleSlot = leavesOutLookups(plan, layer) ? slots.front() : -1;
    out.directionalOpacity = plan.atlas->directionalOpacity &&
                             std::any_of(layer.styles.styles.begin(), layer.styles.styles.end(),
                                         [](const auto& s) { return s.sphere && s.sphere->hasDirectionalOpacity(); });
    out.nodes = static_cast<std::int32_t>(slots.size());
    slots.resize(std::max(slots.size(), kMostLanes), 0);
    slots_.push_back(std::move(slots));
    out.slotOfNode = slots_.back().data();
    if (!layer.textures.empty()) {
        std::vector<KernelTexture> textures;
        for (const int style : layer.styles.nodeToStyle) {
            const PlanTexture& texture = layer.textures[static_cast<std::size_t>(style)];
            const float* texels = texture.tile ? &texture.tile->pixels().front().r : nullptr;
            textures.push_back({texels, texture.tile ? texture.tile->size() : 1, static_cast<float>(texture.perMm),
                                static_cast<float>(texture.strength)});
        }
        textures_.push_back(std::move(textures));
        out.textures = textures_.back().data();
    }
}

void BuiltScene::setTables(const RenderPlan& plan) {
    if (plan.atlas) {
        for (const Rgba& mean : plan.atlas->mean) {
            means_.insert(means_.end(), {mean.r, mean.g, mean.b, mean.a});
        }
        scene_.atlas = {plan.atlas->texels.data(), means_.data(), plan.atlas->size};
        if (plan.mipLevels) {
            scene_.atlas.levelStart = plan.atlas->levelStart.data();
            scene_.atlas.lastLevel = static_cast<std::int32_t>(plan.atlas->levelStart.size()) - 1;
            scene_.atlas.radiusTexels = static_cast<float>(plan.mipLevels->radiusTexels);
            scene_.atlas.footprintVoxels = static_cast<float>(plan.mipLevels->footprintVoxels);
            scene_.atlas.voxelMm = static_cast<float>(plan.mipLevels->voxelMm);
        }
    }
    scene_.preintegrated = plan.preintegrated;
    scene_.earlyOpacity = std::all_of(plan.layers.begin(), plan.layers.end(), opacityByValue);
    const VisibleRange range = visibleRange(plan.layers, *plan.volume);
    std::vector<float> visibility(range.visible.begin(), range.visible.end());
    if (plan.volume->contents().slope < 0) {
        std::reverse(visibility.begin(), visibility.end());
    }
    if (!plan.blurs.empty()) { // a sample that shows nothing may show its blurred surroundings
        std::fill(visibility.begin(), visibility.end(), 1.0F);
    }
    valueEntries_ = static_cast<std::int64_t>(visibility.size());
    for (const PlanLayer& layer : plan.layers) {
        KernelLayer out;
        addTransfer(plan, layer, out);
        addLook(plan, layer, out);
        addParts(plan, layer, out);
        out.importanceWeight = static_cast<float>(layer.source->importanceWeight);
        layers_.push_back(out);
    }
    if (scene_.earlyOpacity && plan.layers.size() == 1) {
        visibility = plan.layers.front().stepOpacity;
    }
    setValueTable(plan, std::move(visibility));
    scene_.layers = layers_.data();
    scene_.layerCount = static_cast<int>(layers_.size());
}

/// The widest stretch of the table that shows nothing and has something on either side.
void BuiltScene::setGap(const std::vector<float>& visibility) {
    scene_.gapFrom = scene_.visibleTo;
    scene_.gapTo = scene_.visibleFrom;
    float widest = 1; // one entry is left as it is: nothing lies on it alone
    auto begin = static_cast<std::size_t>(std::max(scene_.visibleFrom, -1.0F) + 1);
    for (std::size_t i = begin; i < visibility.size(); ++i) {
        if (visibility[i] > 0) {
            const auto entries = static_cast<float>(i - begin); // from the last visible one to this
            if (entries > widest) {
                widest = entries;
                scene_.gapFrom = static_cast<float>(begin) + 1;
                scene_.gapTo = static_cast<float>(i) - 1;
            }
            begin = i;
        }
    }
}

void BuiltScene::setValueTable(const RenderPlan& plan, std::vector<float> visibility) {
    double low = plan.volume->range().low;
    double high = plan.volume->range().high;
    for (const PlanLayer& layer : plan.layers) {
        if (layer.table.axisX == TransferAxis::value) {
            low = layer.table.low; // a constant volume's table is as wide as it needs
            high = layer.table.high;
        }
    }
    const Volume::Contents& contents = plan.field->contents();
    const double entries = static_cast<double>(visibility.size() - 1);
    const double perValue = high > low ? entries / (high - low) : 0;
    scene_.tableScale = static_cast<float>(contents.slope * perValue / kernelScale(contents.type));
    scene_.tableBias = static_cast<float>((contents.intercept - low) * perValue);
    scene_.lastEntry = static_cast<float>(entries);
    firstValue_ = low;
    valuePerEntry_ = high > low ? (high - low) / entries : 0;
    const auto shows = [](float opacity) { return opacity > 0; };
    const auto firstVisible = std::find_if(visibility.begin(), visibility.end(), shows);
    const auto lastVisible = std::find_if(visibility.rbegin(), visibility.rend(), shows);
    // Interpolation reaches one entry beyond a visible one.
    scene_.visibleFrom = static_cast<float>(firstVisible - visibility.begin() - 1);
    scene_.visibleTo = static_cast<float>(visibility.rend() - lastVisible);
    setGap(visibility);
    scene_.visibility = keep(std::move(visibility));
}

} // namespace limner
