#include "core/volume/slice.h"

#include "core/base/error.h"

#include "support/make_volume.h"

#include <gtest/gtest.h>

#include <cmath>

namespace limner {
namespace {

/// A volume whose value is a plane in space: any trilinear slice of it is exact.
std::shared_ptr<const Volume> ramp() {
    Grid grid;
    grid.dims = {8, 10, 12};
    grid.spacingMm = {2, 1, 3};
    grid.originMm = {-5, 4, 7};
    return testing::makeVolume<std::int16_t>(grid, VoxelType::int16,
                                             [](glm::ivec3 v) { return 10 * v.x + 3 * v.y - 7 * v.z; });
}

double expected(const Volume& volume, const glm::dvec3& mm) {
    const glm::dvec3 v = volume.grid().voxelFromMm(mm);
    return 10 * v.x + 3 * v.y - 7 * v.z;
}

TEST(Slice, EveryPixelIsTheScansValueAtItsPlace) {
    const auto volume = ramp();
    for (const SlicePlane plane : {SlicePlane::axial, SlicePlane::coronal, SlicePlane::sagittal}) {
        const SliceRequest request{plane, volume->grid().centreMm() + glm::dvec3(0.3, -0.2, 0.4), 0.5, {9, 7}};
        Task task;
        const std::vector<float> values = sliceThrough(*volume, request, task);
        ASSERT_EQ(values.size(), 63U);
        const SliceAxes axes = sliceAxes(plane);
        for (int y = 0; y < 7; ++y)
            for (int x = 0; x < 9; ++x) {
                const glm::dvec3 mm = request.middleMm + (axes.right * (x - 4.0) + axes.down * (y - 3.0)) * 0.5;
                EXPECT_NEAR(values[static_cast<std::size_t>(y * 9 + x)], expected(*volume, mm), 1e-3);
            }
    }
}

TEST(Slice, OutsideTheScanThereIsNothing) {
    const auto volume = ramp();
    Task task;
    // The box reaches from -6 to 10 mm along x: half a voxel past the outer centres.
    const SliceRequest request{SlicePlane::axial, {-6, 8, 20}, 1, {5, 1}};
    const std::vector<float> values = sliceThrough(*volume, request, task);
    EXPECT_TRUE(std::isnan(values[0]));
    EXPECT_TRUE(std::isnan(values[1]));
    EXPECT_FALSE(std::isnan(values[2]));
    EXPECT_FALSE(std::isnan(values[4]));
}

TEST(Slice, ACancelledOneThrows) {
    Task task;
    task.cancel();
    EXPECT_THROW(sliceThrough(*ramp(), {SlicePlane::axial, {0, 8, 20}, 1, {5, 5}}, task), Error);
}

} // namespace
} // namespace limner
