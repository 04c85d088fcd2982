#include "support/extreme_parts.h"

#include "support/transfer_scenes.h"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace limner::testing {

namespace {

void eachPosition(Transfer& transfer, const std::string& axis, const std::function<void(double&)>& change) {
    if (transfer.kind == TransferKind::oneDimensional) {
        if (transfer.axis != axis) {
            return;
        }
        for (TransferNode& node : transfer.nodes) {
            change(node.at);
        }
        for (glm::dvec2& point : transfer.opacity) {
            change(point.x);
        }
        return;
    }
    const auto all = [&](std::vector<double>& positions) { std::for_each(positions.begin(), positions.end(), change); };
    for (int k = 0; k < 2; ++k) {
        if (transfer.axes[static_cast<std::size_t>(k)] != axis) {
            continue;
        }
        all(k == 0 ? transfer.grid->x : transfer.grid->y);
        for (OpacityShape& shape : transfer.opacity2d) {
            all(k == 0 ? shape.x : shape.y);
        }
        if (k == 0) {
            for (glm::dvec2& point : transfer.opacity) {
                change(point.x);
            }
        }
    }
}

std::shared_ptr<const Volume> withGrid(const Volume& volume, const Grid& grid) {
    Volume::Contents contents = volume.contents();
    contents.grid = grid;
    const glm::ivec3 dims = grid.dims;
    const std::size_t row = static_cast<std::size_t>(dims.x) * bytesPerVoxel(volume.type());
    std::vector<std::byte> stored(row * static_cast<std::size_t>(dims.y) * static_cast<std::size_t>(dims.z));
    for (int i = 0; i < dims.y * dims.z; ++i) {
        volume.copyRow(i % dims.y, i / dims.y, stored.data() + row * static_cast<std::size_t>(i));
    }
    return std::make_shared<const Volume>(contents, stored);
}

void scaleClip(Clip& clip, double factor) {
    for (ClipPlane& plane : clip.planes) {
        plane.offsetMm *= factor;
    }
    if (clip.boxMm) {
        clip.boxMm->low *= factor;
        clip.boxMm->high *= factor;
    }
}

void pushCurve(Dice& dice, Transfer& transfer, std::string& story) {
    const double all[] = {0, 1e-8, 1e-4, 0.3, 0.9999, 1};
    for (glm::dvec2& point : transfer.opacity) {
        if (dice.oneIn(2)) {
            point.y = all[dice.below(6)];
        }
    }
    if (!transfer.opacity.empty() && dice.oneIn(3)) { // a step of no width at a point
        const auto at = static_cast<std::size_t>(dice.below(static_cast<int>(transfer.opacity.size())));
        const glm::dvec2 point{transfer.opacity[at].x, all[dice.below(6)]};
        transfer.opacity.insert(transfer.opacity.begin() + static_cast<std::ptrdiff_t>(at) + 1, 1 + dice.below(2),
                                point);
        story += ", a step of no width";
    }
    for (OpacityShape& shape : transfer.opacity2d) {
        shape.opacity = all[dice.below(6)];
        shape.soft = dice.any({0.0, 1e-9, 1.0});
    }
}

} // namespace

Figure extremeLayers(Dice& dice, std::string& story) {
    SmoothScene small;
    small.dims = glm::ivec3(4);
    Figure figure = smoothFigure(small);
    const auto& features = transferFeatures();
    std::vector<Layer> layers;
    for (int k = 0; k < dice.any({1, 1, 2, 3}); ++k) {
        const auto& feature = features[static_cast<std::size_t>(dice.below(static_cast<int>(features.size())))];
        figure.layers.resize(1);
        figure.layers[0] = Layer();
        figure.layers[0].name = "matter";
        figure.layers[0].shading = dice.any({Shading::flat, Shading::phong, Shading::style});
        makeLine(figure.layers[0], "value");
        feature.apply(figure);
        layers.insert(layers.end(), figure.layers.begin(), figure.layers.end());
        story += ", " + feature.name;
    }
    figure.layers = layers;
    return figure;
}

void pushTransfers(Dice& dice, Figure& figure, std::string& story) {
    for (Layer& layer : figure.layers) {
        if (dice.oneIn(2)) {
            pushCurve(dice, layer.transfer, story);
        }
        if (dice.oneIn(5)) {
            layer.transfer.curve = dice.any({OpacityCurve::smooth, OpacityCurve::step});
        }
        if (dice.oneIn(8) && layer.transfer.kind == TransferKind::oneDimensional) { // all nodes at one place
            for (TransferNode& node : layer.transfer.nodes) {
                node.at = layer.transfer.nodes.front().at;
            }
            story += ", nodes in one place";
        }
        if (dice.oneIn(6)) {
            layer.opacity = dice.any({1e-8, 0.5});
        }
    }
}

void keepPeaksBelow(Figure& figure, double opacity) {
    for (Layer& layer : figure.layers) {
        for (glm::dvec2& point : layer.transfer.opacity) {
            point.y = std::min(point.y, opacity);
        }
        for (OpacityShape& shape : layer.transfer.opacity2d) {
            shape.opacity = std::min(shape.opacity, opacity);
        }
    }
}

namespace {

void pushImportance(Dice& dice, Importance& importance, std::string& story) {
    importance.global = dice.any({1e-6, 1.0, 30.0, 1e6});
    double* const weights[] = {&importance.weights.intensity,   &importance.weights.extinction,
                               &importance.weights.gradient,    &importance.weights.silhouette,
                               &importance.weights.unocclusion, &importance.weights.lighting,
                               &importance.weights.object,      &importance.weights.statistics};
    for (double* weight : weights) {
        *weight = dice.oneIn(3) ? dice.any({1e-3, 1.0, 1e3, 1e6}) : 0;
    }
    importance.objects = {{3, dice.unit()}, {7, dice.any({1.0, 1e6})}};
    importance.cap = dice.any({0.0, 2.0, 8.0, 20.0, 64.0});
    importance.noiseFloor = dice.any({0.0, 0.02, 10.0});
    importance.background = dice.oneIn(3) ? dice.any({1.0, 8.0, 1e6}) : 0;
    importance.silhouette.range = dice.oneIn(3) ? glm::dvec2(0.5, 0.5) : glm::dvec2(0.4, 1);
    for (int k = 0; k < dice.below(3); ++k) {
        Lens lens;
        lens.kind = dice.any<const char*>({"circular", "gaussian", "screendoor"});
        lens.shape = dice.any<const char*>({"circle", "ellipse", "box"});
        lens.center = {dice.between(0, 1), dice.between(0, 1)};
        lens.radius = dice.any({1e-6, 0.2, 50.0});
        lens.aspect = dice.any({1.0, 1e-3, 1e3});
        lens.angleDeg = dice.between(-400, 400);
        lens.soft = dice.any({0.0, 1.0});
        lens.cell = dice.any({1e-6, 0.05});
        importance.lenses.push_back(lens);
        story += ", a lens";
    }
    story += ", importance";
}

void pushContours(Dice& dice, Layer& layer) {
    layer.contours =
        Contours{dice.any({1e-6, 0.8, 1e3}), dice.oneIn(2),
                 dice.any({CurvatureEstimator::hessian, CurvatureEstimator::normals}), dice.any({0.01, 1.0, 20.0})};
}

void pushCues(Dice& dice, DepthCues& cues) {
    if (dice.oneIn(2)) {
        cues.ambientOcclusion = AmbientOcclusion{dice.unit(), dice.any({0.01, 6.0, 1e3})};
    }
    if (dice.oneIn(2)) {
        cues.shadow = ContactShadow{{"head", {-0.5, 0.5, 0.6}}, dice.unit(), dice.any({0.01, 9.0, 1e3}), 15};
    }
    if (dice.oneIn(2)) {
        cues.halo = Halo{{0.1, 0.2, 0.3}, dice.unit(), dice.any({0.01, 2.0, 100.0}), dice.any({0.01, 8.0, 1e3})};
    }
}

} // namespace

void pushParts(Dice& dice, Figure& figure, std::string& story) {
    Quality& quality = figure.quality;
    quality.earlyTermination = dice.any({0.0, 1e-5, 1e-3, 0.3});
    quality.gradient =
        dice.any({GradientEstimator::automatic, GradientEstimator::central, GradientEstimator::sobel,
                  GradientEstimator::neumann, GradientEstimator::fourthOrder, GradientEstimator::bspline});
    quality.interpolation =
        dice.any({Interpolation::automatic, Interpolation::linear, Interpolation::tricubic, Interpolation::smooth});
    if (dice.oneIn(4)) {
        pushImportance(dice, figure.importance.emplace(), story);
    }
    for (Layer& layer : figure.layers) {
        if (dice.oneIn(6)) {
            pushContours(dice, layer);
        }
        if (layer.specular && dice.oneIn(2)) {
            layer.specular->exponent = dice.any({1.0, 200.0});
        }
    }
    if (dice.oneIn(6)) {
        pushCues(dice, figure.depthCues.emplace());
        story += ", cues";
    }
    if (dice.oneIn(8)) { // planes that cut at a voxel, all of it away, or nothing
        figure.clip.planes.push_back({{0, dice.any({1e-3, 1.0, 1e3}), 0}, dice.any({0.0, -1e9, 1e9})});
        story += ", a clip";
    }
}

void moveValues(Figure& figure, double factor, double offset) {
    for (Layer& layer : figure.layers) {
        eachPosition(layer.transfer, "value", [&](double& at) { at = factor * at + offset; });
    }
}

void shiftAlong(Transfer& transfer, const std::string& axis, double by) {
    eachPosition(transfer, axis, [by](double& at) { at += by; });
}

void scaleLengths(Figure& figure, double factor) {
    const auto scaled = [&](const std::shared_ptr<const Volume>& volume) {
        Grid grid = volume->grid();
        grid.spacingMm *= factor;
        grid.originMm *= factor;
        return withGrid(*volume, grid);
    };
    figure.volume->data = scaled(figure.volume->data);
    figure.labels->data = scaled(figure.labels->data);
    figure.secondVolume->data = scaled(figure.secondVolume->data);
    figure.camera.targetMm *= factor;
    figure.camera.heightMm *= factor;
    scaleClip(figure.clip, factor);
    for (Layer& layer : figure.layers) {
        eachPosition(layer.transfer, "distance", [&](double& at) { at *= factor; });
        eachPosition(layer.transfer, "curvature", [&](double& at) { at /= factor; });
        if (layer.transfer.distance && layer.transfer.distance->fromMm) {
            *layer.transfer.distance->fromMm *= factor;
        }
        if (layer.clip) {
            scaleClip(*layer.clip, factor);
        }
    }
    if (figure.depthCues) {
        DepthCues& cues = *figure.depthCues;
        if (cues.ambientOcclusion) {
            cues.ambientOcclusion->reachMm *= factor;
        }
        if (cues.shadow) {
            cues.shadow->reachMm *= factor;
        }
        if (cues.halo) {
            cues.halo->depthMm *= factor;
        }
    }
}

} // namespace limner::testing
