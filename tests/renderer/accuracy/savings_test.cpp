#include "renderer/accuracy/savings.h"

#include "core/base/error.h"
#include "support/rendering.h"
#include "support/transfer_scenes.h"

#include <algorithm>

namespace limner {
namespace {

Figure figureOfEightBits() {
    testing::SmoothScene scene;
    scene.type = VoxelType::uint8;
    Figure figure = testing::smoothFigure(scene);
    figure.quality.earlyTermination = 0.001;
    testing::makeLine(figure.layers.front(), "value");
    figure.layers.front().contours = Contours{0, true, CurvatureEstimator::hessian, 1.3};
    return figure;
}

const accuracy::Saving& savingOf(const accuracy::Savings& savings, LeaveOut rule) {
    const auto found = std::find_if(savings.rules.begin(), savings.rules.end(),
                                    [rule](const auto& saving) { return saving.leftOut.rule == rule; });
    EXPECT_NE(found, savings.rules.end()) << ruleOf(rule).name;
    return *found;
}

TEST(Savings, AreMeasuredForEveryRuleAtWork) {
    const Figure figure = figureOfEightBits();
    PlanRequest request;
    request.size = {64, 48};
    Task task;
    const auto savings = accuracy::measureSavings(figure, *makeCpuBackend(), request, task);
    const auto plan = testing::planOf(figure, request);
    ASSERT_EQ(savings.rules.size(), plan->leftOut.size());
    for (std::size_t i = 0; i < savings.rules.size(); ++i) {
        EXPECT_EQ(savings.rules[i].leftOut.rule, plan->leftOut[i].rule);
        EXPECT_GT(savings.rules[i].keptMs, 0);
    }
    EXPECT_EQ(savings.backend, "cpu");
    EXPECT_EQ(savings.pixels, request.size);
    EXPECT_GE(savings.rounds, 2);
    EXPECT_GT(savings.ms, 0);
    EXPECT_GT(savings.keptMs, 0);
    // Sixteen bits take as many bytes more as eight have, but for the store's padding; curvature takes a field.
    const auto scan = static_cast<double>(figure.volume->data->bytes());
    EXPECT_NEAR(static_cast<double>(savingOf(savings, LeaveOut::wideVoxels).bytes), scan, 0.01 * scan);
    EXPECT_GT(static_cast<double>(savingOf(savings, LeaveOut::curvature).bytes), 0.9 * scan);
    EXPECT_EQ(savingOf(savings, LeaveOut::restOfRay).bytes, 0);
    EXPECT_GE(savings.keptBytes, savings.bytes + figure.volume->data->bytes());
}

TEST(Savings, AreOfTheMiddleOfALargePicture) {
    PlanRequest request;
    request.size = {700, 20};
    Task task;
    EXPECT_EQ(accuracy::measureSavings(figureOfEightBits(), *makeCpuBackend(), request, task).pixels,
              glm::ivec2(512, 20));
}

TEST(Savings, AddUp) {
    accuracy::Savings savings;
    savings.rules = {{{}, 12, 2, 100}, {{}, 10, -0.5, -40}};
    EXPECT_EQ(savings.sumMs(), 1.5);
    EXPECT_EQ(savings.sumBytes(), 60);
}

TEST(Savings, StopWhenCancelled) {
    Task task;
    task.cancel();
    PlanRequest request;
    request.size = {32, 32};
    EXPECT_THROW(accuracy::measureSavings(figureOfEightBits(), *makeCpuBackend(), request, task), Error);
}

} // namespace
} // namespace limner
