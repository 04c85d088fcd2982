#include "support/rendering.h"
#include "support/transfer_scenes.h"

#include <algorithm>
#include <string>

namespace limner {
namespace {

/// A smooth curve of opacity, so that no table holds it exactly.
Figure curved(int entries) {
    Figure figure = testing::smoothFigure({});
    Layer& layer = figure.layers.front();
    layer.shading = Shading::flat;
    testing::makeLine(layer, "value");
    layer.transfer.curve = OpacityCurve::smooth;
    figure.quality.tableEntries = entries;
    return figure;
}

std::shared_ptr<const RenderPlan> planWith(int entries) {
    PlanRequest request;
    request.size = {24, 24};
    return testing::planOf(curved(entries), request);
}

TEST(TableEntries, ArePlannedAsAsked) {
    EXPECT_EQ(planWith(300)->layers.front().table.opacity.size(), 300U);
    EXPECT_EQ(planWith(300)->layers.front().stepOpacity.size(), 300U);
    EXPECT_GT(planWith(0)->layers.front().table.opacity.size(), 4000U);
    const auto names = [](const std::vector<PlanFeature>& features) {
        return std::any_of(features.begin(), features.end(), [](const PlanFeature& feature) {
            return feature.name == "tables of a chosen size" && !feature.reason.empty();
        });
    };
    EXPECT_TRUE(names(planWith(300)->featuresUsed));
    EXPECT_TRUE(names(planWith(0)->featuresNotAsked));
}

TEST(TableEntries, APicturesErrorFallsWithThem) {
    const Picture exact = testing::renderWhole(*makeReferenceBackend(), *planWith(0));
    const auto error = [&](int entries) {
        return testing::rootMeanSquare(testing::renderWhole(*makeCpuBackend(), *planWith(entries)), exact);
    };
    double before = error(8);
    EXPECT_GT(before, 1e-3);
    for (const int entries : {32, 128}) { // four times as many: a sixteenth, knots between entries apart
        const double now = error(entries);
        EXPECT_LT(now, before / 5) << entries;
        before = now;
    }
    EXPECT_LE(error(0), before);
}

} // namespace
} // namespace limner
