// Mip levels of lit spheres (spec style-transfer-functions.md 7): far or shrunken objects must not sparkle.
#include "core/volume/phantom.h"
#include "renderer/cpu/kernel.h"
#include "support/rendering.h"
#include "support/transfer_scenes.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace limner {
namespace {

using testing::planOf;
using testing::renderWhole;

/// A style of lines eight texels apart.
std::shared_ptr<const LitSphere> hatched() {
    constexpr int size = 128;
    std::vector<Rgba> pixels;
    for (int i = 0; i < size * size; ++i) {
        const int x = i % size;
        const int y = i / size;
        const auto ink = static_cast<float>(0.5 + 0.4 * std::sin(0.8 * x + 0.3 * y));
        pixels.push_back({ink, 0.3F + 0.5F * ink, static_cast<float>(y) / size, 1});
    }
    return std::make_shared<const LitSphere>(size, std::move(pixels));
}

/// The same plan, drawn from the finest pictures alone.
RenderPlan withoutLevels(const RenderPlan& plan) {
    RenderPlan finest = plan;
    finest.mipLevels.reset();
    return finest;
}

// ---- What both backends draw

struct Scene {
    const char* name;
    Projection projection;
    bool contours;
    const char* shape; ///< of the transfer function
};

class MipLevelAgreement : public ::testing::TestWithParam<Scene> {
  protected:
    /// Pixels of two to three voxels; in perspective the target lies before the object.
    [[nodiscard]] static std::shared_ptr<const RenderPlan> plan(VoxelType type) {
        testing::SmoothScene smooth;
        smooth.type = type;
        smooth.projection = GetParam().projection;
        Figure figure = testing::smoothFigure(smooth);
        for (StyleEntry& style : figure.styles) {
            style.sphere = hatched();
        }
        Layer& layer = figure.layers.front();
        layer.shading = Shading::style;
        if (GetParam().shape == std::string("plane")) {
            testing::makePlane(layer, "value", "gradient");
        } else {
            testing::makeLine(layer, "value");
        }
        if (GetParam().contours) {
            layer.contours = Contours{0.8, true, CurvatureEstimator::hessian, 1.3};
        }
        if (smooth.projection == Projection::perspective) {
            figure.camera.targetMm -= 30.0 * glm::normalize(figure.camera.direction);
            figure.camera.fovDeg = 50;
        }
        PlanRequest request;
        request.size = {24, 24};
        return planOf(figure, request);
    }
};

INSTANTIATE_TEST_SUITE_P(Of, MipLevelAgreement,
                         ::testing::Values(Scene{"depth", Projection::perspective, false, "line"},
                                           Scene{"depthOfAPlane", Projection::perspective, false, "plane"},
                                           Scene{"curvature", Projection::orthographic, true, "line"},
                                           Scene{"both", Projection::perspective, true, "plane"}),
                         [](const auto& one) { return std::string(one.param.name); });

TEST_P(MipLevelAgreement, IsOfKernelAndReference) {
    for (const VoxelType type : {VoxelType::uint8, VoxelType::int16, VoxelType::float32}) {
        const auto levelled = plan(type);
        ASSERT_TRUE(levelled->mipLevels);
        const Picture exact = renderWhole(*makeReferenceBackend(), *levelled);
        const Picture fast = renderWhole(*makeCpuBackend(), *levelled);
        EXPECT_LT(testing::rootMeanSquare(fast, exact), 1e-4) << static_cast<int>(type);
        EXPECT_LT(testing::largestDifference(fast, exact), 2e-3) << static_cast<int>(type);
        // The levels are seen: far more than the backends differ.
        const Picture finest = renderWhole(*makeCpuBackend(), withoutLevels(*levelled));
        EXPECT_GT(testing::rootMeanSquare(fast, finest), 1e-3) << static_cast<int>(type);
        RecordProperty("rmse" + std::to_string(static_cast<int>(type)),
                       std::to_string(testing::rootMeanSquare(fast, exact)));
    }
}

TEST_P(MipLevelAgreement, OfTheInstructionSets) {
    const auto levelled = plan(VoxelType::int16);
    const Picture best = renderWhole(*makeCpuBackend(), *levelled);
    for (const std::string& target : kernelTargets()) {
        restrictKernelTarget(target);
        const Picture other = renderWhole(*makeCpuBackend(), *levelled);
        EXPECT_LT(testing::largestDifference(best, other), 1e-4) << target;
    }
    restrictKernelTarget("");
}

// ---- What they are for

/// The head in engraved bone.
Figure engravedHead() {
    static const auto head = makeHeadPhantom(128);
    Figure figure;
    figure.volume.emplace();
    figure.volume->data = head;
    figure.camera.targetMm = head->grid().centreMm();
    figure.camera.direction = {0.35, 0.9, -0.2};
    figure.camera.heightMm = 240;
    StyleEntry entry;
    entry.id = "engraving";
    entry.sphere = findBundledStyle("engraving")->sphere;
    figure.styles = {entry};
    Layer layer;
    layer.shading = Shading::style;
    layer.transfer.nodes = {{200, "engraving", std::nullopt}};
    layer.transfer.opacity = {{200, 0}, {400, 1}};
    figure.layers = {layer};
    return figure;
}

/// Shrunken: a picture of so many pixels. Its contours ask for the curvature.
Figure shrunkenHead() {
    Figure figure = engravedHead();
    figure.layers.front().contours = Contours{};
    return figure;
}

/// Far: six times as far as what the camera looks at.
Figure distantHead() {
    Figure figure = engravedHead();
    figure.camera.projection = Projection::perspective;
    figure.camera.targetMm -= 600.0 * glm::normalize(figure.camera.direction);
    figure.camera.heightMm = 80;
    figure.camera.fovDeg = 36;
    return figure;
}

std::shared_ptr<const RenderPlan> planOf(const Figure& figure, int pixels, int subPixels) {
    PlanRequest request;
    request.size = {pixels, pixels};
    request.subPixels = subPixels;
    return testing::planOf(figure, request);
}

/// The style read at full detail, whatever the pixels.
RenderPlan atFullDetail(const RenderPlan& plan, const Figure& figure) {
    RenderPlan full = withoutLevels(plan);
    full.atlas = packStyles(std::vector{figure.styles.front().sphere}, StyleAtlas::kLargest);
    return full;
}

struct Sparkle {
    double levels; ///< as planned
    double finest; ///< without the levels
    double full;   ///< without any choice of detail
};

/// How far one ray for each pixel is from sixteen at full detail, which is as good as the truth: RMSE of colours.
Sparkle sparkleOf(const Figure& figure, int pixels) {
    const auto backend = makeCpuBackend();
    const auto one = planOf(figure, pixels, 1);
    EXPECT_TRUE(one->mipLevels);
    const Picture truth = renderWhole(*backend, atFullDetail(*planOf(figure, pixels, 4), figure));
    const auto from = [&](const RenderPlan& plan) {
        return testing::rootMeanSquare(renderWhole(*backend, plan), truth);
    };
    return {from(*one), from(withoutLevels(*one)), from(atFullDetail(*one, figure))};
}

// At one level for all samples the shrunken head is 5 and 2 % farther from the truth, at full detail 23 and 12 %.
// What is left is not the style's: where rays meet the bone, and whose normal they find there.
TEST(Sparkle, OfAShrunkenObjectIsSmall) {
    for (const int pixels : {64, 96}) {
        const Sparkle sparkle = sparkleOf(shrunkenHead(), pixels);
        EXPECT_LT(sparkle.levels, 0.052) << pixels;
        EXPECT_LT(sparkle.levels, 0.985 * sparkle.finest) << pixels;
        EXPECT_LT(sparkle.levels, 0.92 * sparkle.full) << pixels;
        RecordProperty("rmse" + std::to_string(pixels), std::to_string(sparkle.levels));
    }
}

TEST(Sparkle, OfADistantObjectIsSmall) {
    for (const int pixels : {64, 96}) {
        const Sparkle sparkle = sparkleOf(distantHead(), pixels);
        EXPECT_LT(sparkle.levels, 0.035) << pixels;
        EXPECT_LT(sparkle.levels, 0.9 * sparkle.finest) << pixels;
        EXPECT_LT(sparkle.levels, 0.9 * sparkle.full) << pixels;
        RecordProperty("rmse" + std::to_string(pixels), std::to_string(sparkle.levels));
    }
}

// ---- When they are left out

TEST(MipLevels, AreLeftOutWhereNoRayIsWiderThanAVoxel) {
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
        Figure figure = shrunkenHead();
        figure.camera.projection = projection;
        figure.camera.heightMm = 120; // 64 voxels: the farthest rays are 0.8 voxels wide
        PlanRequest request;
        request.size = {128, 128};
        const auto lean = testing::planOf(figure, request);
        request.kept = {LeaveOut::mipLevels};
        const auto all = testing::planOf(figure, request);
        EXPECT_FALSE(lean->mipLevels);
        EXPECT_EQ(lean->atlas->levelStart.size(), 1U);
        ASSERT_TRUE(all->mipLevels);
        EXPECT_TRUE(testing::sameBits(renderWhole(*makeCpuBackend(), *lean), renderWhole(*makeCpuBackend(), *all)));
    }
}

TEST(MipLevels, AreLeftOutWhereOneServesAll) {
    Figure figure = engravedHead(); // orthographic, and nothing asks for the curvature
    const auto far = planOf(figure, 48, 1);
    EXPECT_FALSE(far->mipLevels);
    EXPECT_LT(far->atlas->size, planOf(figure, 400, 1)->atlas->size); // the picture's own level
    figure.camera.projection = Projection::perspective;
    EXPECT_TRUE(planOf(figure, 48, 1)->mipLevels);
}

// Curvature that another layer asks for is nothing to a layer of its own look.
TEST(MipLevels, OfALayerDoNotAskAnother) {
    Figure figure = engravedHead();
    const auto alone = planOf(figure, 64, 1);
    Layer hidden = shrunkenHead().layers.front();
    hidden.transfer.opacity = {{1e5, 0}, {2e5, 1}}; // beyond all values
    figure.layers.push_back(hidden);
    PlanRequest request;
    request.size = {64, 64};
    request.subPixels = 1;
    request.kept = {LeaveOut::layers};
    const auto beside = testing::planOf(figure, request);
    ASSERT_TRUE(beside->mipLevels);
    // One layer of two is summed in another order: rays end a sample sooner or later.
    EXPECT_LT(testing::rootMeanSquare(renderWhole(*makeCpuBackend(), *alone), renderWhole(*makeCpuBackend(), *beside)),
              1e-4);
}

} // namespace
} // namespace limner
