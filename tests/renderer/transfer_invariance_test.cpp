#include "renderer/cpu/kernel.h"
#include "support/rendering.h"
#include "support/transfer_scenes.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <vector>

// What must not change the SIMD backend's picture: the instruction set, tiles, threads, and leaving out what shows
// nothing.

namespace limner {
namespace {

using testing::renderWhole;

/// Every feature alone, then random figures.
constexpr std::size_t kRandom = 24;

Figure figureOf(std::size_t which) {
    const auto& features = testing::transferFeatures();
    if (which >= features.size()) {
        return testing::randomFigure(static_cast<unsigned>(1000 + which - features.size()));
    }
    testing::SmoothScene scene;
    constexpr VoxelType types[] = {VoxelType::uint8, VoxelType::int16, VoxelType::float32};
    scene.type = types[which % 3];
    scene.projection = which % 2 == 0 ? Projection::perspective : Projection::orthographic;
    Figure figure = testing::smoothFigure(scene);
    features[which].apply(figure);
    return figure;
}

std::string nameOf(std::size_t which) {
    const auto& features = testing::transferFeatures();
    return which < features.size() ? features[which].name : "random" + std::to_string(which - features.size());
}

class TransferInvariance : public ::testing::TestWithParam<std::size_t> {
  protected:
    [[nodiscard]] std::shared_ptr<const RenderPlan> plan(const KeptIn& kept = {}) const {
        PlanRequest request;
        request.size = {71, 67}; // cuts blocks of rays on both sides
        request.kept = kept;
        return testing::planOf(figureOf(GetParam()), request);
    }
    std::unique_ptr<Backend> backend_ = makeCpuBackend();
};

INSTANTIATE_TEST_SUITE_P(Of, TransferInvariance,
                         ::testing::Range(std::size_t{0}, testing::transferFeatures().size() + kRandom),
                         [](const auto& one) { return nameOf(one.param); });

TEST_P(TransferInvariance, UnderInstructionSets) {
    const auto drawn = plan();
    const Picture best = renderWhole(*backend_, *drawn);
    for (const std::string& target : kernelTargets()) {
        restrictKernelTarget(target);
        const Picture picture = renderWhole(*backend_, *drawn);
        std::vector<double> all;
        for (std::size_t i = 0; i < best.rgba().size(); ++i) {
            all.push_back(std::abs(static_cast<double>(picture.rgba()[i]) - best.rgba()[i]));
        }
        std::sort(all.begin(), all.end());
        // Rounding alone; but a normal across the view is turned to the viewer by one and away by the other, and the
        // last tenth of a contour is steep.
        EXPECT_LT(all[all.size() * 999 / 1000], 2e-5) << target;
        EXPECT_LT(all.back(), 5e-3) << target;
        EXPECT_LT(testing::rootMeanSquare(picture, best), 2e-5) << target;
    }
    restrictKernelTarget("");
}

TEST_P(TransferInvariance, UnderTilesAndThreads) {
    const auto drawn = plan();
    const Picture whole = renderWhole(*backend_, *drawn);
    EXPECT_EQ(testing::unsoundPixels(whole), 0);
    EXPECT_TRUE(testing::sameBits(whole, testing::renderTiles(*backend_, *drawn, {7, 5})));
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_TRUE(testing::sameBits(whole, renderWhole(*backend_, *drawn)));
}

TEST_P(TransferInvariance, UnderLeavingOut) {
    const Picture lean = renderWhole(*backend_, *plan());
    EXPECT_TRUE(testing::sameBits(lean, renderWhole(*backend_, *plan(KeptIn::allOf(LeaveOutEquality::sameBits)))));
    // With all rules off rays end nowhere, and some sums are taken in another form.
    const double early = plan()->earlyTermination;
    EXPECT_LE(testing::largestDifference(lean, renderWhole(*backend_, *plan(KeptIn::everything()))), early + 1e-5);
}

/// A figure's picture with and without a layer that cannot be seen.
void expectUnseen(Figure figure, const Layer& unseen, bool first) {
    PlanRequest request;
    request.size = {48, 48};
    const auto backend = makeCpuBackend();
    const auto plan = testing::planOf(figure, request);
    const Picture alone = renderWhole(*backend, *plan);
    figure.layers.insert(first ? figure.layers.begin() : figure.layers.end(), unseen);
    EXPECT_TRUE(testing::sameBits(alone, renderWhole(*backend, *testing::planOf(figure, request))));
    // Kept in, it makes a figure of one layer one of two, which are summed in another order: rays then end a sample
    // sooner or later, at a transmittance of 0.001.
    request.kept = {LeaveOut::layers};
    const auto keptPlan = testing::planOf(figure, request);
    if (plan->preintegrated != keptPlan->preintegrated) {
        return; // the layer cannot be pre-integrated: kept in, it makes a figure that is not
    }
    const Picture kept = renderWhole(*backend, *keptPlan);
    EXPECT_LT(testing::rootMeanSquare(alone, kept), 1e-5);
    EXPECT_LT(testing::largestDifference(alone, kept), 5e-4);
}

TEST_P(TransferInvariance, UnderLayersThatCannotBeSeen) {
    const Figure figure = figureOf(GetParam());
    Layer unseen = figure.layers.front();
    unseen.contours.emplace();
    unseen.transparency = Transparency::illustrative;
    unseen.opacity = 0;
    expectUnseen(figure, unseen, true);
    unseen.opacity = 1;
    unseen.visible = false;
    expectUnseen(figure, unseen, false);
}

} // namespace
} // namespace limner
