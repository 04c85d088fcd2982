#include "renderer/accuracy/self_test.h"

#include "core/base/error.h"
#include "renderer/accuracy/importance_scenes.h"
#include "support/rendering.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <utility>

// The table of analytic scenes: right on every backend, and wrong where a backend is.

namespace limner::accuracy {
namespace {

using testing::BackendTest;

class SelfTestOf : public BackendTest {};
LIMNER_ON_EVERY_BACKEND(SelfTestOf);

TEST_P(SelfTestOf, ScenesHoldOnEveryBackend) {
    Task task;
    const auto rows = selfTest(backend(), task);
    std::set<std::string> scenes;
    for (const SceneReport& row : rows) {
        EXPECT_TRUE(row.passed) << row.scene << ' ' << row.quantity << ": " << row.observed << " for " << row.expected
                                << ", off by " << row.error << " of " << row.bound;
        EXPECT_FALSE(row.reason.empty()) << row.quantity;
        scenes.insert(row.scene);
        RecordProperty(row.scene + " " + row.quantity, std::to_string(row.error));
    }
    EXPECT_EQ(scenes, (std::set<std::string>{"A1", "A2", "A3", "A4", "A5", "A6", "A7", "A8"}));
}

TEST(ImportanceForms, AreTheTabulatedNumbers) {
    for (const ImportanceRow& row : importanceTable()) {
        for (int c = 0; c < 3; ++c) { // the table has ten digits
            EXPECT_NEAR(row.pair.weights()[c], row.tabulated[c], 1e-10) << row.pair.importance << ' ' << c;
        }
    }
    EXPECT_NEAR(ThinSheet().premultiplied(), 0.91913696, 1e-8);
}

/// Draws with another backend, and wrongly.
class WrongBackend final : public Backend {
  public:
    using Change = std::function<void(RenderPlan&)>;
    using Smear = std::function<float(float)>;
    WrongBackend(Change change, Smear smear) : change_(std::move(change)), smear_(std::move(smear)) {}
    [[nodiscard]] std::string name() const override { return right_->name(); }
    RenderResult render(const RenderPlan& plan, const Tile& tile, Task& task) const override {
        RenderPlan changed = plan;
        change_(changed);
        RenderResult result = right_->render(changed, tile, task);
        std::transform(result.picture.rgba().begin(), result.picture.rgba().end(), result.picture.rgba().begin(),
                       smear_);
        return result;
    }

  private:
    std::unique_ptr<Backend> right_ = makeReferenceBackend();
    Change change_;
    Smear smear_;
};

const WrongBackend::Change kRightPlan = [](RenderPlan&) {};
const WrongBackend::Smear kRightPixels = [](float v) { return v; };

/// Scenes of which at least one row fails.
std::set<std::string> failures(const Backend& backend) {
    Task task;
    std::set<std::string> scenes;
    for (const SceneReport& row : selfTest(backend, task)) {
        if (!row.passed) {
            scenes.insert(row.scene);
        }
    }
    return scenes;
}

/// Ends every ray with its last whole step, as far as the box goes along the middle ray.
void dropLastPartialStep(RenderPlan& plan) {
    const Grid& grid = plan.volume->grid();
    const glm::dvec3 forward = glm::normalize(plan.rays.mmFromVoxel * plan.rays.forwardVoxel);
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 side(corner % 2, corner / 2 % 2, corner / 4);
        const double face = 0.5 - plan.lattice.boxInset;
        const glm::dvec3 voxel = side * (glm::dvec3(grid.dims - 1) + 2 * face) - face;
        const double along = glm::dot(forward, grid.mmFromVoxel(voxel));
        low = std::min(low, along);
        high = std::max(high, along);
    }
    const double whole = std::floor((high - low) / plan.lattice.stepMm) * plan.lattice.stepMm;
    plan.clip.planes.push_back({forward, low + whole});
}

TEST(SelfTestOfAWrongBackend, FindsALostPartialStep) {
    EXPECT_TRUE(failures(WrongBackend(dropLastPartialStep, kRightPixels)).contains("A1"));
}

TEST(SelfTestOfAWrongBackend, FindsOnePercent) {
    for (const float factor : {0.99F, 1.01F}) {
        const auto found = failures(WrongBackend(kRightPlan, [factor](float v) { return factor * v; }));
        for (const char* scene : {"A1", "A2", "A4", "A5", "A7", "A8"}) {
            EXPECT_TRUE(found.contains(scene)) << scene << ' ' << factor;
        }
    }
}

TEST(SelfTestOfAWrongBackend, FindsSamplesThatAreNotInTheMiddle) {
    const auto shift = [](RenderPlan& plan) { plan.lattice.phase = std::min(1.0, plan.lattice.phase + 0.1); };
    const auto found = failures(WrongBackend(shift, kRightPixels));
    EXPECT_TRUE(found.contains("A2"));
    EXPECT_TRUE(found.contains("A5"));
}

TEST(SelfTestOfAWrongBackend, FindsRaysThatEndTooSoon) {
    const auto early = [](RenderPlan& plan) { plan.earlyTermination = 2 * plan.earlyTermination + 1e-3; };
    EXPECT_TRUE(failures(WrongBackend(early, kRightPixels)).contains("A2"));
}

TEST(SelfTestOfAWrongBackend, FindsImportanceThatIsNotThere) {
    const auto found = failures(WrongBackend([](RenderPlan& plan) { plan.importance.reset(); }, kRightPixels));
    EXPECT_EQ(found, (std::set<std::string>{"A5", "A8"}));
}

TEST(SelfTestOfAWrongBackend, FindsOpacityThatForgetsTheStep) {
    const auto forgets = [](RenderPlan& plan) { plan.referenceLengthMm *= 1.0001; };
    const auto found = failures(WrongBackend(forgets, kRightPixels));
    EXPECT_TRUE(found.contains("A1"));
    EXPECT_TRUE(found.contains("A7"));
}

TEST(SelfTestOfAWrongBackend, FindsInterpolationThatIsNotWhatWasAsked) {
    const auto linear = [](RenderPlan& plan) {
        plan.interpolation = Interpolation::linear;
        plan.field = plan.volume;
        plan.gradient = GradientEstimator::central;
        plan.gradientField = plan.volume;
    };
    EXPECT_EQ(failures(WrongBackend(linear, kRightPixels)), std::set<std::string>{"A6"});
}

TEST(SelfTestOfAWrongBackend, FindsWhatIsNoNumber) {
    const auto none = [](float) { return std::numeric_limits<float>::quiet_NaN(); };
    const auto found = failures(WrongBackend(kRightPlan, none));
    EXPECT_EQ(found, (std::set<std::string>{"A1", "A2", "A3", "A4", "A5", "A6", "A7", "A8"}));
}

TEST(SelfTestOfAWrongBackend, StopsWhenCancelled) {
    Task task;
    task.cancel();
    EXPECT_THROW(selfTest(*makeReferenceBackend(), task), Error);
}

} // namespace
} // namespace limner::accuracy
