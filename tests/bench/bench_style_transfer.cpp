// What style transfer functions cost (paper 000, Table 1): styles beside Phong's light at four opacity settings, two
// dimensions beside one, contours and transparency beside none, and what a figure pays for parts that it does not use.
#include "bench_scene.h"

#include <iostream>

namespace limner::bench {
namespace {

/// Opacity curves over HU, from one surface to haze: as the four settings of the paper's table.
struct Setting {
    const char* name;
    std::vector<glm::dvec2> opacity;
};
const std::vector<Setting>& settings() {
    static const std::vector<Setting> list = {
        {"opaque bone", {{180, 0}, {320, 1}, {3000, 1}}},
        {"opaque skin", {{-500, 0}, {-300, 1}, {3000, 1}}},
        {"skin over bone", {{-500, 0}, {-300, 0.12}, {-50, 0}, {180, 0}, {320, 0.8}, {3000, 1}}},
        {"all tissue", {{-500, 0}, {-200, 0.01}, {100, 0.02}, {3000, 0.08}}},
    };
    return list;
}

Figure figureOf(const Scene& scene, Shading shading, const Setting& setting) {
    Figure figure = sceneFigure(scene, shading, 0.5);
    figure.layers.front().transfer.opacity = setting.opacity;
    return figure;
}

/// The same nodes and curve over value and gradient: opacity times a ramp over the gradient that is 1 throughout.
Figure inTwoDimensions(Figure figure) {
    Transfer& transfer = figure.layers.front().transfer;
    TransferGrid grid;
    grid.y = {0, 1};
    grid.styles.resize(2);
    for (const TransferNode& node : transfer.nodes) {
        if (!grid.x.empty() && !(node.at > grid.x.back())) {
            continue; // columns rise
        }
        grid.x.push_back(node.at);
        grid.styles[0].push_back(node.style);
        grid.styles[1].push_back(node.style);
    }
    transfer.kind = TransferKind::twoDimensional;
    transfer.axes = {"value", "gradient"};
    transfer.nodes.clear();
    transfer.grid = grid;
    return figure;
}

Figure withContours(Figure figure) {
    figure.layers.front().contours = Contours{};
    figure.layers.front().transparency = Transparency::illustrative;
    return figure;
}

/// Parts that a figure keeps and does not draw with: a hidden layer that asks for everything.
Figure withUnusedParts(Figure figure) {
    Figure all = withContours(inTwoDimensions(figure));
    Layer hidden = all.layers.front();
    hidden.visible = false;
    figure.layers.push_back(hidden);
    return figure;
}

int runAll(int argc, char** argv) {
    const int rounds = std::stoi(option(argc, argv, "rounds", "7"));
    const Scene scene = phantomScene(256);
    std::cout << "built-in head, 256^3, 512^2, step 0.5 voxel; " << machineFacts() << "; " << rounds
              << " pictures of each in turn\n";
    for (const Setting& setting : settings()) {
        FrameTable table(std::string("Opacity: ") + setting.name, rounds);
        const Figure styled = figureOf(scene, Shading::style, setting);
        table.add("regular transfer function, Phong", figureOf(scene, Shading::phong, setting));
        table.add("style transfer function", styled);
        table.run();
        FrameTable parts(std::string("Parts, opacity: ") + setting.name, rounds);
        parts.add("style transfer function", styled);
        parts.add("two dimensions", inTwoDimensions(styled));
        parts.add("contours and transparency", withContours(styled));
        parts.add("the first, with parts it does not use", withUnusedParts(styled));
        parts.run();
    }
    return 0;
}

} // namespace
} // namespace limner::bench

int main(int argc, char** argv) { return limner::bench::runBench(limner::bench::runAll, argc, argv); }
