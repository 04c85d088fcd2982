#include "core/base/error.h"
#include "core/volume/phantom.h"
#include "renderer/accuracy/analytic_scenes.h"
#include "renderer/accuracy/study.h"
#include "renderer/accuracy/tolerance.h"
#include "support/rendering.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

// The probe, the model reference, the search for a tolerance and the study (spec accuracy.md 1.8, 1.9).

namespace limner::accuracy {
namespace {

/// A soft ball in the middle of a picture of 96 pixels, and how to draw it.
struct Scene {
    Figure figure;
    PlanRequest request;
};

/// Its transfer function has a corner: the error of the step falls with its square, not faster than any power as a
/// smooth one's does.
Scene blob() {
    const GaussianBlob ball{6, 0.4, 0.05};
    AnalyticScene scene = ball.scene(0.025);
    scene.figure.camera.heightMm = 2;
    const ValueRange range = scene.figure.volume->data->range();
    const double width = range.high - range.low;
    scene.figure.layers[0].transfer.opacity = {
        {range.low + 0.2 * width, 0}, {range.low + 0.6 * width, 0.4}, {range.high, 0.4}};
    scene.request.lattice.reset();
    scene.request.size = {96, 96};
    return {scene.figure, scene.request};
}

/// Draws like the processor and then spoils what it drew.
class Spoilt final : public Backend {
  public:
    explicit Spoilt(float (*spoil)(float)) : spoil_(spoil) {}
    [[nodiscard]] std::string name() const override { return "spoilt"; }
    RenderResult render(const RenderPlan& plan, const Tile& tile, Task& task) const override {
        RenderResult result = cpu_->render(plan, tile, task);
        const float factor = static_cast<float>(plan.lattice.stepMm / plan.referenceLengthMm);
        for (float& v : result.picture.rgba())
            v += spoil_(factor);
        return result;
    }

  private:
    std::unique_ptr<Backend> cpu_ = makeCpuBackend();
    float (*spoil_)(float);
};

bool overlap(const Tile& a, const Tile& b) {
    return a.origin.x < b.origin.x + b.size.x && b.origin.x < a.origin.x + a.size.x &&
           a.origin.y < b.origin.y + b.size.y && b.origin.y < a.origin.y + a.size.y;
}

TEST(Probe, StandsForThePictureAndIsTheSameEveryTime) {
    Scene scene = blob();
    scene.request.size = {512, 300};
    const auto cpu = makeCpuBackend();
    Planner planner;
    Task task;
    const auto plan = planner.plan(scene.figure, scene.request, task);
    const Probe probe = chooseProbe(scene.figure, *plan, *cpu, planner, task);
    const Probe again = chooseProbe(scene.figure, *plan, *cpu, planner, task);
    std::vector<Tile> all = probe.searched;
    all.insert(all.end(), probe.heldOut.begin(), probe.heldOut.end());
    EXPECT_EQ(probe.pixels(), 64.0 * static_cast<double>(all.size()));
    EXPECT_GE(all.size(), 64U);
    EXPECT_LE(all.size(), 80U);
    EXPECT_NEAR(static_cast<double>(probe.searched.size()), static_cast<double>(probe.heldOut.size()), 2);
    int left = 0;
    int top = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_TRUE(all[i].origin.x >= 0 && all[i].origin.x + all[i].size.x <= 512);
        EXPECT_TRUE(all[i].origin.y >= 0 && all[i].origin.y + all[i].size.y <= 300);
        left += all[i].origin.x < 256 ? 1 : 0;
        top += all[i].origin.y < 150 ? 1 : 0;
        for (std::size_t k = 0; k < i; ++k)
            EXPECT_FALSE(overlap(all[i], all[k]));
    }
    EXPECT_NEAR(left, static_cast<int>(all.size()) / 2, 10);
    EXPECT_NEAR(top, static_cast<int>(all.size()) / 2, 10);
    ASSERT_EQ(again.searched.size(), probe.searched.size());
    for (std::size_t i = 0; i < probe.searched.size(); ++i)
        EXPECT_EQ(again.searched[i].origin, probe.searched[i].origin);
}

TEST(Probe, TilesTogetherAreTilesAlone) {
    const Scene scene = blob();
    Planner planner;
    Task task;
    const auto plan = planner.plan(scene.figure, scene.request, task);
    const std::vector<Tile> tiles = {{{0, 0}, {8, 8}}, {{32, 64}, {8, 8}}, {{90, 40}, {6, 3}}};
    for (const auto& backend : {makeCpuBackend(), makeReferenceBackend()}) {
        const RenderResult all = backend->renderTiles(*plan, tiles, task);
        EXPECT_EQ(all.picture.size(), glm::ivec2(8, 19));
        int top = 0;
        std::uint64_t samples = 0;
        for (const Tile& tile : tiles) {
            const RenderResult one = backend->render(*plan, tile, task);
            samples += one.samples;
            for (int y = 0; y < tile.size.y; ++y)
                for (int i = 0; i < tile.size.x * 4; ++i)
                    EXPECT_EQ(all.picture.pixel(0, top + y)[i], one.picture.pixel(0, y)[i]);
            top += tile.size.y;
        }
        EXPECT_EQ(all.samples, samples);
    }
}

/// The reference's bar holds against double precision with steps that are finer than its own.
TEST(ModelReference, IsAsNearTheTruthAsItSays) {
    const Scene scene = blob();
    const auto cpu = makeCpuBackend();
    const auto exact = makeReferenceBackend();
    Task task;
    Bench bench(scene.figure, scene.request, *cpu, task);
    bench.makeReference({ErrorMetric::largest, 1e-3}, exact.get());
    const ModelReference& reference = bench.reference();
    EXPECT_LT(reference.errorBar(ErrorMetric::largest), 1e-4);
    EXPECT_GT(reference.errorBar(ErrorMetric::largest), 0);
    Figure fine = scene.figure;
    fine.quality = bench.best();
    fine.quality.stepVoxels = 1.0 / 64;
    Planner planner;
    const auto plan = planner.plan(fine, scene.request, task);
    const Picture truth = drawProbe(*plan, bench.probe().searched, *exact, {}, task).picture;
    EXPECT_LE(measureError(reference.searched, truth, {1, 1, 1}).largest,
              reference.errorBar(ErrorMetric::largest) + 2e-6);
}

/// By point samples the error falls with the step's square here. (Slabs are down to rounding at 1/8 voxel.)
TEST(ModelReference, IsExtrapolatedWhereItHasItsOrder) {
    Scene scene = blob();
    const auto cpu = makeCpuBackend();
    Planner planner;
    Task task;
    const auto plan = planner.plan(scene.figure, scene.request, task);
    const Probe probe = chooseProbe(scene.figure, *plan, *cpu, planner, task);
    const ModelReference reference = makeModelReference(scene.figure, scene.request, probe,
                                                        {ErrorMetric::largest, 1e-3}, *cpu, nullptr, planner, task);
    EXPECT_NEAR(reference.order, 2, 0.3);
    EXPECT_TRUE(reference.extrapolated);
    EXPECT_EQ(reference.step, 1.0 / 32);
    scene.figure.quality.stepVoxels = 0.5;
    const Picture coarse =
        drawProbe(*planner.plan(scene.figure, scene.request, task), probe.searched, *cpu, {}, task).picture;
    EXPECT_GT(measureError(coarse, reference.searched, {1, 1, 1}).largest,
              10 * reference.errorBar(ErrorMetric::largest));
}

TEST(ModelReference, OfNoNumbersIsRefused) {
    const Scene scene = blob();
    const Spoilt spoilt([](float) { return std::numeric_limits<float>::quiet_NaN(); });
    Task task;
    Bench bench(scene.figure, scene.request, spoilt, task);
    try {
        bench.makeReference({}, nullptr);
        FAIL() << "pixels that are no numbers went through";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::notFinite);
    }
}

/// The delivered error is measured here on the whole picture, by double precision: no probe, no search.
TEST(Tolerance, IsKeptOnTheWholePicture) {
    const Scene scene = blob();
    const auto cpu = makeCpuBackend();
    const auto exact = makeReferenceBackend();
    Task task;
    Bench bench(scene.figure, scene.request, *cpu, task);
    bench.makeReference({ErrorMetric::rootMeanSquare, 1e-5}, nullptr);
    Planner planner;
    Figure figure = scene.figure;
    figure.quality = bench.best();
    const Picture truth = exact->render(*planner.plan(figure, scene.request, task), {{0, 0}, {96, 96}}, task).picture;
    std::vector<double> steps;
    for (const double asked : {3e-3, 3e-4, 3e-5}) {
        const ToleranceChoice choice = chooseQuality(bench, {ErrorMetric::rootMeanSquare, asked});
        EXPECT_TRUE(choice.reached) << asked;
        EXPECT_LE(choice.heldOutError, asked);
        figure.quality = choice.quality;
        const Picture drawn = cpu->render(*planner.plan(figure, scene.request, task), {{0, 0}, {96, 96}}, task).picture;
        EXPECT_LE(measureError(drawn, truth, {1, 1, 1}).rmse, asked) << choice.words;
        EXPECT_LE(choice.quality.stepVoxels, 0.5) << "half a voxel is never left";
        EXPECT_FALSE(choice.words.empty());
        steps.push_back(choice.quality.stepVoxels + choice.quality.earlyTermination);
    }
    EXPECT_GT(steps.front(), steps.back()) << "less error costs more";
}

TEST(Tolerance, BelowTheReferencesBarIsRefused) {
    const Scene scene = blob();
    const auto cpu = makeCpuBackend();
    Task task;
    Bench bench(scene.figure, scene.request, *cpu, task);
    bench.makeReference({ErrorMetric::largest, 1e-12}, nullptr);
    try {
        chooseQuality(bench, {ErrorMetric::largest, 1e-12});
        FAIL() << "nothing can be told to 1e-12 in single precision";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::notConverged);
    }
}

/// Half a grey where steps are not the finest, nothing where they are finer than any level: no setting helps.
TEST(Tolerance, ThatNoSettingReachesIsSaid) {
    const Scene scene = blob();
    const Spoilt spoilt([](float step) { return step > 0.05F ? 0.25F : 0.0F; });
    Task task;
    Bench bench(scene.figure, scene.request, spoilt, task);
    bench.makeReference({ErrorMetric::rootMeanSquare, 0.01}, nullptr);
    const ToleranceChoice choice = chooseQuality(bench, {ErrorMetric::rootMeanSquare, 0.1});
    EXPECT_FALSE(choice.reached);
    EXPECT_GT(choice.searchedError, 0.2);
}

/// A peak of 2 units of a thousand is stepped over by half a voxel where the scan rises by 100 units a voxel.
TEST(StepLimit, FollowsTheNarrowestPeak) {
    Scene scene = blob();
    Task task;
    Planner planner;
    const auto wide = planner.plan(scene.figure, scene.request, task);
    EXPECT_EQ(stepLimit(*wide, false).voxels, 0.5);
    const ValueRange range = scene.figure.volume->data->range();
    const double middle = 0.5 * (range.low + range.high);
    const double width = (range.high - range.low) * 1e-3;
    scene.figure.layers[0].transfer.opacity = {{middle - width, 0}, {middle, 0.5}, {middle + width, 0}};
    const auto narrow = planner.plan(scene.figure, scene.request, task);
    const StepLimit limit = stepLimit(*narrow, false);
    EXPECT_LT(limit.voxels, 0.1);
    EXPECT_NE(limit.reason.find("peak"), std::string::npos);
    EXPECT_EQ(stepLimit(*narrow, true).voxels, 0.5) << "slabs do not step over it";
}

/// The study of the phantom's head, small.
const Study& headStudy() {
    static const Study study = [] {
        Figure figure = blob().figure;
        figure.title = "A <soft> ball";
        StudyOptions options;
        options.secondsBudget = 20;
        Task task;
        return runStudy(figure, blob().request, *makeCpuBackend(), options, task);
    }();
    return study;
}

TEST(Study, HasWhatItPromises) {
    const Study& study = headStudy();
    EXPECT_EQ(study.rows[study.present].method, "present");
    EXPECT_EQ(study.picture.size(), glm::ivec2(96, 96));
    ASSERT_FALSE(study.series.empty());
    EXPECT_TRUE(study.series[0].ordered);
    EXPECT_NEAR(study.series[0].order, 2, 0.5);
    EXPECT_GE(study.choices.size(), 3U);
    for (const auto& [name, choice] : study.choices)
        EXPECT_TRUE(!choice.reached || choice.heldOutError <= choice.asked.value) << name;
    for (std::size_t i = 0; i + 1 < study.pareto.size(); ++i) {
        const Measured& a = study.rows[study.pareto[i]].measured;
        const Measured& b = study.rows[study.pareto[i + 1]].measured;
        EXPECT_LE(a.seconds, b.seconds);
        EXPECT_GT(a.error.of(study.metric), b.error.of(study.metric));
    }
    for (const StudyRow& row : study.rows) {
        const bool beaten = std::any_of(study.pareto.begin(), study.pareto.end(), [&](std::size_t k) {
            const Measured& m = study.rows[k].measured;
            return m.seconds <= row.measured.seconds && m.error.of(study.metric) <= row.measured.error.of(study.metric);
        });
        EXPECT_TRUE(beaten) << row.words << " belongs to the hull";
    }
}

TEST(Study, IsReportedInThreeForms) {
    const Study& study = headStudy();
    const auto json = nlohmann::json::parse(reportJson(study));
    EXPECT_EQ(json.at("rows").size(), study.rows.size());
    EXPECT_EQ(json.at("reference").at("kind"), "model");
    EXPECT_EQ(json.at("reference").at("error_bar").get<double>(), study.errorBar);
    for (const char* key : {"seconds", "rmse", "max", "ciede2000_p95", "knobs"})
        EXPECT_TRUE(json.at("rows").at(0).contains(key)) << key;
    for (const char* key : {"pareto", "orders", "present", "limiting_knob"})
        EXPECT_TRUE(json.contains(key)) << key;
    std::istringstream csv(reportCsv(study));
    std::size_t lines = 0;
    for (std::string line; std::getline(csv, line);)
        ++lines;
    EXPECT_EQ(lines, study.rows.size() + 1);
    const std::string html = reportHtml(study, blob().figure);
    EXPECT_NE(html.find("<svg"), std::string::npos);
    EXPECT_NE(html.find("A &lt;soft&gt; ball"), std::string::npos);
    EXPECT_EQ(html.find("http://www.w3.org/2000/svg"), html.rfind("http")) << "nothing is fetched from elsewhere";
    EXPECT_EQ(html.find("nan"), std::string::npos);
}

TEST(Study, CanBeCancelled) {
    Task task;
    task.cancel();
    EXPECT_THROW(runStudy(blob().figure, blob().request, *makeCpuBackend(), {}, task), Error);
}

TEST(ErrorMap, IsClearWhereNothingIsWrongAndDarkWhereAllIs) {
    Picture best({2, 1});
    Picture picture({2, 1});
    std::fill(picture.pixel(1, 0), picture.pixel(1, 0) + 3, 0.0F);
    best.pixel(1, 0)[0] = best.pixel(1, 0)[1] = best.pixel(1, 0)[2] = 0;
    picture.pixel(1, 0)[3] = 1; // black beside clear on white
    const Picture map = errorMap(colourDifferences(picture, best, {1, 1, 1}), {2, 1}, 10);
    EXPECT_EQ(map.pixel(0, 0)[3], 0);
    EXPECT_EQ(map.pixel(1, 0)[3], 1);
    EXPECT_EQ(map.pixel(1, 0)[0], 0);
}

} // namespace
} // namespace limner::accuracy
