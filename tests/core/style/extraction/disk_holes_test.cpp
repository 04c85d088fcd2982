#include "core/style/extraction/disk_holes.h"

#include "core/base/task.h"

#include <gtest/gtest.h>

#include <cmath>

namespace limner {
namespace {

/// A disk in a linear colour, with holes where `hole` says so of a normal.
template <typename Hole>
ArtPicture diskWith(int side, Hole hole) {
    ArtPicture disk{side, side, {}};
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const double nx = (2.0 * x + 1) / side - 1;
            const double ny = 1 - (2.0 * y + 1) / side;
            const bool on = nx * nx + ny * ny <= 1;
            const auto colour = static_cast<float>(0.5 + 0.3 * nx - 0.1 * ny);
            const bool kept = on && !hole(nx, ny);
            disk.pixels.push_back(kept ? Rgba{colour, 1 - colour, 0.25F, 1} : Rgba{0, 0, 0, 0});
        }
    }
    return disk;
}

TEST(DiskHoles, CoverageIsTheShareOfTheDisk) {
    EXPECT_DOUBLE_EQ(diskCoverage(diskWith(100, [](double, double) { return false; })), 1);
    EXPECT_NEAR(diskCoverage(diskWith(100, [](double x, double) { return x > 0; })), 0.5, 1e-12);
    EXPECT_NEAR(diskCoverage(diskWith(200, [](double x, double y) { return x * x + y * y < 0.25; })), 0.75, 0.005);
    EXPECT_EQ(diskCoverage(diskWith(50, [](double, double) { return true; })), 0);
}

TEST(DiskHoles, TheLargestIsMeasuredInDegrees) {
    // All directions within 20 degrees of the viewer's are missing: a gap 40 degrees wide.
    const double radius = std::sin(20 * 3.14159265358979 / 180);
    const ArtPicture cap = diskWith(400, [&](double x, double y) { return x * x + y * y < radius * radius; });
    EXPECT_NEAR(largestHoleDegrees(cap), 40, 1);
    // A rim of 20 degrees is as wide as that: there is nothing on its other side.
    const double inner = std::cos(20 * 3.14159265358979 / 180);
    const ArtPicture rim = diskWith(400, [&](double x, double y) { return x * x + y * y > inner * inner; });
    EXPECT_NEAR(largestHoleDegrees(rim), 20, 2);
    EXPECT_EQ(largestHoleDegrees(diskWith(64, [](double, double) { return false; })), 0);
    EXPECT_EQ(largestHoleDegrees(diskWith(64, [](double, double) { return true; })), 180);
}

TEST(DiskHoles, AMembraneBringsBackALinearColour) {
    ArtPicture disk = diskWith(128, [](double x, double y) { return std::hypot(x - 0.1, y + 0.2) < 0.35; });
    Task task;
    fillHoles(disk, task);
    const ArtPicture whole = diskWith(128, [](double, double) { return false; });
    for (std::size_t i = 0; i < disk.pixels.size(); ++i) {
        EXPECT_EQ(disk.pixels[i].a, 1);
        if (whole.pixels[i].a > 0) {
            EXPECT_NEAR(disk.pixels[i].r, whole.pixels[i].r, 1e-3);
            EXPECT_NEAR(disk.pixels[i].b, 0.25, 1e-4);
        }
    }
}

TEST(DiskHoles, AHoleAtTheRimEndsLevel) {
    // Only a strip in the middle is known: outwards nothing pulls, so its edge's colour goes on.
    ArtPicture disk = diskWith(128, [](double x, double) { return std::abs(x) > 0.3; });
    Task task;
    fillHoles(disk, task);
    EXPECT_NEAR(disk.at(126, 64).r, 0.5 + 0.3 * 0.3, 0.02);
    EXPECT_NEAR(disk.at(1, 64).r, 0.5 - 0.3 * 0.3, 0.02);
}

} // namespace
} // namespace limner
