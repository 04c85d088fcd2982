#include "widgets/measure_pictures.h"

#include "core/base/error.h"
#include "renderer/plan/planner.h"
#include "test_figure.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace limner {
namespace {

std::shared_ptr<const RenderPlan> shown(const Figure& figure) {
    Planner planner;
    Task task;
    PlanRequest request;
    request.size = {64, 64};
    return planner.plan(figure, request, task);
}

TEST(MeasurePictures, AreOneForEachMeasureThatCostsNoField) {
    Task task;
    const auto pictures = measurePictures(*shown(testing::smallFigure()), 40, task);
    EXPECT_EQ(pictures.size(), 6U);
    for (const auto& [pointer, picture] : pictures) {
        EXPECT_TRUE(pointer.starts_with("/importance/weights/"));
        EXPECT_EQ(picture.size(), QSize(40, 40));
    }
    const auto distinct = std::count_if(pictures.begin() + 1, pictures.end(),
                                        [&](const auto& one) { return one.second != pictures.front().second; });
    EXPECT_GE(distinct, 3) << "measures bring forward what they measure";
}

TEST(MeasurePictures, CanBeCancelled) {
    Task task;
    task.cancel();
    EXPECT_THROW(measurePictures(*shown(testing::smallFigure()), 40, task), Error);
}

} // namespace
} // namespace limner
