#include "renderer/accuracy/importance_scenes.h"

#include <algorithm>
#include <cmath>

namespace limner::accuracy {

namespace {

/// A field that is x on `voxels` voxels along x, seen along x by one ray.
AnalyticScene alongX(const std::string& name, int voxels, double spacingMm) {
    Grid grid;
    grid.dims = {voxels, 2, 2};
    grid.spacingMm = glm::dvec3(spacingMm);
    const auto volume = sampleField(grid, [](const glm::dvec3& mm) { return mm.x; });
    Camera camera = viewAlongZ(grid.centreMm(), 0.5 * spacingMm);
    camera.direction = {1, 0, 0};
    AnalyticScene scene{name, plainFigure(volume, camera), {}};
    scene.request.size = {1, 1};
    Importance& settings = scene.figure.importance.emplace();
    settings.cap = 64;
    settings.noiseFloor = 0;
    return scene;
}

/// Every voxel whose middle lies at x > `fromMm` is of the object 1, of that importance.
void weighObject(AnalyticScene& scene, double fromMm, double importance) {
    scene.figure.importance->weights.object = 1;
    scene.figure.importance->objects = {{1, importance}};
    const Grid& grid = scene.figure.volume->data->grid();
    scene.figure.labels.emplace();
    scene.figure.labels->data = sampleField(grid, [&](const glm::dvec3& mm) { return mm.x > fromMm ? 1 : 0; });
}

constexpr int kUnitVoxels = 65; ///< 64 cells along 1 mm

} // namespace

AnalyticScene ImportancePair::scene(int stepsPerSlab) const {
    constexpr int slab = 16; // of 40 cells along x; 8 of the gap
    AnalyticScene scene = alongX("A5", 41, 1);
    scene.request.lattice = SampleLattice{static_cast<double>(slab) / stepsPerSlab, 0.5, 0.5};
    Transfer& transfer = scene.figure.layers.front().transfer;
    const glm::dvec3 red(1, 0, 0);
    const glm::dvec3 green(0, 1, 0);
    transfer.nodes = {{0, "", red}, {19, "", red}, {21, "", green}, {40, "", green}};
    const double front = frontOpacity < 1 ? -std::expm1(std::log1p(-frontOpacity) / slab) : 1;
    const double back = -std::expm1(-depth / slab);
    transfer.opacity = {{0, front}, {16, front}, {16, 0}, {24, 0}, {24, back}, {40, back}};
    weighObject(scene, 20, importance); // labels change in the gap
    return scene;
}

glm::dvec3 ImportancePair::weights() const {
    const double b0 = std::min(frontOpacity, std::exp(-importance));
    const double claimed = -std::expm1(-depth); // of what is not claimed yet
    const double b = b0 + (1 - b0) * claimed;
    const double a = frontOpacity + (1 - frontOpacity) * claimed;
    return {a * b0 / b, a * (1 - b0) * claimed / b, a};
}

std::array<ImportanceRow, 7> importanceTable() {
    return {{
        {{0.99, 2, 0.5}, {0.2828581768, 0.7110765167, 0.9939346934}},
        {{0.99, 20, 0.5}, {5.206637157e-9, 0.9939346882, 0.9939346934}},
        {{0.99, 20, 1e-7}, {0.0199933287, 0.9700066723, 0.9900000010}},
        {{0.99, 20, std::exp(-20.0)}, {0.4950000008, 0.4949999992, 0.9900000000}},
        {{1, std::log(1000.0), 1}, {0.001581056569, 0.9984189434, 1}},
        {{0.5, 0.3, 2}, {0.5, 0.4323323584, 0.9323323584}}, // the ordinary picture: nothing claims more than its share
        {{0.99, 0, 1}, {0.99, 0.006321205588, 0.9963212056}},
    }};
}

AnalyticScene RisingImportance::scene(double stepMm) const {
    AnalyticScene scene = alongX("A5 rising", kUnitVoxels, 1.0 / (kUnitVoxels - 1));
    scene.request.lattice = SampleLattice{stepMm, 0.5, 0.5};
    Transfer& transfer = scene.figure.layers.front().transfer;
    transfer.nodes = {{0, "", glm::dvec3(0)}, {1, "", glm::dvec3(1)}};
    transfer.opacity = {{0, opacityOfMedium(extinctionPerMm, 1.0 / (kUnitVoxels - 1))}};
    scene.figure.importance->weights.intensity = slope; // the measure is the place in the data's range
    return scene;
}

double RisingImportance::premultiplied() const {
    const double s = extinctionPerMm;
    const double g = slope;
    const double part = s / (s + g);
    const auto opacity = [&](double x) { return -std::expm1(-s * x); };
    const auto exponential = [&](double x) { return std::exp(-s * x) * (1 + part * std::expm1((s + g) * x)); };
    const auto integral = [&](double x) { return (1 - part) * opacity(x) / s + part * std::expm1(g * x) / g; };
    double before = 0; // the place where opacity and importance claim the same; before it composition is the ordinary
    double behind = 1;
    for (int halving = 0; halving < 100; ++halving) {
        const double middle = 0.5 * (before + behind);
        (opacity(middle) < exponential(middle) * std::exp(-g * middle) ? before : behind) = middle;
    }
    const double ordinary = (1 / s - std::exp(-s * before) * (before + 1 / s)) / opacity(before);
    const double colour = ordinary * exponential(before) + exponential(1) - exponential(before) * before -
                          (integral(1) - integral(before));
    return colour / exponential(1) * opacity(1);
}

AnalyticScene ThinSheet::scene(double stepMm) const {
    AnalyticScene scene = alongX("A8", kUnitVoxels, 1.0 / (kUnitVoxels - 1));
    scene.request.lattice = SampleLattice{stepMm, 0.5, 0.5};
    const double opacity = opacityOfMedium(extinctionPerMm, 1.0 / (kUnitVoxels - 1));
    const double behind = frontMm + thicknessMm;
    Layer& matter = scene.figure.layers.front();
    matter.transfer.nodes = {{0, "", glm::dvec3(0)}};
    matter.transfer.opacity = {{0, opacity}, {frontMm, opacity}, {frontMm, 0},
                               {behind, 0},  {behind, opacity},  {1, opacity}};
    matter.importanceWeight = 0;
    Layer sheet = matter;
    sheet.name = "sheet";
    sheet.transfer.nodes = {{0, "", glm::dvec3(1)}};
    sheet.transfer.opacity = {{0, 0}, {frontMm, 0}, {frontMm, opacity}, {behind, opacity}, {behind, 0}, {1, 0}};
    sheet.importanceWeight = 1;
    scene.figure.layers.push_back(sheet);
    weighObject(scene, -1, importance); // everywhere: what matters is the layer
    return scene;
}

double ThinSheet::premultiplied() const {
    const double b0 = std::min(opacityOfMedium(extinctionPerMm, frontMm), std::exp(-importance));
    const double b = b0 + (1 - b0) * opacityOfMedium(extinctionPerMm, thicknessMm);
    // What comes behind is laid under it: opacity then is what it was behind the sheet.
    return opacityOfMedium(extinctionPerMm, frontMm + thicknessMm) * (b - b0) / b;
}

} // namespace limner::accuracy
