#include "renderer/plan/slab_table.h"

#include "core/optics/preintegration.h"
#include "renderer/accuracy/analytic_scenes.h"
#include "support/rendering.h"
#include "support/transfer_scenes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace limner {
namespace {

double sumOf(const std::vector<float>& rows, std::size_t entry, SlabColumn column) {
    const float* row = rows.data() + entry * kSlabFloats + static_cast<std::size_t>(column);
    return static_cast<double>(row[0]) + static_cast<double>(row[1]);
}

TEST(SlabTable, HoldsTheIntegralsOfItsOwnExtinction) {
    std::vector<float> opacity;
    for (int k = 0; k < 300; ++k) {
        opacity.push_back(0.5F + 0.4F * std::sin(0.05F * static_cast<float>(k)));
    }
    const std::vector<float> rows = slabTable(opacity);
    const auto bound = [&](SlabColumn column) { // 2^-47, half a quantum in single precision
        return 1e-14 * sumOf(rows, opacity.size() - 1, column);
    };
    double depth = 0;
    double first = 0;
    double second = 0;
    for (std::size_t k = 0; k < opacity.size(); ++k) {
        ASSERT_NEAR(sumOf(rows, k, SlabColumn::depth), depth, bound(SlabColumn::depth));
        ASSERT_NEAR(sumOf(rows, k, SlabColumn::first), first, bound(SlabColumn::first));
        ASSERT_NEAR(sumOf(rows, k, SlabColumn::second), second, bound(SlabColumn::second));
        if (k + 1 == opacity.size()) {
            break;
        }
        const double low = -std::log1p(-static_cast<double>(opacity[k]));
        const double high = -std::log1p(-static_cast<double>(opacity[k + 1]));
        for (const auto& [x, weight] : {std::pair(0.0, 1.0 / 6), std::pair(0.5, 4.0 / 6), std::pair(1.0, 1.0 / 6)}) {
            const double own = weight * (low + (high - low) * x); // Simpson's rule: exact up to cubics
            const double at = static_cast<double>(k) + x;
            depth += own;
            first += own * at;
            second += own * at * at;
        }
    }
}

TEST(SlabTable, KeepsFaintMatterBesideOpaque) {
    // Opaque below, faint above: single sums in single precision would lose all of it.
    std::vector<float> opacity(16384, 1e-5F);
    std::fill(opacity.begin(), opacity.begin() + 12000, 1.0F);
    const std::vector<float> rows = slabTable(opacity);
    const auto difference = [&](std::size_t front, std::size_t back) { // as the kernels take it
        const float* a = rows.data() + front * kSlabFloats + static_cast<std::size_t>(SlabColumn::depth);
        const float* b = rows.data() + back * kSlabFloats + static_cast<std::size_t>(SlabColumn::depth);
        return (b[0] - a[0]) + (b[1] - a[1]);
    };
    EXPECT_NEAR(difference(14000, 14001), 1e-5, 2e-7);
    EXPECT_NEAR(difference(14000, 14100), 1e-3, 1e-6);
    EXPECT_NEAR(difference(100, 110), 10 * optics::kOpaqueExtinction, 1e-4);
}

TEST(SlabTable, ARampUpToOpacityOneKeepsItsLogarithm) {
    std::vector<float> opacity;
    for (int k = 0; k <= 1000; ++k) {
        opacity.push_back(static_cast<float>(k) / 1000);
    }
    // Integral of -ln(1 - a) over [0, 1] is 1.
    EXPECT_NEAR(sumOf(slabTable(opacity), 1000, SlabColumn::depth), 1000, 0.1);
}

std::shared_ptr<const RenderPlan> planWith(const std::function<void(Figure&)>& change) {
    Figure figure = testing::smoothFigure({});
    figure.layers.front().shading = Shading::flat;
    testing::makeLine(figure.layers.front(), "value");
    figure.quality.preintegration = true;
    change(figure);
    PlanRequest request;
    request.size = {8, 8};
    return testing::planOf(figure, request);
}

std::string leftOutFor(const RenderPlan& plan) {
    for (const PlanFeature& feature : plan.featuresNotAsked) {
        if (feature.name == "pre-integration") {
            return feature.reason;
        }
    }
    return "";
}

TEST(PlanSlabs, SaysWhyNot) {
    const auto on = planWith([](Figure&) {});
    EXPECT_TRUE(on->preintegrated);
    EXPECT_FALSE(on->layers.front().slabs.empty());
    EXPECT_EQ(leftOutFor(*on), "");
    const auto off = planWith([](Figure& figure) { figure.quality.preintegration = false; });
    EXPECT_FALSE(off->preintegrated);
    EXPECT_TRUE(off->layers.front().slabs.empty());
    EXPECT_EQ(leftOutFor(*off), "the quality does not ask for it");
    const auto plane = planWith([](Figure& figure) { testing::makePlane(figure.layers.front(), "value", "gradient"); });
    EXPECT_FALSE(plane->preintegrated);
    EXPECT_EQ(leftOutFor(*plane), "a layer's opacity depends on more than the value");
    const auto important = planWith([](Figure& figure) {
        figure.importance.emplace().global = 2;
        figure.importance->weights.intensity = 1;
    });
    EXPECT_FALSE(important->preintegrated);
    EXPECT_EQ(leftOutFor(*important), "importance weighs single samples");
    const auto nothing = planWith([](Figure& figure) { figure.layers.front().visible = false; });
    EXPECT_EQ(leftOutFor(*nothing), "no layer shows");
}

} // namespace
} // namespace limner
