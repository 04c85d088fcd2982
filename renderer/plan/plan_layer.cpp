#include "renderer/plan/plan_layer.h"

#include "renderer/plan/plan_parts.h"

#include <algorithm>
#include <cmath>

namespace limner {

namespace {

/// Scale of the drawing: mm in the target plane for a mm on paper.
double objectMmPerPaperMm(const Figure& figure) { return figure.camera.heightMm / figure.output.heightMm; }

std::optional<PlanContours> planContours(const Contours& source, const LayerSurroundings& around) {
    if (!(source.thicknessMm > 0) && !around.kept.has(LeaveOut::curvature)) {
        return std::nullopt;
    }
    PlanContours contours;
    contours.curvatureControlled = source.curvatureControlled;
    contours.curvature = source.curvature;
    contours.thicknessMm = source.thicknessMm * objectMmPerPaperMm(around.figure);
    contours.probeMm = source.probeVoxels * around.volume.grid().smallestSpacingMm();
    const double share = std::min(source.thicknessMm / kUncontrolledRadiusMm, 1.0);
    contours.fixedWidth = std::sqrt(share * (2 - share)); // core/optics/contour.h
    return contours;
}

/// The greatest opacity of a two-dimensional table in each row.
std::vector<float> greatestOfRows(const TransferTable& table) {
    std::vector<float> greatest;
    const std::size_t columns = table.opacity.size();
    for (int row = 0; row < table.rows; ++row) {
        const auto first = table.opacity2d.begin() + static_cast<std::ptrdiff_t>(columns * row);
        greatest.push_back(*std::max_element(first, first + static_cast<std::ptrdiff_t>(columns)));
    }
    return greatest;
}

/// Entry k of `range` may show where the table's linear interpolation reads anything visible near that value.
void markVisible(const TransferTable& table, const Volume& volume, VisibleRange& range) {
    const std::size_t entries = range.visible.size();
    if (table.axisX != TransferAxis::value) {
        std::fill(range.visible.begin(), range.visible.end(), std::uint8_t{1});
        return;
    }
    const bool falling = volume.contents().slope < 0;
    const double perEntry = static_cast<double>(table.opacity.size() - 1) / static_cast<double>(entries - 1);
    for (std::size_t k = 0; k < entries; ++k) {
        // Every table entry that an interpolation between the values of entries k-1 and k+1 can read.
        const double at = static_cast<double>(k) * perEntry;
        const double reach = perEntry == 1 ? 0 : perEntry + 1;
        const auto first = static_cast<std::size_t>(std::max(0.0, std::ceil(at - reach)));
        const auto last = std::min(table.opacity.size() - 1, static_cast<std::size_t>(std::floor(at + reach)));
        const bool shows = std::any_of(table.opacity.begin() + static_cast<std::ptrdiff_t>(first),
                                       table.opacity.begin() + static_cast<std::ptrdiff_t>(last) + 1,
                                       [](float opacity) { return opacity > 0; });
        range.visible[falling ? entries - 1 - k : k] |= shows ? 1 : 0;
    }
}

/// Tiles no finer than the rays: what is finer would sparkle.
std::vector<PlanTexture> planTextures(const StyleIndex& styles, double sampleMm) {
    std::vector<PlanTexture> textures;
    bool any = false;
    for (const StyleIndex::Entry& entry : styles.styles) {
        textures.emplace_back();
        if (!entry.texture) {
            continue;
        }
        any = true;
        auto tile = entry.texture->tile;
        while (tile->size() > 1 && entry.texture->sizeMm / tile->size() < 0.5 * sampleMm) {
            tile = tile->half();
        }
        textures.back() = {std::move(tile), 1 / entry.texture->sizeMm, entry.texture->strength};
    }
    return any ? textures : std::vector<PlanTexture>{};
}

} // namespace

namespace {

/// Whether a layer reads normals or gradients for more than Phong's light.
bool readsBesidePhong(const PlanLayer& layer) {
    const auto reads = [](const PlanParts& p) {
        return p.tone || p.silhouette || p.specular || p.gradientOpacity || p.lineGradientOpacity;
    };
    return layer.contours || layer.illustrative || readsCurvature(layer) || readsAxis(layer, TransferAxis::gradient) ||
           (layer.parts && reads(*layer.parts));
}

} // namespace

bool drawsSpheres(const PlanLayer& layer) {
    return layer.shading == Shading::style && std::any_of(layer.styles.styles.begin(), layer.styles.styles.end(),
                                                          [](const auto& e) { return e.sphere != nullptr; });
}

namespace {

/// Light that changes no colour reads no normals.
void leaveOutIdleNormals(PlanLayer& layer) {
    const auto is = [](double v, double wanted) { return !(std::abs(v - wanted) > 0); };
    if (layer.shading == Shading::phong && is(layer.light.ambient, 1) && is(layer.light.diffuse, 0) &&
        is(layer.specular.strength, 0)) {
        layer.shading = Shading::flat;
    }
}

} // namespace

PlanLayer planLayer(const Layer& source, const LayerSurroundings& around) {
    PlanLayer layer;
    layer.name = source.name;
    layer.source = &source;
    layer.shading = source.shading;
    layer.twoSided = source.twoSided;
    layer.illustrative = source.transparency == Transparency::illustrative;
    layer.specular = source.specular.value_or(Specular{});
    layer.light = source.phong.value_or(PhongLight{});
    if (source.contours) {
        layer.contours = planContours(*source.contours, around);
    }
    layer.table = bakeTransfer(source, around.volume, around.ranges, around.figure.quality.tableEntries);
    layer.styles = indexStyles(around.figure, source.transfer);
    if (layer.shading == Shading::style && !drawsSpheres(layer)) {
        layer.shading = Shading::flat; // only plain colours: constant spheres are unshaded colour
    }
    if (!around.kept.has(LeaveOut::normals)) {
        leaveOutIdleNormals(layer);
    }
    if (layer.shading == Shading::style) {
        layer.textures = planTextures(layer.styles, around.sampleMm);
    }
    layer.parts = planParts(source, around);
    layer.focus = planFocus(source, around);
    if (source.clip && cutsAnything(*source.clip)) {
        layer.cut = planCut(*source.clip, around.figure, around.rays);
    }
    if (source.transfer.distance && source.transfer.distance->fromMm) {
        layer.distanceFromMm = source.transfer.distance->fromMm;
    }
    return layer;
}

bool showsAnything(const Layer& layer, const TransferTable& table) {
    const auto shows = [](float opacity) { return opacity > 0; };
    if (!(layer.opacity > 0)) {
        return false;
    }
    if (table.rows == 0) {
        return std::any_of(table.opacity.begin(), table.opacity.end(), shows);
    }
    const std::vector<float> rows = greatestOfRows(table);
    return std::any_of(rows.begin(), rows.end(), shows);
}

VisibleRange visibleRange(const std::vector<PlanLayer>& layers, const Volume& volume) {
    ValueRange values = volume.range();
    std::size_t entries = 2;
    for (const PlanLayer& layer : layers) {
        if (layer.table.axisX == TransferAxis::value) {
            entries = std::max(entries, layer.table.opacity.size());
            values = {layer.table.low, layer.table.high}; // of a constant volume wider than the volume's
        }
    }
    VisibleRange range{volume.storedFromValue(values.low), volume.storedFromValue(values.high), {}};
    if (range.low > range.high) {
        std::swap(range.low, range.high); // a falling rescale slope
    }
    range.visible.assign(entries, 0);
    for (const PlanLayer& layer : layers) {
        markVisible(layer.table, volume, range);
    }
    return range;
}

bool readsNormal(const PlanLayer& layer) {
    return layer.shading == Shading::phong || drawsSpheres(layer) || readsBesidePhong(layer);
}

bool readsGradientScale(const PlanLayer& layer) {
    return readsNormal(layer) && (layer.shading != Shading::phong || readsBesidePhong(layer));
}

bool readsCurvature(const PlanLayer& layer) {
    return (layer.contours && layer.contours->curvatureControlled) || readsAxis(layer, TransferAxis::curvature);
}

bool readsSecondDerivatives(const PlanLayer& layer) {
    const bool byContours = layer.contours && layer.contours->curvatureControlled &&
                            layer.contours->curvature == CurvatureEstimator::hessian;
    return byContours || readsAxis(layer, TransferAxis::curvature);
}

bool bendsLevels(const PlanLayer& layer) {
    const bool contoured = layer.contours && layer.contours->thicknessMm > 0;
    return readsSecondDerivatives(layer) && (contoured || readsAxis(layer, TransferAxis::curvature));
}

bool hasOneColour(const PlanLayer& layer) {
    const std::vector<int>& nodes = layer.styles.nodeToStyle;
    const auto all = [&](const auto& same) {
        return !nodes.empty() && std::all_of(nodes.begin(), nodes.end(), [&](int style) {
            return same(static_cast<std::size_t>(style), static_cast<std::size_t>(nodes.front()));
        });
    };
    if (layer.shading == Shading::style) {
        return all([&](std::size_t a, std::size_t b) { return layer.atlasSlots[a] == layer.atlasSlots[b]; });
    }
    return all([&](std::size_t a, std::size_t b) { return layer.styles.styles[a].rgb == layer.styles.styles[b].rgb; });
}

bool readsLabels(const PlanLayer& layer) { return !layer.shownSlots.empty() || !layer.rowOfSlot.empty(); }

bool opacityByValue(const PlanLayer& layer) {
    const bool directional = std::any_of(layer.styles.styles.begin(), layer.styles.styles.end(), [](const auto& style) {
        return style.sphere && style.sphere->hasDirectionalOpacity();
    });
    const bool byParts = layer.parts && changesOpacity(*layer.parts);
    return layer.table.rows == 0 && layer.table.axisX == TransferAxis::value && !layer.illustrative &&
           !(directional && layer.shading == Shading::style) && !readsLabels(layer) && !byParts && !layer.cut &&
           !layer.focus;
}

bool readsAxis(const PlanLayer& layer, TransferAxis axis) {
    return layer.table.axisX == axis || (layer.table.rows > 0 && layer.table.axisY == axis);
}

} // namespace limner
