#include "renderer/visibility.h"

#include "support/rendering.h"
#include "support/transfer_scenes.h"

#include <cmath>
#include <numeric>

namespace limner {
namespace {

std::shared_ptr<const RenderPlan> planSmall(const Figure& figure) {
    PlanRequest request;
    request.size = {24, 24};
    return testing::planOf(figure, request);
}

VisibilityShares sharesOf(const Figure& figure) {
    Task task;
    return measureVisibility(*planSmall(figure), task);
}

double sumOf(const VisibilityShares& shares) {
    double sum = shares.paper;
    for (const auto& [name, share] : shares.layers) {
        sum += share;
    }
    return sum;
}

/// Two layers over the lumpy ball, labels 3 and 7 in it weighed as objects.
Figure twoLayers(double ofSeven) {
    Figure figure = testing::smoothFigure({});
    testing::makeLine(figure.layers.front(), "value");
    Layer second = figure.layers.front();
    second.name = "second";
    second.opacity = 0.4;
    figure.layers.push_back(second);
    figure.importance.emplace();
    figure.importance->weights.object = 1;
    figure.importance->objects = {{3, 1}, {7, ofSeven}};
    return figure;
}

TEST(Visibility, SharesAddUpToThePicture) {
    for (const bool weighed : {false, true}) {
        Figure figure = twoLayers(2);
        if (weighed) {
            figure.importance->background = 1;
        } else {
            figure.importance.reset();
        }
        const VisibilityShares shares = sharesOf(figure);
        EXPECT_NEAR(sumOf(shares), 1, 1e-12);
        double labels = shares.paper;
        for (const auto& [label, share] : shares.labels) {
            labels += share;
        }
        EXPECT_NEAR(labels, 1, 1e-12);
        const double ranges =
            std::accumulate(shares.ranges.begin(), shares.ranges.end(), shares.paper,
                            [](double sum, const VisibilityShares::Range& range) { return sum + range.share; });
        EXPECT_NEAR(ranges, 1, 1e-12);
        const Picture picture = testing::renderWhole(*makeReferenceBackend(), *planSmall(figure));
        double alpha = 0;
        for (std::size_t i = 3; i < picture.rgba().size(); i += 4) {
            alpha += picture.rgba()[i];
        }
        EXPECT_NEAR(1 - shares.paper, alpha / (24 * 24), 1e-6);
    }
}

TEST(Visibility, OfAHiddenLabelIsNothing) {
    Figure figure = twoLayers(1);
    for (Layer& layer : figure.layers) {
        layer.labels = {0, 3};
    }
    const VisibilityShares shares = sharesOf(figure);
    const auto found = shares.labels.find(7);
    // borders are shared by membership, and told to the nearer label
    EXPECT_LT(found == shares.labels.end() ? 0 : found->second, 0.02);
    EXPECT_GT(shares.labels.at(3), 0.02);
}

TEST(Visibility, RisesWithAnObjectsWeight) {
    double before = -1;
    double first = -1;
    for (const double weight : {0.0, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0}) {
        const VisibilityShares shares = sharesOf(twoLayers(weight));
        const double share = shares.labels.at(7);
        EXPECT_GE(share, before - 1e-9) << "weight " << weight;
        before = share;
        first = first < 0 ? share : first;
    }
    EXPECT_GT(before, 1.05 * first) << "the weight does something here";
}

} // namespace
} // namespace limner
