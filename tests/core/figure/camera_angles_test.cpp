#include "core/figure/camera_angles.h"

#include "core/figure/camera_moves.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <random>

namespace limner {
namespace {

void expectAngles(const Camera& camera, double turn, double tilt, double roll) {
    const ViewAngles angles = viewAngles(camera);
    EXPECT_NEAR(angles.turnDeg, turn, 1e-9);
    EXPECT_NEAR(angles.tiltDeg, tilt, 1e-9);
    EXPECT_NEAR(angles.rollDeg, roll, 1e-9);
}

/// Directions in LPS: x to the patient's left, y to the back, z to the head.
TEST(ViewAngles, NameTheStandardViews) {
    expectAngles({.direction = {0, 1, 0}, .up = {0, 0, 1}}, 0, 0, 0);      // before the face
    expectAngles({.direction = {-1, 0, 0}, .up = {0, 0, 1}}, 90, 0, 0);    // at the patient's left
    expectAngles({.direction = {1, 0, 0}, .up = {0, 0, 1}}, -90, 0, 0);    // at the right
    expectAngles({.direction = {0, 0, -1}, .up = {0, -1, 0}}, 180, 90, 0); // above, nose up in the picture
    expectAngles({.direction = {0, 0, -1}, .up = {0, 1, 0}}, 0, 90, 0);    // above, as one tilts there from the front
    expectAngles({.direction = {0, 0, 1}, .up = {0, -1, 0}}, 0, -90, 0);
}

TEST(ViewAngles, ARollLeansThePictureToItsLeft) {
    const Camera camera = withViewAngles({}, {0, 0, 30});
    EXPECT_NEAR(glm::length(camera.up), 1, 1e-12);
    // Seen from the front the picture's right is the patient's left (+x): up leans to the picture's left.
    EXPECT_NEAR(camera.up.x, -0.5, 1e-12);
    expectAngles(camera, 0, 0, 30);
}

TEST(ViewAngles, ComeBackFromTheCameraTheyMake) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> full(-179, 179);
    std::uniform_real_distribution<double> half(-89, 89);
    for (int i = 0; i < 200; ++i) {
        const ViewAngles asked{full(random), half(random), full(random)};
        const Camera camera = withViewAngles({.targetMm = {1, 2, 3}, .heightMm = 77}, asked);
        EXPECT_NEAR(glm::dot(camera.direction, camera.up), 0, 1e-12);
        EXPECT_EQ(camera.targetMm, glm::dvec3(1, 2, 3));
        EXPECT_EQ(camera.heightMm, 77);
        const ViewAngles back = viewAngles(camera);
        EXPECT_NEAR(back.turnDeg, asked.turnDeg, 1e-7);
        EXPECT_NEAR(back.tiltDeg, asked.tiltDeg, 1e-7);
        EXPECT_NEAR(back.rollDeg, asked.rollDeg, 1e-7);
    }
}

} // namespace
} // namespace limner
