#include "renderer/accuracy/line_error.h"

#include <gtest/gtest.h>

namespace limner::accuracy {
namespace {

std::vector<bool> column(int at, int width = 40, int height = 10) {
    std::vector<bool> mask(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y)
        mask[static_cast<std::size_t>(y * width + at)] = true;
    return mask;
}

TEST(LineError, OfALineThatMovedIsItsWay) {
    EXPECT_EQ(compareLines(column(8), column(8), 40).meanDistance, 0);
    EXPECT_EQ(compareLines(column(8), column(8), 40).disagreement, 0);
    const LineError moved = compareLines(column(8), column(11), 40);
    EXPECT_TRUE(moved.any);
    EXPECT_EQ(moved.meanDistance, 3);
    EXPECT_EQ(moved.p95Distance, 3);
    EXPECT_EQ(moved.disagreement, 1);
}

TEST(LineError, OfALineThatIsNotThereIsTheFarthest) {
    const std::vector<bool> none(400);
    EXPECT_EQ(compareLines(column(8), none, 40).meanDistance, kFarthest);
    EXPECT_FALSE(compareLines(none, none, 40).any);
}

TEST(LineError, MasksWhatLinesChange) {
    Picture without({2, 1});
    Picture with = without;
    with.pixel(1, 0)[3] = 0.5F;
    EXPECT_EQ(lineMask(with, without), (std::vector<bool>{false, true}));
}

} // namespace
} // namespace limner::accuracy
