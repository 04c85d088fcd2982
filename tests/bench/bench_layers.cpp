// What layers, their parts and depth cues cost (paper 003): one layer beside two and four, two layers in one picture
// beside two pictures, and every part on and off.
#include "bench_scene.h"

#include <functional>
#include <iostream>

namespace limner::bench {
namespace {

/// Translucent skin over opaque bone, in one layer.
Figure figureOf(const Scene& scene, Shading shading = Shading::phong) { return sceneFigure(scene, shading, 0.5); }

/// A layer that shows the tissue between two values only.
Layer tissue(const Layer& all, double low, double high) {
    Layer layer = all;
    std::vector<glm::dvec2> points{{low, 0}};
    for (const glm::dvec2& point : all.transfer.opacity) {
        if (point.x > low && point.x < high) {
            points.push_back(point);
        }
    }
    points.push_back({high, 0});
    layer.transfer.opacity = points;
    return layer;
}

double middleValue(const Layer& all) {
    const auto& points = all.transfer.opacity;
    return 0.5 * (points.front().x + points.back().x);
}

Figure onlyLayers(const Figure& figure, std::vector<Layer> layers) {
    Figure changed = figure;
    changed.layers = std::move(layers);
    return changed;
}

void compareLayers(const Scene& scene, int rounds) {
    const Figure one = figureOf(scene);
    const Layer& all = one.layers.front();
    const double split = middleValue(all);
    constexpr double kFar = 1e6;
    const Layer soft = tissue(all, -kFar, split);
    const Layer hard = tissue(all, split, kFar);
    FrameTable table("Layers, each with a transfer function of its own; Phong", rounds);
    table.add("one layer: skin and bone", one);
    table.add("two layers in one picture", onlyLayers(one, {soft, hard}));
    table.add("the first of them alone", onlyLayers(one, {soft}));
    table.add("the second alone", onlyLayers(one, {hard}));
    table.add("the same layer twice, at half its opacity", [&] {
        Layer half = all;
        half.opacity = 0.5;
        return onlyLayers(one, {half, half});
    }());
    table.add("four layers", [&] {
        Layer half = all;
        half.opacity = 0.25;
        return onlyLayers(one, {half, half, half, half});
    }());
    table.run();
}

void compareParts(const Scene& scene, int rounds) {
    const Figure plain = figureOf(scene, Shading::style);
    FrameTable table("Parts of one layer in styles, each alone", rounds);
    table.add("none", plain);
    const auto add = [&](const char* name, const std::function<void(Figure&)>& change) {
        Figure figure = plain;
        change(figure);
        table.add(name, figure);
    };
    const auto only = [](Figure& f) -> Layer& { return f.layers.front(); };
    const std::vector<glm::dvec2> curve{{0, 0.2}, {0.1, 1}, {1, 1}};
    add("tone", [&](Figure& f) { only(f).tone.emplace().keys = {{0, {0.3, 0.4, 0.7}}, {1, {1, 0.95, 0.8}}}; });
    add("highlight", [&](Figure& f) { only(f).specular = Specular{0.3, 20}; });
    add("colour by position", [&](Figure& f) {
        only(f).position.emplace().ramp = {{0, {1, 1, 1, 1}}, {1, {0.7, 0.8, 1, 1}}};
    });
    add("silhouette", [&](Figure& f) { only(f).silhouette.emplace(); });
    add("opacity by gradient", [&](Figure& f) { only(f).gradientOpacity = curve; });
    add("depth of field", [&](Figure& f) { only(f).depthOfField.emplace(); });
    add("clip of the layer", [&](Figure& f) {
        only(f).clip.emplace().planes = {{{1, 0, 0}, f.volume->data->grid().centreMm().x}};
    });
    add("flat cut faces", [&](Figure& f) {
        f.clip.planes = {{{1, 0, 0}, f.volume->data->grid().centreMm().x}};
        f.clip.face.emplace();
    });
    add("the same cut without faces", [&](Figure& f) {
        f.clip.planes = {{{1, 0, 0}, f.volume->data->grid().centreMm().x}};
    });
    add("ambient occlusion", [&](Figure& f) { f.depthCues.emplace().ambientOcclusion.emplace(); });
    add("contact shadow", [&](Figure& f) { f.depthCues.emplace().shadow.emplace(); });
    add("halos", [&](Figure& f) { f.depthCues.emplace().halo.emplace(); });
    add("all parts, of no strength", [&](Figure& f) {
        only(f).tone.emplace();
        only(f).specular.emplace().strength = 0;
        only(f).silhouette.emplace().opacity = 0;
        only(f).position.emplace();
        only(f).depthOfField.emplace().strength = 0;
        f.depthCues.emplace().halo.emplace().strength = 0;
    });
    table.run();
}

int runAll(int argc, char** argv) {
    const int rounds = std::stoi(option(argc, argv, "rounds", "7"));
    const Scene scene = loadScene(option(argc, argv, "volume", ""));
    std::cout << "512^2, step 0.5 voxel; " << machineFacts() << "; " << rounds << " pictures of each in turn\n";
    compareLayers(scene, rounds);
    compareParts(scene, rounds);
    return 0;
}

} // namespace
} // namespace limner::bench

int main(int argc, char** argv) { return limner::bench::runBench(limner::bench::runAll, argc, argv); }
