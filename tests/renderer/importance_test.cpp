#include "core/optics/importance.h"
#include "renderer/accuracy/importance_scenes.h"
#include "renderer/plan/importance_bricks.h"
#include "support/rendering.h"
#include "support/transfer_scenes.h"

#include <algorithm>
#include <cmath>
#include <random>

// Composition by importance as both backends draw it. (The formulas alone: tests/core/optics; features and random
// figures of one backend against the other: transfer_agreement_test.cpp.)

namespace limner {
namespace {

using testing::planOf;
using testing::renderWhole;

class ImportanceOnBackends : public testing::BackendTest {};
LIMNER_ON_EVERY_BACKEND(ImportanceOnBackends);

TEST_P(ImportanceOnBackends, PairOfSlabs) {
    for (const accuracy::ImportanceRow& row : accuracy::importanceTable()) {
        for (const int steps : {2, 8, 16, 64}) { // the same whatever the step
            const Picture picture = renderWhole(backend(), row.pair.scene(steps));
            const glm::dvec3 expected = row.pair.weights();
            const double allowed = rounding(6e-8, 2e-5); // a picture's numbers are float32
            EXPECT_NEAR(picture.pixel(0, 0)[0], expected.x, allowed) << row.pair.importance << " steps " << steps;
            EXPECT_NEAR(picture.pixel(0, 0)[1], expected.y, allowed) << row.pair.importance << " steps " << steps;
            EXPECT_NEAR(picture.pixel(0, 0)[3], expected.z, allowed) << row.pair.importance << " steps " << steps;
        }
    }
}

/// The figure of a feature of the shared list.
Figure weighed(const std::string& name) {
    testing::SmoothScene scene;
    scene.type = VoxelType::int16;
    Figure figure = testing::smoothFigure(scene);
    const auto& all = testing::transferFeatures();
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
    found->apply(figure);
    return figure;
}

Picture drawn(const Backend& backend, const Figure& figure) {
    PlanRequest request;
    request.size = {48, 48};
    return renderWhole(backend, *planOf(figure, request));
}

TEST_P(ImportanceOnBackends, OfNoWeightIsTheOrdinaryPicture) {
    const Figure with = weighed("importanceBackground");
    Figure without = with;
    without.importance.reset();
    const Picture ordinary = drawn(backend(), without);
    EXPECT_GT(testing::largestDifference(drawn(backend(), with), ordinary), 0.05) << "importance does nothing here";
    Figure none = with;
    none.importance->global = 0;
    EXPECT_TRUE(testing::sameBits(drawn(backend(), none), ordinary));
    none = with;
    none.importance->weights = {};
    none.importance->background = 0;
    EXPECT_TRUE(testing::sameBits(drawn(backend(), none), ordinary));
    none = with;
    none.importance->lenses.emplace_back().center = {9, 9};
    EXPECT_TRUE(testing::sameBits(drawn(backend(), none), ordinary)) << "a lens beside the picture";
}

TEST_P(ImportanceOnBackends, LeavesTheOpacityOrdinary) {
    Figure figure = weighed("importanceWithoutFloor");
    figure.quality.earlyTermination = 0;
    const Picture with = drawn(backend(), figure);
    figure.importance.reset();
    const Picture without = drawn(backend(), figure);
    for (std::size_t i = 3; i < with.rgba().size(); i += 4) {
        ASSERT_NEAR(with.rgba()[i], without.rgba()[i], 2e-6);
    }
}

TEST_P(ImportanceOnBackends, BackgroundOfGreatImportanceFadesTheRest) {
    Figure figure = weighed("importanceIntensity");
    double before = 1e9;
    for (const double background : {0.0, 1.0, 2.0, 5.0, 30.0}) {
        figure.importance->background = background;
        const Picture picture = drawn(backend(), figure);
        double alpha = 0;
        for (std::size_t i = 3; i < picture.rgba().size(); i += 4) {
            alpha += picture.rgba()[i];
        }
        EXPECT_LE(alpha, before + 1e-4) << background;
        before = alpha;
    }
    EXPECT_LT(before, 1) << "nothing is left in front of a paper of importance 60";
}

TEST_P(ImportanceOnBackends, ExtremesStaySound) {
    for (const double weight : {1e-6, 1.0, 1e3, 1e5}) {
        for (const double cap : {0.0, 8.0, 64.0}) {
            Figure figure = weighed("importanceWithoutFloor");
            figure.importance->global = weight;
            figure.importance->cap = cap;
            figure.importance->background = weight;
            figure.importance->weights.unocclusion = weight;
            figure.importance->silhouette.range = {0.5, 0.5};
            figure.layers.front().transfer.opacity.back().y = 1;
            EXPECT_EQ(testing::unsoundPixels(drawn(backend(), figure)), 0) << weight << " capped at " << cap;
        }
    }
}

TEST(ImportanceEnd, KeepsTheTolerance) {
    const auto backend = makeCpuBackend();
    for (const char* name : {"importanceIntensity", "importanceExtinction", "importanceUnocclusion", "importanceObject",
                             "importanceStatistics", "importanceBackground"}) {
        Figure figure = weighed(name);
        figure.layers.front().transfer.opacity.back().y = 0.9;
        figure.importance->global = 1;
        PlanRequest request;
        request.size = {48, 48};
        Task task;
        figure.quality.earlyTermination = 0;
        const auto whole = backend->render(*planOf(figure, request), {{0, 0}, request.size}, task);
        figure.quality.earlyTermination = 0.01;
        const auto ended = backend->render(*planOf(figure, request), {{0, 0}, request.size}, task);
        EXPECT_LE(testing::largestDifference(whole.picture, ended.picture), 0.01 + 1e-5) << name;
        EXPECT_LE(ended.samples, whole.samples) << name;
    }
}

TEST(ImportanceEnd, ComesWhereWhatIsInFrontMattersMost) {
    const auto backend = makeCpuBackend();
    Figure figure = weighed("importanceUnocclusion");
    figure.layers.front().transfer.opacity.back().y = 0.9;
    figure.importance->weights.intensity = 0;
    PlanRequest request;
    request.size = {48, 48};
    Task task;
    const auto samples = [&](double tolerance) {
        figure.quality.earlyTermination = tolerance;
        return backend->render(*planOf(figure, request), {{0, 0}, request.size}, task).samples;
    };
    EXPECT_LT(samples(0.01), samples(0) * 9 / 10);
    EXPECT_LE(samples(0.05), samples(0.01));
}

TEST(ImportanceBricksOfPlans, SumTheGreatestOfTheirMeasures) {
    const auto plan = [](const char* name) {
        PlanRequest request;
        request.size = {48, 48};
        return planOf(weighed(name), request);
    };
    const auto bricks = [](const RenderPlan& p) { return p.importance->bricks->greatest; };
    const auto all = plan("importanceWithoutFloor");
    const auto greatest = bricks(*all);
    // intensity 1, extinction 0.5 ln(1 + tau), gradient 1, silhouette 1
    EXPECT_GT(*std::max_element(greatest.begin(), greatest.end()), 2.5F);
    EXPECT_LT(*std::max_element(greatest.begin(), greatest.end()), 3.0F + 0.5F * std::log1p(1e6F));
    const ImportanceAhead ahead(*all);
    const auto table = ahead.behind({0, 0}, {48, 48});
    EXPECT_TRUE(std::is_sorted(table.rbegin(), table.rend())) << "what lies behind gets less";
    EXPECT_EQ(ahead.behind({-500, -500}, {-400, -400}).front(), 0) << "nothing is seen there";
}

} // namespace
} // namespace limner
