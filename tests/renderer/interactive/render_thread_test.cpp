#include "renderer/interactive/render_thread.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace limner {
namespace {

using namespace std::chrono_literals;

/// A backend that takes `msPerMegaRay` and looks for cancellation every 100 microseconds; the first pixel carries the
/// camera's height, so that a picture tells its request.
class SlowBackend : public Backend {
  public:
    explicit SlowBackend(double msPerMegaRay) : msPerMegaRay_(msPerMegaRay) {}
    [[nodiscard]] std::string name() const override { return "slow"; }
    RenderResult render(const RenderPlan& plan, const Tile& tile, Task& task) const override {
        const double rays = static_cast<double>(tile.size.x) * tile.size.y * plan.subPixels * plan.subPixels;
        const std::chrono::duration<double, std::milli> time(msPerMegaRay_ * rays * 1e-6 / plan.lattice.stepMm);
        const auto end = std::chrono::steady_clock::now() + time;
        while (std::chrono::steady_clock::now() < end) {
            task.throwIfCancelled();
            std::this_thread::sleep_for(100us);
        }
        RenderResult result{Picture(tile.size), 7, 3};
        *result.picture.pixel(0, 0) = static_cast<float>(plan.figure->camera.heightMm);
        return result;
    }

  private:
    double msPerMegaRay_;
};

std::shared_ptr<const RenderPlan> simplePlan(const Figure& figure, const PlanRequest& request, Task& task) {
    auto plan = std::make_shared<RenderPlan>();
    plan->figure = std::make_shared<const Figure>(figure);
    plan->size = request.size;
    plan->subPixels = std::max(1, request.subPixels);
    plan->lattice.stepMm = request.stepScale;
    task.warn("the scan is coarse");
    return plan;
}

/// Collects what is delivered.
struct Inbox {
    std::mutex mutex;
    std::vector<DeliveredPicture> pictures;
    std::vector<std::string> failures;
    RenderCallbacks callbacks() {
        return {[this](DeliveredPicture picture) {
                    const std::lock_guard lock(mutex);
                    pictures.push_back(std::move(picture));
                },
                [this](std::uint64_t, const Error& error) {
                    const std::lock_guard lock(mutex);
                    failures.emplace_back(error.what());
                },
                {}};
    }
    std::vector<DeliveredPicture> all() {
        const std::lock_guard lock(mutex);
        return pictures;
    }
};

ViewRequest view(double heightMm, glm::ivec2 size, bool draftsOnly = false) {
    auto figure = std::make_shared<Figure>();
    figure->camera.heightMm = heightMm;
    return {figure, size, draftsOnly};
}

float heightOf(const DeliveredPicture& picture) { return picture.picture->rgba()[0]; }

TEST(RenderThread, ComesFromCoarseToFine) {
    Inbox inbox;
    RenderThread thread(simplePlan, std::make_unique<SlowBackend>(500), inbox.callbacks(), {});
    ViewRequest request = view(10, {600, 600});
    auto figure = std::make_shared<Figure>(*request.figure);
    figure->quality.samplesPerPixel = 4;
    request.figure = figure;
    thread.request(request);
    thread.waitIdle();
    const auto pictures = inbox.all();
    ASSERT_EQ(pictures.size(), 3U) << "draft, sharp, still";
    EXPECT_LT(pictures[0].picture->size().x, 600);
    EXPECT_EQ(pictures[1].picture->size(), glm::ivec2(600));
    EXPECT_EQ(pictures[2].facts.coarseness, (Coarseness{1, 1, 2}));
    EXPECT_FALSE(pictures[0].facts.final);
    EXPECT_FALSE(pictures[1].facts.final);
    EXPECT_TRUE(pictures[2].facts.final);
    EXPECT_EQ(pictures[2].facts.backend, "slow");
    EXPECT_EQ(pictures[2].facts.samples, 7U);
    EXPECT_EQ(pictures[2].facts.warnings, std::vector<std::string>{"the scan is coarse"});
}

TEST(RenderThread, DrawsAtOnceWhatIsFast) {
    // The first guess, 160 ms, is twice what the longest budget leaves; the backend takes next to nothing. A machine
    // that stands still for a tenth of a second changes nothing.
    Inbox inbox;
    RenderThread thread(simplePlan, std::make_unique<SlowBackend>(1), inbox.callbacks(), {.draftBudgetMs = 500});
    thread.request(view(1, {400, 400}));
    thread.waitIdle();
    const std::size_t before = inbox.all().size();
    EXPECT_FALSE(inbox.all().front().facts.final) << "the first is a draft: the speed is not known yet";
    thread.request(view(2, {400, 400}));
    thread.waitIdle();
    const auto pictures = inbox.all();
    ASSERT_EQ(pictures.size(), before + 1);
    EXPECT_TRUE(pictures.back().facts.final);
    EXPECT_EQ(pictures.back().picture->size(), glm::ivec2(400));
}

TEST(RenderThread, TheNewestRequestWins) {
    Inbox inbox;
    RenderThread thread(simplePlan, std::make_unique<SlowBackend>(400), inbox.callbacks(), {});
    std::uint64_t last = 0;
    for (int i = 1; i <= 20; ++i) {
        last = thread.request(view(i, {500, 500}));
        std::this_thread::sleep_for(5ms);
    }
    thread.waitIdle();
    const auto pictures = inbox.all();
    ASSERT_FALSE(pictures.empty());
    EXPECT_EQ(pictures.back().facts.request, last);
    EXPECT_EQ(heightOf(pictures.back()), 20);
    EXPECT_TRUE(pictures.back().facts.final);
    int finals = 0;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        finals += pictures[i].facts.final ? 1 : 0;
        if (i > 0) {
            EXPECT_GE(pictures[i].facts.request, pictures[i - 1].facts.request) << "never an older after a newer";
        }
    }
    EXPECT_EQ(finals, 1) << "stills of overtaken requests are not finished";
}

TEST(RenderThread, AFastHandSeesDraftsAndNothingElse) {
    Inbox inbox;
    RenderThread thread(simplePlan, std::make_unique<SlowBackend>(400), inbox.callbacks(), {});
    for (int i = 1; i <= 60; ++i) { // faster than any draft
        thread.request(view(i, {800, 800}, true));
        std::this_thread::sleep_for(8ms);
    }
    thread.waitIdle();
    const auto pictures = inbox.all();
    EXPECT_GE(pictures.size(), 3U) << "a drag must not starve";
    for (const auto& picture : pictures)
        EXPECT_FALSE(picture.facts.final);
    EXPECT_EQ(heightOf(pictures.back()), 60);
}

TEST(RenderThread, ARunningStillStopsForAnEdit) {
    Inbox inbox;
    RenderThread thread(simplePlan, std::make_unique<SlowBackend>(20000), inbox.callbacks(), {});
    thread.request(view(1, {400, 400})); // the still alone would take 20 s
    while (inbox.all().empty())
        std::this_thread::sleep_for(1ms);
    std::this_thread::sleep_for(20ms);
    const auto start = std::chrono::steady_clock::now();
    thread.clear();
    thread.waitIdle();
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    std::cout << "stopped after " << took.count() << " ms\n";
    EXPECT_LT(took.count(), 5000) << "a stop that waits for the still is a hang";
    for (const auto& picture : inbox.all())
        EXPECT_FALSE(picture.facts.final);
}

TEST(RenderThread, PreparationsGoOnForAnEditThatNeedsThem) {
    std::atomic<int> stopped = 0;
    std::atomic<int> planned = 0;
    const auto slowPlan = [&](const Figure& figure, const PlanRequest& request, Task& task) {
        for (int i = 0; i < 50; ++i) {
            if (task.cancelled()) {
                ++stopped;
                task.throwIfCancelled();
            }
            std::this_thread::sleep_for(1ms);
        }
        ++planned;
        return simplePlan(figure, request, task);
    };
    Inbox inbox;
    RenderThread thread(slowPlan, std::make_unique<SlowBackend>(1), inbox.callbacks(), {});
    thread.request(view(1, {100, 100}));
    std::this_thread::sleep_for(10ms);
    thread.request(view(2, {100, 100})); // same volume, same clean-up
    thread.waitIdle();
    EXPECT_EQ(stopped, 0);
    thread.request(view(3, {100, 100}));
    std::this_thread::sleep_for(10ms);
    ViewRequest other = view(4, {100, 100});
    auto figure = std::make_shared<Figure>(*other.figure);
    figure->cleanup.emplace_back();
    other.figure = figure;
    thread.request(other);
    thread.waitIdle();
    EXPECT_EQ(stopped, 1);
    EXPECT_EQ(heightOf(inbox.all().back()), 4);
}

TEST(RenderThread, AFailureIsToldAndTheNextRequestWorks) {
    Inbox inbox;
    const auto plan = [](const Figure& figure, const PlanRequest& request, Task& task) {
        if (figure.camera.heightMm < 0)
            throw Error(ErrorKind::badInput, {"cannot draw the figure", "/camera/height_mm", "it is negative", ""});
        return simplePlan(figure, request, task);
    };
    RenderThread thread(plan, std::make_unique<SlowBackend>(1), inbox.callbacks(), {});
    thread.request(view(-1, {50, 50}));
    thread.waitIdle();
    ASSERT_EQ(inbox.failures.size(), 1U);
    EXPECT_NE(inbox.failures[0].find("/camera/height_mm"), std::string::npos);
    thread.request(view(1, {50, 50}));
    thread.waitIdle();
    EXPECT_FALSE(inbox.all().empty());
}

TEST(RenderThread, GoesDownInTheMiddleOfWork) {
    for (int i = 0; i < 20; ++i) {
        Inbox inbox;
        RenderThread thread(simplePlan, std::make_unique<SlowBackend>(5000), inbox.callbacks(), {});
        thread.request(view(1, {500, 500}));
        std::this_thread::sleep_for(std::chrono::milliseconds(i % 5));
    }
}

TEST(DraftPace, KeepsToItsBudgetByItsOwnPrediction) {
    DraftPace pace(50);
    pace.measured({1000, 1000}, {1, 1, 1}, 400, true);
    const Coarseness draft = pace.draft({1000, 1000});
    EXPECT_LE(pace.predictedMs({1000, 1000}, draft), 50 * 1.02); // rounding of the picture's size
    EXPECT_GT(pace.predictedMs({1000, 1000}, draft), 50 * 0.8) << "coarser than needed";
    EXPECT_GT(draft.stepScale, 1);
    EXPECT_GT(draft.pixelScale, draft.stepScale * 0.5);
}

TEST(DraftPace, SlowPlanningLeavesLessForDrawing) {
    DraftPace pace(50);
    pace.measured({1000, 1000}, {1, 1, 1}, 400, true);
    pace.prepared(10);
    const double quick = pace.predictedMs({1000, 1000}, pace.draft({1000, 1000}));
    pace.prepared(55);
    const double slow = pace.predictedMs({1000, 1000}, pace.draft({1000, 1000}));
    EXPECT_NEAR(quick, 50, 1);
    EXPECT_NEAR(slow, 25, 1);
    pace.prepared(5000); // the first plan of a figure
    EXPECT_GT(pace.predictedMs({1000, 1000}, pace.draft({1000, 1000})), 10);
}

TEST(DraftPace, AStoppedDraftMakesTheNextCoarser) {
    DraftPace pace(50);
    pace.measured({1000, 1000}, {1, 1, 1}, 100, true);
    const Coarseness before = pace.draft({1000, 1000});
    pace.measured({1000, 1000}, before, 300, false);
    EXPECT_GT(pace.draft({1000, 1000}).pixelScale, before.pixelScale);
}

} // namespace
} // namespace limner
