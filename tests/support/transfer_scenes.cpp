#include "support/transfer_scenes.h"

#include "renderer/accuracy/analytic_scenes.h"
#include "support/dice.h"
#include "support/make_volume.h"
#include "support/part_scenes.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cmath>

namespace limner::testing {

namespace {

double lumpyBall(const glm::dvec3& mm) {
    return std::exp(-glm::dot(mm, mm) / 120) * (1 + 0.15 * std::sin(0.35 * mm.x) * std::cos(0.3 * mm.y + 0.2 * mm.z));
}

Grid obliqueGrid(glm::ivec3 dims) {
    Grid grid;
    grid.dims = dims;
    grid.spacingMm = {1, 1.25, 0.8};
    grid.direction = glm::dmat3({0.8, 0.6, 0}, {-0.48, 0.64, 0.6}, {0.36, -0.48, 0.8});
    grid.originMm = -grid.direction * (grid.spacingMm * (glm::dvec3(dims - 1) / 2.0));
    return grid;
}

std::shared_ptr<const Volume> asType(const Grid& grid, VoxelType type, bool falling) {
    const auto smooth = accuracy::sampleField(grid, lumpyBall);
    if (type == VoxelType::float32) {
        return smooth;
    }
    const double low = type == VoxelType::uint8 ? 0 : -30000;
    const double high = type == VoxelType::uint8 ? 255 : 30000;
    const ValueRange range = smooth->range();
    const double slope = (falling ? -1 : 1) * (range.high - range.low) / (high - low);
    const double intercept = (falling ? range.high : range.low) - slope * low;
    const auto at = [&](const glm::ivec3& voxel) { return std::round((smooth->valueAt(voxel) - intercept) / slope); };
    return type == VoxelType::uint8 ? makeVolume<std::uint8_t>(grid, type, at, slope, intercept)
                                    : makeVolume<std::int16_t>(grid, type, at, slope, intercept);
}

/// Three slabs with wavy borders.
int labelAt(const glm::dvec3& mm) {
    const double height = mm.z + 0.3 * mm.x + 2 * std::sin(0.25 * mm.y);
    return height < -4 ? 0 : height < 3 ? 3 : 7;
}

std::shared_ptr<const Volume> labelsOn(const Grid& grid) {
    return makeVolume<std::uint8_t>(grid, VoxelType::uint8,
                                    [&](const glm::ivec3& voxel) { return labelAt(grid.mmFromVoxel(voxel)); });
}

/// No finer than these pictures resolve, so that it is drawn without a mip level.
std::shared_ptr<const LitSphere> smoothSphere(int kind) {
    constexpr int size = 64;
    std::vector<Rgba> pixels;
    for (int i = 0; i < size * size; ++i) {
        const double x = (i % size + 0.5) / size;
        const double y = (i / size + 0.5) / size;
        pixels.push_back({static_cast<float>(0.5 + 0.4 * std::sin(3 * x + kind)),
                          static_cast<float>(0.5 + 0.4 * std::cos(2 * x + y - kind)), static_cast<float>(x * y),
                          kind == 2 ? static_cast<float>(0.3 + 0.6 * x) : 1.0F});
    }
    return std::make_shared<const LitSphere>(size, std::move(pixels));
}

StyleEntry styleEntry(const std::string& id, int kind) {
    StyleEntry entry;
    entry.id = id;
    entry.sphere = smoothSphere(kind);
    return entry;
}

/// Where something happens along an axis in these scenes.
ValueRange usualRange(const std::string& axis) {
    if (axis == "distance") {
        return {2, 16};
    }
    if (axis == "curvature") {
        return {0.02, 0.2};
    }
    return axis == "gradient" ? ValueRange{0.1, 0.9} : ValueRange{0.15, 0.95};
}

std::vector<double> nodesAlong(const std::string& axis) {
    if (axis == "label") {
        return {-1, 3, 7};
    }
    const ValueRange range = usualRange(axis);
    return {range.low, 0.6 * range.low + 0.4 * range.high, range.high};
}

/// Start, full, full, end of a ramp up and down; label axes are full throughout.
std::vector<double> rampsAlong(const std::string& axis) {
    if (axis == "label") {
        return {-2, -2, 10, 10};
    }
    const ValueRange range = usualRange(axis);
    const double width = range.high - range.low;
    return {range.low, range.low + 0.4 * width, range.low + 0.7 * width, range.low + 1.2 * width};
}

const glm::dvec3 kColours[] = {{0.9, 0.2, 0.1}, {0.2, 0.6, 0.9}, {0.8, 0.8, 0.2}, {0.3, 0.7, 0.4}};
const char* const kCells[] = {"a", "#c04020", "b", "#2090e0", "#d0d040"};
const char* const kPlainCells[] = {"#e04020", "#c0a020", "#40b060", "#2090e0", "#d0d040"};

void setDistance(Layer& layer, bool toLabel) {
    layer.transfer.distance.emplace();
    if (toLabel) {
        layer.transfer.distance->label = 3;
    } else {
        layer.transfer.distance->fromMm = glm::dvec3(3, -2, 6);
    }
}

} // namespace

Figure smoothFigure(const SmoothScene& scene) {
    Camera camera;
    camera.projection = scene.projection;
    camera.direction = {0.3, 0.9, -0.4};
    camera.heightMm = 34;
    const Grid grid = obliqueGrid(scene.dims);
    Figure figure = accuracy::plainFigure(asType(grid, scene.type, scene.falling), camera);
    figure.quality.stepVoxels = 0.45;
    figure.output.widthMm = figure.output.heightMm = 34; // the object at its own size
    figure.labels.emplace();
    figure.labels->data = labelsOn(grid);
    figure.secondVolume.emplace();
    figure.secondVolume->data = accuracy::sampleField(accuracy::centredGrid(24, 2), [](const glm::dvec3& mm) {
        return 0.5 + 0.4 * std::sin(0.15 * mm.x + 0.1 * mm.z) * std::cos(0.12 * mm.y);
    });
    figure.styles = {styleEntry("a", 0), styleEntry("b", 1), styleEntry("c", 2)};
    makeLine(figure.layers.front(), "value");
    return figure;
}

void moveLabelsToAnotherGrid(Figure& figure) {
    Grid grid = accuracy::centredGrid(21, 1.9);
    grid.direction = glm::dmat3({0, 1, 0}, {-1, 0, 0}, {0, 0, 1});
    grid.originMm = -grid.direction * (grid.spacingMm * 10.0);
    figure.labels->data = labelsOn(grid);
}

void makeLine(Layer& layer, const std::string& axis) {
    Transfer transfer;
    transfer.axis = axis;
    transfer.distance = layer.transfer.distance;
    const std::vector<double> nodes = nodesAlong(axis);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const bool style = layer.shading == Shading::style && k != 1;
        transfer.nodes.push_back({nodes[k], style ? (k == 0 ? "a" : "b") : "", kColours[k]});
    }
    transfer.opacity = {{nodes.front(), axis == "label" ? 0.02 : 0.0}, {nodes[1], 0.1}, {nodes.back(), 0.3}};
    layer.transfer = transfer;
}

void makePlane(Layer& layer, const std::string& first, const std::string& second) {
    Transfer transfer;
    transfer.kind = TransferKind::twoDimensional;
    transfer.axes = {first, second};
    transfer.distance = layer.transfer.distance;
    transfer.grid.emplace();
    transfer.grid->x = nodesAlong(first);
    transfer.grid->y = nodesAlong(second);
    int cell = 0;
    for (std::size_t row = 0; row < transfer.grid->y.size(); ++row) {
        transfer.grid->styles.emplace_back();
        for (std::size_t column = 0; column < transfer.grid->x.size(); ++column, ++cell) {
            transfer.grid->styles.back().emplace_back(layer.shading == Shading::style ? kCells[cell % 5]
                                                                                      : kPlainCells[cell % 5]);
        }
    }
    OpacityShape shape;
    shape.shape = "trapezoid";
    shape.x = rampsAlong(first);
    shape.y = rampsAlong(second);
    shape.opacity = 0.4;
    transfer.opacity2d = {shape};
    layer.transfer = transfer;
}

namespace {

using Features = std::vector<TransferFeature>;

Layer& only(Figure& figure) { return figure.layers.front(); }

void addAxes(Features& features) {
    const auto add = [&](const std::string& name, bool toLabel, auto make) {
        for (const auto& [suffix, shading] : {std::pair("Flat", Shading::flat), std::pair("Style", Shading::style)}) {
            features.push_back({name + suffix, [=, shading = shading](Figure& figure) {
                                    only(figure).shading = shading;
                                    setDistance(only(figure), toLabel);
                                    make(only(figure));
                                }});
        }
    };
    for (const char* axis : {"gradient", "label", "distance", "curvature", "second"}) {
        const std::string name = axis;
        const std::string upper = std::string(1, static_cast<char>(std::toupper(name[0]))) + name.substr(1);
        add("line" + upper, true, [name](Layer& layer) { makeLine(layer, name); });
        add("plane" + upper, true, [name](Layer& layer) { makePlane(layer, "value", name); });
    }
    const auto weighed = [&](const std::string& name, auto make) {
        features.push_back({name, [make](Figure& figure) {
                                only(figure).shading = Shading::style;
                                ImportanceWeights& weights = figure.importance.emplace().weights;
                                weights.intensity = 0.3;
                                weights.gradient = 0.2;
                                weights.lighting = 0.2;
                                weights.object = 0.5;
                                weights.statistics = 0.3;
                                figure.importance->objects = {{3, 0.4}};
                                figure.importance->global = 0; // composes the ordinary way
                                make(only(figure));
                            }});
    };
    weighed("lineImportance", [](Layer& layer) { makeLine(layer, "importance"); });
    weighed("planeImportance", [](Layer& layer) { makePlane(layer, "value", "importance"); });
    add("planeDistanceFromPoint", false, [](Layer& layer) { makePlane(layer, "value", "distance"); });
    add("lineDistanceFromPoint", false, [](Layer& layer) { makeLine(layer, "distance"); });
    add("planeSwapped", true, [](Layer& layer) { makePlane(layer, "second", "value"); });
    add("planeLabelFirst", true, [](Layer& layer) { makePlane(layer, "label", "gradient"); });
    add("planeWithoutValue", true, [](Layer& layer) { makePlane(layer, "gradient", "distance"); });
    add("planeLabelDistance", true, [](Layer& layer) { makePlane(layer, "distance", "label"); });
    // Steps are left out: tables give them the width of an entry, so that single samples near one differ.
    for (const char* axis : {"value", "gradient"})
        features.push_back({std::string("lineSmooth") + (*axis == 'v' ? "Value" : "Gradient"),
                            [axis](Figure& figure) {
                                only(figure).shading = Shading::flat;
                                makeLine(only(figure), axis);
                                only(figure).transfer.curve = OpacityCurve::smooth;
                            },
                            false});
}

void addShapes(Features& features) {
    const auto add = [&](const std::string& name, const OpacityShape& shape) {
        features.push_back({name,
                            [shape](Figure& figure) {
                                makePlane(only(figure), "value", "gradient");
                                only(figure).transfer.opacity2d = {shape};
                            },
                            false});
    };
    OpacityShape shape;
    shape.opacity = 0.4;
    shape.soft = 0.6;
    shape.shape = "rectangle";
    shape.x = {0.2, 0.95};
    shape.y = {0.1, 0.8};
    add("rectangle", shape);
    shape.shape = "ellipse";
    add("ellipse", shape);
    shape.shape = "mask";
    shape.columns = 4;
    shape.values = {0, 0, 0, 0, 0, 0.8, 1, 0, 0, 0.7, 0.6, 0, 0, 0, 0, 0};
    add("mask", shape);
    shape.shape = "polygon";
    shape.x = {0.15, 0.9, 1.0, 0.4};
    shape.y = {0.05, 0.2, 0.9, 0.7};
    add("polygon", shape);
}

void addLooks(Features& features) {
    struct Kind {
        const char* name;
        bool controlled;
        CurvatureEstimator curvature;
    };
    for (const Kind& kind :
         {Kind{"Hessian", true, CurvatureEstimator::hessian}, Kind{"Normals", true, CurvatureEstimator::normals},
          Kind{"Fixed", false, CurvatureEstimator::hessian}}) {
        for (const auto& [suffix, shading] : {std::pair("Flat", Shading::flat), std::pair("Phong", Shading::phong),
                                              std::pair("Style", Shading::style)}) {
            features.push_back({std::string("contours") + kind.name + suffix, [=, shading = shading](Figure& figure) {
                                    only(figure).shading = shading;
                                    makeLine(only(figure), "value");
                                    only(figure).contours = Contours{1.2, kind.controlled, kind.curvature, 1.3};
                                }});
        }
    }
    for (const bool contours : {false, true}) {
        features.push_back({contours ? "illustrativeContours" : "illustrative", [contours](Figure& figure) {
                                only(figure).shading = Shading::style;
                                makeLine(only(figure), "value");
                                only(figure).transfer.nodes.back().style = "c";
                                only(figure).transparency = Transparency::illustrative;
                                if (contours) {
                                    only(figure).contours.emplace();
                                }
                            }});
    }
    features.push_back({"illustrativePlane", [](Figure& figure) {
                            only(figure).shading = Shading::phong;
                            makePlane(only(figure), "value", "gradient");
                            only(figure).transparency = Transparency::illustrative;
                        }});
}

void addLabelsAndEstimators(Features& features) {
    features.push_back({"shownLabels", [](Figure& figure) { only(figure).labels = {0, 7}; }});
    features.push_back({"labelsOfAnotherGrid", [](Figure& figure) {
                            moveLabelsToAnotherGrid(figure);
                            makePlane(only(figure), "value", "label");
                            only(figure).labels = {3, 7};
                        }});
    const std::pair<const char*, GradientEstimator> estimators[] = {{"central", GradientEstimator::central},
                                                                    {"sobel", GradientEstimator::sobel},
                                                                    {"neumann", GradientEstimator::neumann},
                                                                    {"fourthOrder", GradientEstimator::fourthOrder},
                                                                    {"bspline", GradientEstimator::bspline}};
    const std::pair<const char*, Interpolation> interpolations[] = {
        {"Linear", Interpolation::linear}, {"Tricubic", Interpolation::tricubic}, {"Smooth", Interpolation::smooth}};
    for (const auto& [gradientName, gradient] : estimators) {
        for (const auto& [name, interpolation] : interpolations) {
            features.push_back({std::string(gradientName) + name,
                                [gradient = gradient, interpolation = interpolation](Figure& figure) {
                                    figure.quality.gradient = gradient;
                                    figure.quality.interpolation = interpolation;
                                    only(figure).shading = Shading::style;
                                    makeLine(only(figure), "value");
                                    only(figure).contours.emplace();
                                }});
        }
    }
}

/// By importance, backends may end rays at different depths: each within this of its own picture.
constexpr double kEndsLate = 1e-5;

/// Matter that lets all that is behind it through to some part, in a style that shows normals.
void makeVeiled(Figure& figure) {
    figure.quality.earlyTermination = kEndsLate;
    only(figure).shading = Shading::style;
    makeLine(only(figure), "value");
    figure.importance.emplace();
    figure.importance->global = 2;
}

Lens lensOf(const std::string& kind, const std::string& shape) {
    Lens lens;
    lens.kind = kind;
    lens.shape = shape;
    lens.center = {0.42, 0.55};
    lens.radius = 0.3;
    lens.cell = 1.0 / 36;
    return lens;
}

void addImportance(Features& features) {
    const auto add = [&](const std::string& name, auto change) {
        features.push_back({"importance" + name, [change](Figure& figure) {
                                makeVeiled(figure);
                                change(*figure.importance);
                            }});
    };
    add("Intensity", [](Importance& i) { i.weights.intensity = 3; });
    add("Extinction", [](Importance& i) { i.weights.extinction = 2; });
    add("Gradient", [](Importance& i) { i.weights.gradient = 2; });
    add("Silhouette", [](Importance& i) { i.weights.silhouette = 3; });
    add("Unocclusion", [](Importance& i) {
        i.weights.unocclusion = 0.1;
        i.weights.intensity = 1;
    });
    add("Lighting", [](Importance& i) { i.weights.lighting = 1; });
    add("Object", [](Importance& i) {
        i.weights.object = 1;
        i.objects = {{3, 1.5}, {7, 0.7}};
    });
    add("Statistics", [](Importance& i) { i.weights.statistics = 4; });
    const auto several = [](Importance& i) {
        i.weights.intensity = 1;
        i.weights.extinction = 0.5;
        i.weights.gradient = 1;
        i.weights.silhouette = 1;
    };
    add("Background", [several](Importance& i) {
        several(i);
        i.background = 1.2;
    });
    add("WithoutFloor", [several](Importance& i) {
        several(i);
        i.noiseFloor = 0;
        i.cap = 20;
    });
    for (const auto& [kind, shape] :
         {std::pair("circular", "circle"), std::pair("gaussian", "ellipse"), std::pair("screendoor", "box")}) {
        add(std::string("Lens") + kind, [several, kind = kind, shape = shape](Importance& i) {
            several(i);
            i.lenses = {lensOf(kind, shape)};
            i.lenses.front().aspect = 1.4;
            i.lenses.front().angleDeg = 25;
        });
    }
}

} // namespace

const std::vector<TransferFeature>& transferFeatures() {
    static const Features features = [] {
        Features all;
        addAxes(all);
        addShapes(all);
        addLooks(all);
        addLabelsAndEstimators(all);
        addSlabFeatures(all);
        addImportance(all);
        addPartFeatures(all);
        return all;
    }();
    return features;
}

namespace {

glm::dmat3 anyRotation(Dice& dice) {
    const glm::dvec3 x = glm::normalize(glm::dvec3(dice.between(0.2, 1), dice.between(-1, 1), dice.between(-1, 1)));
    const glm::dvec3 y = glm::normalize(glm::cross(x, glm::dvec3(0.2, -0.5, 1)));
    const glm::dvec3 z = glm::cross(x, y);
    return {x, y, dice.oneIn(3) ? -z : z}; // left-handed grids too
}

std::vector<double> risingCorners(Dice& dice, const std::string& axis, int count) {
    const ValueRange range = axis == "label" ? ValueRange{-2, 9} : usualRange(axis);
    const double width = range.high - range.low;
    std::vector<double> corners;
    for (int k = 0; k < count; ++k) {
        const double step = width / count;
        corners.push_back(range.low - 0.1 * width + step * (k + dice.between(0.1, 0.9)) * 1.3);
    }
    return corners;
}

void anyTransfer(Dice& dice, Layer& layer) {
    setDistance(layer, dice.oneIn(2));
    const char* const axes[] = {"gradient", "label", "distance", "curvature", "second"};
    if (dice.oneIn(2)) {
        makeLine(layer, dice.oneIn(2) ? "value" : axes[dice.below(5)]);
    } else {
        std::string first = dice.oneIn(3) ? axes[dice.below(5)] : "value";
        std::string second = axes[dice.below(5)];
        if (first == second) {
            second = "value";
        }
        makePlane(layer, first, second);
        if (dice.oneIn(3) && first != "label") {
            const ValueRange range = usualRange(first);
            layer.transfer.opacity = {{range.low, 0.2}, {range.high, 1}};
        }
    }
}

Layer anyLayer(Dice& dice) {
    Layer layer;
    layer.shading = dice.any({Shading::style, Shading::phong, Shading::flat});
    layer.twoSided = !dice.oneIn(4);
    anyTransfer(dice, layer);
    if (dice.oneIn(3)) {
        layer.opacity = dice.between(0.3, 1);
    }
    if (dice.oneIn(2)) {
        layer.contours =
            Contours{dice.between(0.3, 1.5), !dice.oneIn(3),
                     dice.any({CurvatureEstimator::hessian, CurvatureEstimator::normals}), dice.between(0.7, 2)};
    }
    if (dice.oneIn(3)) {
        layer.transparency = Transparency::illustrative;
        if (!layer.transfer.nodes.empty() && layer.shading == Shading::style) {
            layer.transfer.nodes.back().style = "c";
        }
    }
    if (dice.oneIn(4)) {
        layer.labels = dice.oneIn(2) ? std::vector<int>{3, 7} : std::vector<int>{0, 3};
    }
    if (layer.shading == Shading::phong && dice.oneIn(2)) {
        layer.specular = Specular{dice.between(0.1, 0.6), dice.any({1.0, 7.5, 20.0})};
    }
    return layer;
}

void anyImportance(Dice& dice, Importance& importance) {
    importance.global = dice.between(0.5, 4);
    importance.objects = {{3, dice.unit()}, {7, 1}};
    double* const weights[] = {&importance.weights.intensity,   &importance.weights.extinction,
                               &importance.weights.gradient,    &importance.weights.silhouette,
                               &importance.weights.unocclusion, &importance.weights.lighting,
                               &importance.weights.object,      &importance.weights.statistics};
    for (double* weight : weights) {
        *weight = dice.oneIn(3) ? dice.between(0.2, 1.5) : 0;
    }
    importance.background = dice.oneIn(3) ? dice.between(0, 3) : 0;
    if (dice.oneIn(2)) {
        importance.lenses.push_back(
            lensOf(dice.any({"circular", "gaussian", "screendoor"}), dice.any({"circle", "ellipse", "box"})));
    }
}

void anyClip(Dice& dice, Clip& clip) {
    if (dice.oneIn(3)) {
        clip.planes.push_back({{dice.between(-1, 1), dice.between(-1, 1), 0.5}, dice.between(-2, 4)});
    }
    if (dice.oneIn(5)) {
        clip.boxMm = BoxMm{{-dice.between(3, 12), -9, -11}, {10, dice.between(2, 12), 9}};
    }
}

} // namespace

OpacityShape randomShape(unsigned seed, const std::string& first, const std::string& second) {
    Dice dice(seed);
    OpacityShape shape;
    shape.shape = dice.any<const char*>({"rectangle", "trapezoid", "ellipse", "polygon", "mask"});
    shape.opacity = dice.between(0.1, 0.6);
    shape.soft = dice.between(0.4, 1);
    const int corners = shape.shape == "trapezoid" ? 4 : shape.shape == "polygon" ? 5 : 2;
    shape.x = risingCorners(dice, first, corners);
    shape.y = risingCorners(dice, second, corners);
    if (shape.shape == "polygon") {
        std::swap(shape.y[1], shape.y[3]);
    }
    if (shape.shape == "mask") {
        shape.columns = 5;
        for (int k = 0; k < 20; ++k) {
            const bool border = k % 5 == 0 || k % 5 == 4 || k < 5 || k >= 15; // nothing jumps at the box
            shape.values.push_back(border ? 0 : dice.unit());
        }
    }
    return shape;
}

Figure randomFigure(unsigned seed) {
    Dice dice(seed);
    SmoothScene scene;
    scene.type = dice.any({VoxelType::uint8, VoxelType::int16, VoxelType::float32});
    scene.projection = dice.any({Projection::orthographic, Projection::perspective});
    scene.dims = {24 + dice.below(17), 24 + dice.below(17), 24 + dice.below(17)};
    scene.falling = scene.type == VoxelType::int16 && dice.oneIn(3);
    Figure figure = smoothFigure(scene);
    Grid grid = obliqueGrid(scene.dims);
    grid.spacingMm = {dice.between(0.7, 1.2), dice.between(0.7, 1.2), dice.between(0.7, 1.2)};
    grid.direction = anyRotation(dice);
    grid.originMm = -grid.direction * (grid.spacingMm * (glm::dvec3(grid.dims - 1) / 2.0));
    figure.volume->data = asType(grid, scene.type, scene.falling);
    figure.labels->data = labelsOn(grid);
    if (dice.oneIn(2)) {
        moveLabelsToAnotherGrid(figure);
    }
    figure.camera.direction = {dice.between(-1, 1), dice.between(-1, 1), dice.between(-0.6, 0.6)};
    figure.camera.fovDeg = dice.between(10, 60);
    figure.quality.stepVoxels = dice.between(0.3, 1.2);
    figure.quality.gradient =
        dice.any({GradientEstimator::automatic, GradientEstimator::central, GradientEstimator::sobel,
                  GradientEstimator::neumann, GradientEstimator::fourthOrder, GradientEstimator::bspline});
    figure.quality.interpolation =
        dice.any({Interpolation::automatic, Interpolation::linear, Interpolation::tricubic, Interpolation::smooth});
    anyClip(dice, figure.clip);
    figure.layers.clear();
    for (int k = 0; k < 1 + static_cast<int>(seed % 3); ++k) {
        figure.layers.push_back(anyLayer(dice));
    }
    if (seed % 4 == 3) {
        figure.quality.earlyTermination = kEndsLate;
        anyImportance(dice, figure.importance.emplace());
    }
    return figure;
}

} // namespace limner::testing
