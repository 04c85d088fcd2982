#include "core/volume/cleanup.h"

#include "core/base/error.h"
#include "core/figure/view_frame.h"
#include "support/make_volume.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <functional>

namespace limner {
namespace {

using testing::gridOf;
using testing::makeVolume;
using VolumePointer = std::shared_ptr<const Volume>;

VolumePointer ct(const Grid& grid, const std::function<double(glm::ivec3)>& hu) {
    return makeVolume<std::int16_t>(grid, VoxelType::int16, hu);
}

VolumePointer clean(const VolumePointer& volume, const CleanupStep& step, const Volume* labels = nullptr) {
    Task task;
    return applyCleanup(volume, labels, {step}, 1, task);
}

CleanupStep keepLargestAbove(double above, double openingMm = 0) {
    CleanupStep step;
    step.above = above;
    step.openingMm = openingMm;
    return step;
}

double ball(glm::ivec3 v, glm::dvec3 centre, double radius) { return glm::distance(glm::dvec3(v), centre) - radius; }

/// A soft edge two voxels wide from 100 (inside) to -1000.
double edge(double distance) { return -450 - 550 * std::clamp(distance, -1.0, 1.0); }

TEST(Cleanup, NothingToDoGivesTheSameVolume) {
    const auto volume = ct(gridOf({8, 8, 8}), [](glm::ivec3 v) { return v.x > 3 ? 100 : -1000; });
    Task task;
    EXPECT_EQ(applyCleanup(volume, nullptr, {}, 1, task), volume);
    EXPECT_EQ(clean(volume, keepLargestAbove(0)), volume);
    EXPECT_EQ(clean(volume, keepLargestAbove(5000)), volume);
}

TEST(Cleanup, KeepLargestTakesTheRimOfWhatGoesAndLeavesTheRest) {
    const auto volume = ct(gridOf({60, 40, 40}), [](glm::ivec3 v) {
        return std::max(edge(ball(v, {20, 20, 20}, 12)), edge(ball(v, {48, 20, 20}, 6)));
    });
    const auto cleaned = clean(volume, keepLargestAbove(-300));
    ASSERT_NE(cleaned, volume);
    EXPECT_EQ(cleaned->range(), volume->range());
    for (int z = 0; z < 40; ++z) {
        for (int y = 0; y < 40; ++y) {
            for (int x = 0; x < 60; ++x) {
                const glm::ivec3 v(x, y, z);
                if (ball(v, {20, 20, 20}, 12) < 2) {
                    ASSERT_EQ(cleaned->valueAt(v), volume->valueAt(v)) << x << ' ' << y << ' ' << z;
                } else {
                    ASSERT_EQ(cleaned->valueAt(v), -1000) << x << ' ' << y << ' ' << z;
                }
            }
        }
    }
}

TEST(Cleanup, KeepLargestReadsFallingNumbers) { // MONOCHROME1: value = -stored
    const auto volume = makeVolume<std::int16_t>(
        gridOf({30, 5, 5}), VoxelType::int16,
        [](glm::ivec3 v) { return v.x < 20 && v.x > 2 ? -100
                                  : v.x > 25          ? -100
                                                      : 1000; }, -1, 0);
    const auto cleaned = clean(volume, keepLargestAbove(0));
    EXPECT_EQ(cleaned->valueAt({28, 2, 2}), -1000);
    EXPECT_EQ(cleaned->valueAt({10, 2, 2}), 100);
}

/// A head-like ball that rests in a shell two voxels thick, which runs through all slices and touches it, and has thin
/// ears.
double headInRest(glm::ivec3 v) {
    double d = ball(v, {60, 60, 50}, 40);
    d = std::min(d, std::max(std::abs(v.x - 60) - 50.0, std::abs(v.z - 50) - 6.0) + (std::abs(v.y - 60) > 1 ? 50 : 0));
    const double rest = std::abs(glm::length(glm::dvec2(v.x - 60, v.y - 40)) - 61) - 1;
    return edge(v.y > 40 ? std::min(d, rest) : d);
}

TEST(Cleanup, OpeningCutsOffTheHeadrestButNotTheEars) {
    const auto volume = ct(gridOf({128, 128, 100}), headInRest);
    const auto plain = clean(volume, keepLargestAbove(-300));
    EXPECT_GT(plain->valueAt({60, 101, 5}), 0) << "the headrest touches: plain connection keeps it";
    const auto opened = clean(volume, keepLargestAbove(-300, 3));
    EXPECT_EQ(opened->valueAt({60, 101, 5}), -1000);
    EXPECT_EQ(opened->valueAt({60 + 43, 40 + 43, 50}), -1000);
    EXPECT_GT(opened->valueAt({60 + 48, 60, 50}), 0) << "an ear";
    EXPECT_GT(opened->valueAt({60 - 48, 60, 50}), 0) << "the other";
    EXPECT_GT(opened->valueAt({60, 60, 12}), 0);
}

TEST(Cleanup, OpeningLeavesANoseThatIsThickAtItsTip) {
    // A ball for a head; a tip with a grain of an inside, on a thin neck; and a block as large as a third of the head.
    const auto volume = ct(gridOf({128, 128, 80}), [](glm::ivec3 v) {
        const double neck = std::max(glm::length(glm::dvec2(v.x - 60, v.z - 40)) - 2, std::abs(v.y - 20) - 16.0);
        const double tip = ball(v, {60, 8, 40}, 5.5);
        const double joint = std::max(glm::length(glm::dvec2(v.x - 60, v.z - 40)) - 2, std::abs(v.y - 92) - 6.0);
        const double block =
            std::max({std::abs(v.x - 60) - 50.0, std::abs(v.y - 108) - 10.0, std::abs(v.z - 40) - 30.0});
        return edge(std::min({ball(v, {60, 60, 40}, 32), neck, tip, joint, block}));
    });
    const auto opened = clean(volume, keepLargestAbove(-300, 3));
    EXPECT_GT(opened->valueAt({60, 60, 40}), 0);
    EXPECT_GT(opened->valueAt({60, 8, 40}), 0) << "the tip of the nose";
    EXPECT_EQ(opened->valueAt({30, 108, 40}), -1000) << "something else that touches";
}

TEST(Cleanup, KeepAtKeepsTheIslandOfThePoint) {
    Grid grid = gridOf({60, 20, 20});
    grid.spacingMm = {2, 1, 1};
    grid.originMm = {-50, 10, 5};
    const auto volume = ct(grid, [](glm::ivec3 v) { return v.x < 30 || v.x > 40 ? 100 : -1000; });
    CleanupStep step;
    step.kind = CleanupKind::keepAt;
    step.above = 0;
    step.atMm = grid.mmFromVoxel({39, 10, 10}); // beside the smaller island: a click lands on a surface
    const auto cleaned = clean(volume, step);
    EXPECT_EQ(cleaned->valueAt({50, 10, 10}), 100);
    EXPECT_EQ(cleaned->valueAt({10, 10, 10}), -1000);
    step.atMm = glm::dvec3(1e6, 0, 0);
    Task task;
    EXPECT_EQ(applyCleanup(volume, nullptr, {step}, 1, task), volume);
    EXPECT_EQ(task.warnings().size(), 1U);
}

TEST(Cleanup, RemoveIslandsGoesByCubicMillimetres) {
    Grid grid = gridOf({40, 10, 10});
    grid.spacingMm = {1, 2, 0.5}; // 1 mm3 a voxel
    const auto volume = ct(grid, [](glm::ivec3 v) {
        const bool small = v.x >= 2 && v.x < 4 && v.y < 5 && v.z < 5;   // 50 mm3
        const bool large = v.x >= 10 && v.x < 12 && v.y < 5 && v.z < 6; // 60 mm3
        return small || large ? 100 : 0;
    });
    CleanupStep step;
    step.kind = CleanupKind::removeIslands;
    step.above = 50;
    step.belowMm3 = 55;
    const auto cleaned = clean(volume, step);
    EXPECT_EQ(cleaned->valueAt({3, 2, 2}), 0);
    EXPECT_EQ(cleaned->valueAt({11, 2, 2}), 100);
    step.belowMm3 = 50;
    EXPECT_EQ(clean(volume, step), volume) << "an island of just that size stays";
}

TEST(Cleanup, EraseLabelOnAnotherGrid) {
    const auto volume = ct(gridOf({32, 16, 16}), [](glm::ivec3) { return 100; });
    Grid coarse = gridOf({16, 8, 8});
    coarse.spacingMm = glm::dvec3(2);
    coarse.originMm = glm::dvec3(0.5);
    const auto labels = makeVolume<std::uint8_t>(coarse, VoxelType::uint8, [](glm::ivec3 v) {
        return v.x < 4 ? 1 : v.x < 8 ? 2 : 0;
    });
    CleanupStep step;
    step.kind = CleanupKind::eraseLabel;
    step.label = 2;
    // Lowest of a constant volume is its value: give it a floor.
    const auto withFloor = ct(volume->grid(), [](glm::ivec3 v) { return v.z == 0 && v.x == 31 ? -1000 : 100; });
    const auto cleaned = clean(withFloor, step, labels.get());
    EXPECT_EQ(cleaned->valueAt({7, 8, 8}), 100);   // label 1 is kept to its last voxel
    EXPECT_EQ(cleaned->valueAt({8, 8, 8}), -1000); // label 2
    EXPECT_EQ(cleaned->valueAt({15, 8, 8}), -1000);
    EXPECT_EQ(cleaned->valueAt({17, 8, 8}), -1000); // its rim in unlabelled matter
    EXPECT_EQ(cleaned->valueAt({18, 8, 8}), 100);
    Task task;
    EXPECT_EQ(applyCleanup(withFloor, nullptr, {step}, 1, task), withFloor);
    EXPECT_EQ(task.warnings().size(), 1U);
}

/// An oblique grid with a floor of -1000 in one corner and 100 elsewhere.
VolumePointer obliqueBlock() {
    Grid grid = gridOf({40, 36, 30});
    grid.spacingMm = {1, 1.5, 2};
    const glm::dmat4 turn = glm::rotate(glm::rotate(glm::dmat4(1), 0.5, glm::dvec3(1, 0, 0)), 0.3, glm::dvec3(0, 0, 1));
    grid.direction = glm::dmat3(turn);
    grid.direction[2] *= -1.0; // left-handed
    grid.originMm = {-10, 20, 30};
    return ct(grid, [](glm::ivec3 v) { return v == glm::ivec3(0) ? -1000 : 100; });
}

bool insideTriangle(const glm::dvec2& p, const std::vector<glm::dvec2>& t) {
    const auto side = [&](int a, int b) {
        return (t[b].x - t[a].x) * (p.y - t[a].y) - (t[b].y - t[a].y) * (p.x - t[a].x) > 0;
    };
    return side(0, 1) == side(1, 2) && side(1, 2) == side(2, 0);
}

void checkScissors(Projection projection, ScissorsSide side, const glm::dvec3& direction) {
    const auto volume = obliqueBlock();
    CleanupStep step;
    step.kind = CleanupKind::scissors;
    step.polygon = {{0.3, 0.2}, {0.8, 0.45}, {0.4, 0.9}};
    step.side = side;
    Camera camera;
    camera.projection = projection;
    camera.targetMm = volume->grid().centreMm();
    camera.direction = direction;
    camera.up = {0.1, 0, 1};
    camera.heightMm = 70;
    camera.fovDeg = 40;
    step.camera = camera;
    constexpr double aspect = 1.5;
    Task task;
    const auto cleaned = applyCleanup(volume, nullptr, {step}, aspect, task);
    // The test's own projection, from the definition: picture's right = direction x up, y downward.
    const glm::dvec3 forward = glm::normalize(direction);
    const glm::dvec3 right = glm::normalize(glm::cross(direction, camera.up));
    const glm::dvec3 up = glm::cross(right, forward);
    const double distance = 35 / std::tan(20 * 3.14159265358979 / 180);
    std::size_t cut = 0;
    const glm::ivec3 dims = volume->grid().dims;
    for (int z = 0; z < dims.z; ++z) {
        for (int y = 0; y < dims.y; ++y) {
            for (int x = 0; x < dims.x; ++x) {
                const glm::dvec3 p = volume->grid().mmFromVoxel({x, y, z}) - camera.targetMm;
                const double depth = projection == Projection::perspective ? 1 + glm::dot(p, forward) / distance : 1;
                if (depth <= 0 || (x == 0 && y == 0 && z == 0)) {
                    continue;
                }
                const glm::dvec2 at(0.5 + glm::dot(p, right) / (70 * aspect * depth),
                                    0.5 - glm::dot(p, up) / (70 * depth));
                const bool expected = insideTriangle(at, step.polygon) == (side == ScissorsSide::inside);
                ASSERT_EQ(cleaned->valueAt({x, y, z}), expected ? -1000 : 100) << x << ' ' << y << ' ' << z;
                cut += expected ? 1 : 0;
            }
        }
    }
    EXPECT_GT(cut, 1000U);
    EXPECT_LT(cut, volume->grid().voxelCount() - 1000);
}

TEST(Cleanup, ScissorsOrthographicOnAnObliqueGrid) {
    checkScissors(Projection::orthographic, ScissorsSide::inside, {0.3, 1, -0.2});
    checkScissors(Projection::orthographic, ScissorsSide::outside, {0.3, 1, -0.2});
}

TEST(Cleanup, ScissorsPerspectiveOnAnObliqueGrid) {
    checkScissors(Projection::perspective, ScissorsSide::inside, {-1, 0.4, 0.3});
    checkScissors(Projection::perspective, ScissorsSide::outside, {0.2, 1, 0.5});
}

TEST(Cleanup, ScissorsAlongTheRowsOfTheGrid) {
    const auto volume = ct(gridOf({20, 10, 10}), [](glm::ivec3 v) { return v == glm::ivec3(0) ? -1000 : 100; });
    CleanupStep step;
    step.kind = CleanupKind::scissors;
    step.polygon = {{0, 0}, {1, 0}, {1, 0.5}, {0, 0.5}}; // the upper half of the picture
    Camera camera;
    camera.targetMm = volume->grid().centreMm();
    camera.direction = {1, 0, 0};
    camera.heightMm = 40;
    step.camera = camera;
    const auto cleaned = clean(volume, step);
    EXPECT_EQ(cleaned->valueAt({10, 5, 4}), 100);
    EXPECT_EQ(cleaned->valueAt({10, 5, 5}), -1000);
    EXPECT_EQ(cleaned->valueAt({19, 9, 9}), -1000);
}

TEST(Cleanup, ALassoKeepsTheFormatItWasDrawnIn) {
    const auto volume = obliqueBlock();
    CleanupStep step;
    step.kind = CleanupKind::scissors;
    step.polygon = {{0.3, 0.2}, {0.8, 0.45}, {0.4, 0.9}};
    step.camera = Camera{};
    step.camera->targetMm = volume->grid().centreMm();
    step.camera->heightMm = 70;
    const auto cutIn = [&](double figureAspect) {
        Task task;
        return applyCleanup(volume, nullptr, {step}, figureAspect, task);
    };
    const auto same = [&](const VolumePointer& a, const VolumePointer& b) {
        const glm::ivec3 dims = volume->grid().dims;
        for (int z = 0; z < dims.z; ++z) {
            for (int y = 0; y < dims.y; ++y) {
                for (int x = 0; x < dims.x; ++x) {
                    if (a->valueAt({x, y, z}) != b->valueAt({x, y, z})) {
                        return false;
                    }
                }
            }
        }
        return true;
    };
    const auto wide = cutIn(1.5);
    EXPECT_FALSE(same(wide, cutIn(1)));
    step.aspect = 1.5;
    EXPECT_TRUE(same(wide, cutIn(1)));
}

TEST(Cleanup, ALassoWithoutAViewDoesNothingAndSaysSo) {
    const auto volume = obliqueBlock();
    CleanupStep step;
    step.kind = CleanupKind::scissors;
    step.polygon = {{0, 0}, {1, 0}, {1, 1}};
    Task task;
    EXPECT_EQ(applyCleanup(volume, nullptr, {step}, 1, task), volume);
    EXPECT_EQ(task.warnings().size(), 1U);
    step.camera = Camera{};
    step.polygon.pop_back();
    Task second;
    EXPECT_EQ(applyCleanup(volume, nullptr, {step}, 1, second), volume);
    EXPECT_EQ(second.warnings().size(), 1U);
}

TEST(Cleanup, StepsRunInTheirOrder) {
    // Two islands, the larger one in the upper half: cutting that away first makes the other the largest.
    const auto volume = ct(gridOf({12, 12, 20}), [](glm::ivec3 v) {
        return v.z < 6 ? 100 : v.z > 8 ? 200 : v == glm::ivec3(0, 0, 7) ? -1000 : -900;
    });
    CleanupStep cut;
    cut.kind = CleanupKind::scissors;
    cut.polygon = {{-1, -1}, {2, -1}, {2, 0.5}, {-1, 0.5}};
    cut.camera = Camera{};
    cut.camera->targetMm = {5.5, 5.5, 7.5};
    cut.camera->heightMm = 60;
    Task task;
    const auto cutFirst = applyCleanup(volume, nullptr, {cut, keepLargestAbove(0)}, 1, task);
    EXPECT_EQ(cutFirst->valueAt({5, 5, 3}), 100);
    EXPECT_EQ(cutFirst->valueAt({5, 5, 15}), -1000);
    const auto keptFirst = applyCleanup(volume, nullptr, {keepLargestAbove(0), cut}, 1, task);
    EXPECT_EQ(keptFirst->valueAt({5, 5, 3}), -1000);
    EXPECT_EQ(keptFirst->valueAt({5, 5, 15}), -1000);
}

TEST(Cleanup, ADegenerateCameraIsAnError) {
    CleanupStep step;
    step.kind = CleanupKind::scissors;
    step.polygon = {{0, 0}, {1, 0}, {1, 1}};
    step.camera = Camera{};
    step.camera->up = step.camera->direction;
    EXPECT_THROW(clean(obliqueBlock(), step), Error);
}

TEST(Cleanup, Cancels) {
    Task task;
    task.cancel();
    EXPECT_THROW(applyCleanup(obliqueBlock(), nullptr, {keepLargestAbove(0)}, 1, task), Error);
}

} // namespace
} // namespace limner
