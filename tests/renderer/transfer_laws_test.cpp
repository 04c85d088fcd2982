#include "support/make_volume.h"
#include "support/rendering.h"
#include "support/transfer_scenes.h"

#include <cmath>

// Laws of transfer functions, contours and transparency (spec style-transfer-functions.md 3 to 6), on every backend.

namespace limner {
namespace {

using testing::BackendTest;
using testing::planOf;
using testing::renderWhole;

class TransferLaws : public BackendTest {
  protected:
    [[nodiscard]] Picture draw(const Figure& figure) const {
        PlanRequest request;
        request.size = {40, 40};
        return renderWhole(backend(), *planOf(figure, request));
    }
    /// The smooth scene, with value positions that lie on entries of every table.
    static Figure figureOf(Shading shading) {
        testing::SmoothScene scene;
        scene.type = VoxelType::uint8;
        Figure figure = testing::smoothFigure(scene);
        Layer& layer = figure.layers.front();
        layer.shading = shading;
        testing::makeLine(layer, "value");
        const Volume& volume = *figure.volume->data;
        layer.transfer.nodes[0].at = layer.transfer.opacity[0].x = volume.valueFromStored(40);
        layer.transfer.nodes[1].at = layer.transfer.opacity[1].x = volume.valueFromStored(120);
        layer.transfer.nodes[2].at = layer.transfer.opacity[2].x = volume.valueFromStored(220);
        return figure;
    }
};
LIMNER_ON_EVERY_BACKEND(TransferLaws);

TEST_P(TransferLaws, ContoursOfNoThicknessAreNone) {
    for (const Shading shading : {Shading::flat, Shading::phong, Shading::style}) {
        Figure figure = figureOf(shading);
        const Picture without = draw(figure);
        for (const bool controlled : {false, true}) {
            figure.layers[0].contours = Contours{0, controlled, CurvatureEstimator::normals, 1};
            EXPECT_TRUE(testing::sameBits(without, draw(figure)));
        }
    }
}

TEST_P(TransferLaws, AnOpaqueFunctionLeavesTheStylesOwnOpacity) {
    // a_u = 1 gives a_d, whatever the normal, the contour and the gradient are.
    Figure figure = figureOf(Shading::style);
    StyleEntry half;
    half.id = "half";
    half.sphere = std::make_shared<const LitSphere>(32, std::vector<Rgba>(32 * 32, Rgba{0.2F, 0.4F, 0.6F, 0.5F}));
    figure.styles = {half};
    figure.quality.earlyTermination = 0;
    Layer& layer = figure.layers[0];
    layer.transfer.nodes = {{0, "half", std::nullopt}};
    layer.transfer.opacity = {{0, 1}};
    layer.transparency = Transparency::illustrative;
    layer.contours.emplace();
    const Picture illustrative = draw(figure);
    layer.transparency = Transparency::uniform;
    EXPECT_LT(testing::largestDifference(illustrative, draw(figure)), rounding(1e-7, 2e-5));
    EXPECT_GT(illustrative.pixel(20, 20)[3], 0.99);
    layer.transparency = Transparency::illustrative;
    layer.transfer.opacity = {{0, 0}};
    EXPECT_EQ(draw(figure).pixel(20, 20)[3], 0);
}

TEST_P(TransferLaws, AValueOnAJumpHasTheColourBehindIt) {
    constexpr int kJump = 120;
    Figure figure = figureOf(Shading::style);
    figure.volume->data = testing::makeVolume<std::uint8_t>(
        figure.volume->data->grid(), VoxelType::uint8, [](glm::ivec3 v) { return v == glm::ivec3(0) ? 0 : kJump; });
    const Rgba behind{0.1F, 0.2F, 0.8F, 1};
    for (const auto& [id, colour] : {std::pair("before", Rgba{0.9F, 0.1F, 0.1F, 1}), {"behind", behind}}) {
        StyleEntry entry;
        entry.id = id;
        entry.sphere = std::make_shared<const LitSphere>(8, std::vector<Rgba>(64, colour));
        figure.styles.push_back(entry);
    }
    Layer& layer = figure.layers[0];
    layer.transfer.opacity = {{0, 1}, {kJump, 1}};
    for (const int more : {0, 14}) { // of the nodes; more than a kernel keeps at hand are in a table
        layer.transfer.nodes = {{0, "before", {}}, {kJump, "before", {}}, {kJump, "behind", {}}};
        for (int i = 1; i <= more; ++i)
            layer.transfer.nodes.push_back({static_cast<double>(kJump + i), "behind", {}});
        const Picture picture = draw(figure);
        EXPECT_NEAR(picture.pixel(20, 20)[0], behind.r, 1e-3) << more;
        EXPECT_NEAR(picture.pixel(20, 20)[2], behind.b, 1e-3) << more;
    }
}

TEST_P(TransferLaws, ValuesBesideAGapAreDrawnAndThoseInItAreNot) {
    Figure figure = figureOf(Shading::flat);
    const Grid grid = figure.volume->data->grid();
    figure.layers[0].transfer.opacity = {{0, 0.5}, {1000, 0.5}, {1000, 0}, {3000, 0}, {3000, 0.5}, {4095, 0.5}};
    for (const bool slabs : {false, true}) {
        figure.quality.preintegration = slabs;
        for (const auto& [value, shows] : {std::pair(999, true), {1000, false}, {2999, false}, {3000, true}}) {
            figure.volume->data = testing::makeVolume<std::int16_t>(
                grid, VoxelType::int16, [&, here = value](glm::ivec3 v) { // an entry for every number
                    return v == glm::ivec3(0) ? 0 : v == grid.dims - 1 ? 4095 : here;
                });
            const float alpha = draw(figure).pixel(20, 20)[3];
            EXPECT_EQ(alpha > 0.3F, shows) << value << ' ' << slabs << ' ' << alpha;
            EXPECT_EQ(alpha == 0, !shows) << value << ' ' << slabs << ' ' << alpha;
        }
    }
}

TEST_P(TransferLaws, LessOpacityClearsFlatRegionsBeforeContours) {
    Figure figure = figureOf(Shading::style);
    Layer& layer = figure.layers[0];
    layer.contours = Contours{1, false, CurvatureEstimator::hessian, 1};
    for (glm::dvec2& point : layer.transfer.opacity) {
        point.y = point.y > 0 ? 0.05 : 0;
    }
    const Picture uniform = draw(figure);
    layer.transparency = Transparency::illustrative;
    const Picture illustrative = draw(figure);
    // In the middle matter is seen head-on (exponent up to 3/2), at the rim along the surface (exponent 1/2).
    EXPECT_LT(illustrative.pixel(20, 20)[3] / uniform.pixel(20, 20)[3],
              illustrative.pixel(20, 9)[3] / uniform.pixel(20, 9)[3]);
}

TEST_P(TransferLaws, APlaneThatIsTheSameAlongYIsALine) {
    for (const Shading shading : {Shading::flat, Shading::phong, Shading::style}) {
        for (const char* second : {"gradient", "label", "distance", "curvature", "second"}) {
            Figure figure = figureOf(shading);
            Layer& layer = figure.layers[0];
            const Picture line = draw(figure);
            const Transfer one = layer.transfer;
            layer.transfer.distance.emplace();
            layer.transfer.distance->label = 3;
            testing::makePlane(layer, "value", second);
            layer.transfer.opacity2d.clear();
            layer.transfer.opacity = one.opacity;
            layer.transfer.grid->x.clear();
            for (const TransferNode& node : one.nodes) {
                layer.transfer.grid->x.push_back(node.at);
            }
            const bool style = shading == Shading::style;
            layer.transfer.grid->styles.assign(3, {style ? "a" : "#e63319", "#3399e6", style ? "b" : "#cccc33"});
            // "#3399e6" is (0.2, 0.6, 0.9) to half a step of 255.
            EXPECT_LT(testing::largestDifference(line, draw(figure)), 0.004) << second;
            EXPECT_LT(testing::rootMeanSquare(line, draw(figure)), 0.0012) << second;
        }
    }
}

TEST_P(TransferLaws, AListOfAllLabelsIsNone) {
    for (const char* axis : {"value", "gradient"}) {
        Figure figure = figureOf(Shading::style);
        if (std::string(axis) != "value") {
            testing::makeLine(figure.layers[0], axis);
        }
        const Picture all = draw(figure);
        figure.layers[0].labels = {0, 3, 7};
        EXPECT_LT(testing::largestDifference(all, draw(figure)), rounding(1e-6, 2e-5)) << axis;
        figure.layers[0].labels = {3};
        EXPECT_GT(testing::largestDifference(all, draw(figure)), 0.05) << axis;
        figure.layers[0].labels->clear();
        EXPECT_EQ(draw(figure).pixel(20, 20)[3], 0) << axis;
    }
}

TEST_P(TransferLaws, LabelsWithoutAPlaceOfTheirOwnAreInvisible) {
    Figure figure = figureOf(Shading::flat);
    Layer& layer = figure.layers[0];
    testing::makeLine(layer, "label");
    layer.transfer.nodes.erase(layer.transfer.nodes.begin()); // that of all others
    layer.transfer.opacity = {{3, 0.2}, {7, 0.3}};
    const Picture named = draw(figure);
    EXPECT_GT(named.pixel(20, 20)[3], 0.5);
    layer.labels = {3, 7};
    EXPECT_LT(testing::largestDifference(named, draw(figure)), rounding(1e-7, 2e-6));
}

TEST_P(TransferLaws, ACurvatureAxisDoesNotMindTheContoursEstimator) {
    Figure figure = figureOf(Shading::flat);
    testing::makePlane(figure.layers[0], "value", "curvature");
    const Picture without = draw(figure);
    EXPECT_GT(without.pixel(20, 20)[3], 0.2);
    // So thin that they leave no ink.
    figure.layers[0].contours = Contours{1e-12, true, CurvatureEstimator::normals, 1};
    EXPECT_LT(testing::largestDifference(without, draw(figure)), rounding(1e-6, 1e-5));
}

TEST_P(TransferLaws, EveryLayerMeasuresCurvatureOverItsOwnDistance) {
    Figure figure = figureOf(Shading::flat);
    figure.layers[0].contours = Contours{1, true, CurvatureEstimator::normals, 0.7};
    const Picture alone = draw(figure);
    Layer faint = figure.layers[0];
    faint.opacity = 1e-6;
    for (const CurvatureEstimator estimator : {CurvatureEstimator::normals, CurvatureEstimator::hessian}) {
        faint.contours = Contours{1, true, estimator, 4};
        figure.layers.resize(1);
        figure.layers.push_back(faint);
        EXPECT_LT(testing::largestDifference(alone, draw(figure)), 1e-4);
    }
}

TEST_P(TransferLaws, CurvatureIsGatedWhateverTheShading) {
    // Below the gradient floor there is no curvature: Phong's normal alone asks for no floor, its curvature axis does.
    Figure figure = figureOf(Shading::phong);
    testing::makePlane(figure.layers[0], "value", "curvature");
    PlanRequest request;
    request.size = {8, 8};
    figure.layers[0].shading = Shading::flat;
    const double floor = planOf(figure, request)->gradientFloor;
    EXPECT_GT(floor, 0);
    figure.layers[0].shading = Shading::phong;
    EXPECT_EQ(planOf(figure, request)->gradientFloor, floor);
}

} // namespace
} // namespace limner
