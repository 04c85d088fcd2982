#include "core/figure/camera_moves.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <random>

namespace limner {
namespace {

constexpr double kRounding = 1e-9; // double precision through a few rotations

Camera looking(const glm::dvec3& direction, const glm::dvec3& up) {
    Camera camera;
    camera.direction = direction;
    camera.up = up;
    return camera;
}

/// Picture offset of a point: heights from the middle, y down.
glm::dvec2 projected(const Camera& camera, const glm::dvec3& mm) {
    const CameraFrame frame = cameraFrame(camera);
    const glm::dvec3 d = (mm - camera.targetMm) / camera.heightMm;
    return {glm::dot(d, frame.right), -glm::dot(d, frame.up)};
}

struct LetterCase {
    glm::dvec3 direction;
    glm::dvec3 up;
    EdgeLetters letters;
};

class OrientationLetters : public ::testing::TestWithParam<LetterCase> {};

TEST_P(OrientationLetters, AreWhatLiesThere) {
    const LetterCase& c = GetParam();
    EXPECT_EQ(edgeLetters(looking(c.direction, c.up)), c.letters);
}

// Written down by hand from the rule "x to the left, y to the back, z up; right = direction x up".
INSTANTIATE_TEST_SUITE_P(
    SixSidesUprightAndTurned, OrientationLetters,
    ::testing::Values(LetterCase{{0, 1, 0}, {0, 0, 1}, {"R", "L", "S", "I"}},   // anterior
                      LetterCase{{0, -1, 0}, {0, 0, 1}, {"L", "R", "S", "I"}},  // posterior
                      LetterCase{{-1, 0, 0}, {0, 0, 1}, {"A", "P", "S", "I"}},  // from the left
                      LetterCase{{1, 0, 0}, {0, 0, 1}, {"P", "A", "S", "I"}},   // from the right
                      LetterCase{{0, 0, -1}, {0, -1, 0}, {"L", "R", "A", "P"}}, // from above, face up
                      LetterCase{{0, 0, 1}, {0, -1, 0}, {"R", "L", "A", "P"}},  // from below: the radiologist's axial
                      LetterCase{{0, 1, 0}, {0, 0, -1}, {"L", "R", "I", "S"}},  // upside down
                      LetterCase{{0, 1, 0}, {1, 0, 0}, {"S", "I", "L", "R"}},   // lying on a side
                      LetterCase{{0, 1, 0}, {-1, 0, 0}, {"I", "S", "R", "L"}},
                      LetterCase{{0, 0, -1}, {0, 1, 0}, {"R", "L", "P", "A"}},
                      LetterCase{{0, 0, 1}, {0, 1, 0}, {"L", "R", "P", "A"}},
                      LetterCase{{1, 0, 0}, {0, 1, 0}, {"I", "S", "P", "A"}}));

const double kS = std::sqrt(0.5);
INSTANTIATE_TEST_SUITE_P(
    Oblique, OrientationLetters,
    ::testing::Values(
        // From the front left of the patient: the picture's right is his left and back.
        LetterCase{{-kS, kS, 0}, {0, 0, 1}, {"RA", "LP", "S", "I"}},
        LetterCase{{kS, kS, 0}, {0, 0, 1}, {"RP", "LA", "S", "I"}},
        // Ten degrees off stays plain, twenty does not.
        LetterCase{{-0.17365, 0.98481, 0}, {0, 0, 1}, {"R", "L", "S", "I"}},
        LetterCase{{-0.34202, 0.93969, 0}, {0, 0, 1}, {"RA", "LP", "S", "I"}},
        // Tilted down from the front: up is superior and anterior.
        LetterCase{{0, kS, -kS}, {0, 0, 1}, {"R", "L", "PS", "AI"}},
        LetterCase{{0, 0.93969, -0.34202}, {0, 0, 1}, {"R", "L", "SP", "IA"}},
        // Scale and a sloping up make no difference.
        LetterCase{{0, 7, 0}, {0, 5, 0.1}, {"R", "L", "S", "I"}},
        // Up along the direction: some frame, no crash; the edges stay opposite pairs of the other two axes.
        LetterCase{{0, 0, -1}, {0, 0, 1}, {"L", "R", "A", "P"}}));

/// A patient is never mirrored: a marker at his left, in any grid, lies towards the edge that says L.
struct GridCase {
    const char* name;
    glm::dmat3 direction; ///< columns: i, j, k in LPS
};

class LettersAndGrids : public ::testing::TestWithParam<GridCase> {};

TEST_P(LettersAndGrids, MarkersLieWhereTheLettersSay) {
    Grid grid;
    grid.dims = {40, 50, 60};
    grid.spacingMm = {0.7, 0.9, 1.3};
    grid.direction = GetParam().direction;
    grid.originMm = {12, -7, 30};
    // The voxels that lie furthest to the patient's left, back and top, found through the grid itself.
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 best = grid.mmFromVoxel({0, 0, 0});
        for (int corner = 1; corner < 8; ++corner) {
            const glm::dvec3 mm =
                grid.mmFromVoxel(glm::dvec3(39 * (corner & 1), 49 * (corner >> 1 & 1), 59 * (corner >> 2 & 1)));
            if (mm[axis] > best[axis])
                best = mm;
        }
        glm::dvec3 marker = grid.centreMm();
        marker[axis] = best[axis];
        Camera front = looking({0, 1, 0}, {0, 0, 1});
        front.targetMm = grid.centreMm();
        Camera above = looking({0, 0, -1}, {0, -1, 0});
        above.targetMm = grid.centreMm();
        const char letter = "LPS"[axis];
        for (const Camera& camera : {front, above}) {
            const EdgeLetters letters = edgeLetters(camera);
            const glm::dvec2 at = projected(camera, marker);
            const std::string towards = std::abs(at.x) > std::abs(at.y) ? (at.x > 0 ? letters.right : letters.left)
                                                                        : (at.y > 0 ? letters.bottom : letters.top);
            if (glm::length(at) > 1e-6) { // else it lies along the view
                EXPECT_EQ(towards, std::string(1, letter)) << GetParam().name;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, LettersAndGrids,
                         ::testing::Values(GridCase{"straight", glm::dmat3(1)},
                                           GridCase{"mirrored x", glm::dmat3(-1, 0, 0, 0, 1, 0, 0, 0, 1)},
                                           GridCase{"feet first", glm::dmat3(1, 0, 0, 0, 1, 0, 0, 0, -1)},
                                           GridCase{"coronal slices", glm::dmat3(1, 0, 0, 0, 0, -1, 0, 1, 0)},
                                           GridCase{"oblique", glm::dmat3(0.8, 0.6, 0, -0.6, 0.8, 0, 0, 0, 1)},
                                           GridCase{"oblique and mirrored",
                                                    glm::dmat3(0.8, 0, 0.6, 0, -1, 0, -0.6, 0, 0.8)}));

TEST(CameraFrame, IsOrthonormalWhateverIsGiven) {
    for (const Camera& camera : {looking({0, 0, 0}, {0, 0, 0}), looking({0, 0, 3}, {0, 0, 5}),
                                 looking({1, 2, 3}, {-3, 1, 9}), looking({0, 1, 0}, {0, 0, 0})}) {
        const CameraFrame f = cameraFrame(camera);
        EXPECT_NEAR(glm::length(f.right), 1, kRounding);
        EXPECT_NEAR(glm::length(f.up), 1, kRounding);
        EXPECT_NEAR(glm::length(f.forward), 1, kRounding);
        EXPECT_NEAR(glm::dot(f.right, f.up), 0, kRounding);
        EXPECT_NEAR(glm::length(f.right - glm::cross(f.forward, f.up)), 0, kRounding);
    }
}

TEST(CameraMoves, TheFrontFollowsThePointer) {
    const Camera start = looking({0.3, 1, -0.2}, {0, 0, 1});
    const CameraFrame frame = cameraFrame(start);
    const glm::dvec3 front = start.targetMm - frame.forward * 50.0; // towards the viewer
    for (const TurnMode mode : {TurnMode::turntable, TurnMode::trackball}) {
        EXPECT_GT(projected(turned(start, mode, {0, 0}, {0.05, 0}), front).x, 0.001);
        EXPECT_LT(projected(turned(start, mode, {0, 0}, {-0.05, 0}), front).x, -0.001);
        EXPECT_GT(projected(turned(start, mode, {0, 0}, {0, 0.05}), front).y, 0.001);
        EXPECT_LT(projected(turned(start, mode, {0, 0}, {0, -0.05}), front).y, -0.001);
    }
}

TEST(CameraMoves, TheTableFollowsThePointerUpsideDownToo) {
    const Camera start = looking({0, 1, 0}, {0, 0, -1});
    const glm::dvec3 front = start.targetMm - glm::dvec3(0, 50, 0);
    EXPECT_GT(projected(turned(start, TurnMode::turntable, {0, 0}, {0.05, 0}), front).x, 0.001);
    EXPECT_GT(projected(turned(start, TurnMode::turntable, {0, 0}, {0, 0.05}), front).y, 0.001);
}

TEST(CameraMoves, TheTableKeepsTheHorizon) {
    Camera camera = looking({0, 1, 0}, {0, 0, 1});
    std::mt19937 random(3);
    std::uniform_real_distribution<double> by(-0.1, 0.1);
    for (int i = 0; i < 200; ++i) {
        camera = turned(camera, TurnMode::turntable, {0, 0}, {by(random), by(random)});
        EXPECT_NEAR(cameraFrame(camera).right.z, 0, kRounding);
    }
}

TEST(CameraMoves, AWholeTurnComesBack) {
    Camera camera = looking({0, 1, 0}, {0, 0, 1});
    for (int i = 0; i < 40; ++i) // half a turn per height, so two heights in all
        camera = turned(camera, TurnMode::turntable, {0, 0}, {0.05, 0});
    EXPECT_NEAR(glm::length(camera.direction - glm::dvec3(0, 1, 0)), 0, kRounding);
}

TEST(CameraMoves, TheBallTurnsBackOnTheSameWay) {
    const Camera start = looking({0.5, 0.7, 0.1}, {0.1, 0, 1});
    const Camera there = turned(start, TurnMode::trackball, {0.1, -0.05}, {-0.3, 0.25});
    const Camera back = turned(there, TurnMode::trackball, {-0.3, 0.25}, {0.1, -0.05});
    EXPECT_NEAR(glm::length(cameraFrame(back).forward - cameraFrame(start).forward), 0, kRounding);
    EXPECT_NEAR(glm::length(cameraFrame(back).up - cameraFrame(start).up), 0, kRounding);
}

TEST(CameraMoves, PanningCarriesThePointUnderThePointer) {
    Camera camera = looking({0.4, 0.8, -0.2}, {0, 0, 1});
    camera.targetMm = {5, 6, 7};
    const glm::dvec3 mm = camera.targetMm + cameraFrame(camera).right * 31.0 - cameraFrame(camera).up * 12.0;
    const glm::dvec2 before = projected(camera, mm);
    const glm::dvec2 after = projected(panned(camera, {0.2, -0.1}), mm);
    EXPECT_NEAR(after.x - before.x, 0.2, kRounding);
    EXPECT_NEAR(after.y - before.y, -0.1, kRounding);
}

TEST(CameraMoves, ZoomingKeepsThePointUnderThePointer) {
    Camera camera = looking({0.4, 0.8, -0.2}, {0, 0, 1});
    const glm::dvec3 mm = camera.targetMm + cameraFrame(camera).right * 60.0 + cameraFrame(camera).up * 25.0;
    const glm::dvec2 at = projected(camera, mm);
    const Camera closer = zoomed(camera, 0.5, at);
    EXPECT_NEAR(closer.heightMm, camera.heightMm / 2, kRounding);
    EXPECT_NEAR(glm::length(projected(closer, mm) - at), 0, kRounding);
    const Camera back = zoomed(closer, 2, at);
    EXPECT_NEAR(glm::length(back.targetMm - camera.targetMm), 0, 1e-6); // mm
}

TEST(CameraMoves, ZoomingNeverReachesZeroOrInfinity) {
    Camera camera;
    for (int i = 0; i < 1000; ++i)
        camera = zoomed(camera, 0.5, {0.3, 0.3});
    EXPECT_GT(camera.heightMm, 0);
    for (int i = 0; i < 1000; ++i)
        camera = zoomed(camera, 2, {0.3, 0.3});
    EXPECT_TRUE(std::isfinite(camera.heightMm));
    EXPECT_TRUE(std::isfinite(camera.targetMm.x));
}

} // namespace
} // namespace limner
