// What importance-aware composition costs (paper 001): beside ordinary composition at equal samples, with lenses, and
// what the rays' early end saves.
#include "bench_scene.h"

#include <iostream>

namespace limner::bench {
namespace {

/// Translucent skin over bone, in styles. Without an early end every composition takes the same samples.
Figure figureOf(const Scene& scene, double earlyTermination) {
    Figure figure = sceneFigure(scene, Shading::style, 0.5);
    figure.quality.earlyTermination = earlyTermination;
    return figure;
}

Figure weighed(Figure figure, const ImportanceWeights& weights) {
    figure.importance.emplace();
    figure.importance->global = 1;
    figure.importance->weights = weights;
    return figure;
}

ImportanceWeights three() {
    ImportanceWeights weights;
    weights.extinction = 1;
    weights.gradient = 1;
    weights.silhouette = 1;
    return weights;
}

Figure withLens(Figure figure, double radius) {
    Lens lens;
    lens.radius = radius;
    lens.kind = "circular";
    figure.importance->lenses = {lens};
    return figure;
}

void compareAtEqualSamples(const Scene& scene, int rounds) {
    const Figure plain = figureOf(scene, 0);
    FrameTable table("Equal samples: no early end", rounds);
    table.add("ordinary composition", plain);
    ImportanceWeights one;
    one.intensity = 1;
    table.add("intensity", weighed(plain, one));
    one = {};
    one.extinction = 1;
    table.add("extinction", weighed(plain, one));
    table.add("extinction, gradient, silhouette", weighed(plain, three()));
    ImportanceWeights six = three();
    six.intensity = 1;
    six.unocclusion = 0.1;
    six.lighting = 1;
    table.add("all six", weighed(plain, six));
    table.add("the three in a lens on 7 % of the picture", withLens(weighed(plain, three()), 0.15));
    Figure unused = weighed(plain, three());
    unused.importance->global = 0;
    table.add("the three, of no weight", unused);
    table.run();
}

void compareEnds(const Scene& scene, int rounds) {
    ImportanceWeights unoccluded;
    unoccluded.unocclusion = 0.3;
    FrameTable table("Early end: samples taken to a tolerance of 1/255", rounds);
    table.add("ordinary composition", figureOf(scene, 1.0 / 255));
    for (const double tolerance : {0.0, 1.0 / 255}) {
        const std::string end = tolerance > 0 ? "" : ", to the last sample";
        const Figure figure = figureOf(scene, tolerance);
        table.add("extinction, gradient, silhouette" + end, weighed(figure, three()));
        table.add("unocclusion" + end, weighed(figure, unoccluded));
        table.add("the three in a lens" + end, withLens(weighed(figure, three()), 0.15));
    }
    table.run();
}

int runAll(int argc, char** argv) {
    const int rounds = std::stoi(option(argc, argv, "rounds", "7"));
    const Scene scene = loadScene(option(argc, argv, "volume", ""));
    std::cout << "512^2, step 0.5 voxel; " << machineFacts() << "; " << rounds << " pictures of each in turn\n";
    compareAtEqualSamples(scene, rounds);
    compareEnds(scene, rounds);
    return 0;
}

} // namespace
} // namespace limner::bench

int main(int argc, char** argv) { return limner::bench::runBench(limner::bench::runAll, argc, argv); }
