#include "renderer/plan/lenses.h"

#include "support/rendering.h"
#include "support/transfer_scenes.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <random>

namespace limner {
namespace {

Lens lensOf(const std::string& kind, const std::string& shape = "circle") {
    Lens lens;
    lens.kind = kind;
    lens.shape = shape;
    lens.radius = 0.2;
    return lens;
}

PlanLens placed(const Lens& lens, glm::dvec2 centre = {0.5, 0.5}) { return {lens, centre, true}; }

TEST(Lenses, AreOfTheirShape) {
    Lens ellipse = lensOf("circular", "ellipse");
    ellipse.aspect = 2;
    EXPECT_DOUBLE_EQ(lensDistance(ellipse, {0.4, 0}), 1);
    EXPECT_DOUBLE_EQ(lensDistance(ellipse, {0, -0.2}), 1);
    ellipse.angleDeg = 90;
    EXPECT_NEAR(lensDistance(ellipse, {0.2, 0}), 1, 1e-15);
    ellipse.angleDeg = 30; // counter-clockwise on the picture, whose second axis runs down
    EXPECT_NEAR(lensDistance(ellipse, {0.4 * std::cos(M_PI / 6), -0.4 * std::sin(M_PI / 6)}), 1, 1e-14);
    const Lens box = lensOf("circular", "box");
    EXPECT_DOUBLE_EQ(lensDistance(box, {0.2, 0}), 1);
    EXPECT_NEAR(lensDistance(box, {0.2, 0.2}), std::pow(2, 0.25), 1e-15) << "round corners";
    EXPECT_EQ(lensDistance(box, {0, 0}), 0);
}

TEST(Lenses, FadeByTheirKind) {
    const PlanLens hard[] = {placed(lensOf("circular"))};
    EXPECT_EQ(lensFactor(hard, {0.5, 0.5}), 1);
    EXPECT_EQ(lensFactor(hard, {0.69, 0.5}), 1);
    EXPECT_EQ(lensFactor(hard, {0.71, 0.5}), 0);
    PlanLens soft[] = {placed(lensOf("circular"))};
    soft[0].lens.soft = 0.5;
    EXPECT_EQ(lensFactor(soft, {0.59, 0.5}), 1);
    EXPECT_NEAR(lensFactor(soft, {0.65, 0.5}), 0.5, 1e-12);
    const PlanLens gaussian[] = {placed(lensOf("gaussian"))}; // radius = 2 sigma
    EXPECT_NEAR(lensFactor(gaussian, {0.6, 0.5}), std::exp(-0.5), 1e-12);
    EXPECT_NEAR(lensFactor(gaussian, {0.5, 0.7}), std::exp(-2), 1e-12);
}

TEST(Lenses, AScreenIsDotsOfTheGaussiansDensity) {
    PlanLens screen[] = {placed(lensOf("screendoor"))};
    screen[0].lens.cell = 0.002;
    const PlanLens gaussian[] = {placed(lensOf("gaussian"))};
    double dots = 0;
    double density = 0;
    for (double y = 0.501; y < 0.7; y += 0.002) {
        for (double x = 0.501; x < 0.7; x += 0.002) {
            const double factor = lensFactor(screen, {x, y});
            EXPECT_TRUE(factor == 0 || factor == 1);
            dots += factor;
            density += lensFactor(gaussian, {x, y});
        }
    }
    EXPECT_NEAR(dots / density, 1, 0.02);
}

TEST(Lenses, TakeTheGreatestOfTheirFactors) {
    PlanLens two[] = {placed(lensOf("circular"), {0.4, 0.5}), placed(lensOf("circular"), {0.6, 0.5})};
    two[0].lens.inside = 0.5;
    two[1].lens.inside = 2;
    two[0].lens.outside = 0.25;
    EXPECT_EQ(lensFactor(two, {0.25, 0.5}), 0.5);
    EXPECT_EQ(lensFactor(two, {0.5, 0.5}), 2);
    EXPECT_EQ(lensFactor(two, {0.95, 0.5}), 0.25);
    EXPECT_EQ(lensFactor({}, {0.3, 0.3}), 1) << "without lenses importance acts everywhere";
}

TEST(Lenses, MissOnlyWhatTheyDoNotReach) {
    std::mt19937 random(7);
    const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
    int missed = 0;
    for (int round = 0; round < 2000; ++round) {
        Lens lens = lensOf(round % 2 == 0 ? "circular" : "gaussian", round % 3 == 0 ? "box" : "ellipse");
        lens.radius = 0.02 + 0.1 * unit();
        lens.aspect = 0.3 + 2 * unit();
        lens.angleDeg = 360 * unit();
        const PlanLens one[] = {placed(lens, {unit(), unit()})};
        const glm::dvec2 low(unit(), unit());
        if (lensesMiss(one, low, low + 0.1)) {
            ++missed;
            for (int k = 0; k < 20; ++k) {
                ASSERT_EQ(lensFactor(one, low + 0.1 * glm::dvec2(unit(), unit())), 0);
            }
        }
    }
    EXPECT_GT(missed, 200);
    EXPECT_FALSE(lensesMiss({}, {0, 0}, {1, 1}));
}

/// Plan of the smooth scene with one lens on a point of the volume.
std::shared_ptr<const RenderPlan> anchored(Projection projection, const glm::dvec3& direction, glm::ivec2 size,
                                           const glm::dvec3& anchor) {
    testing::SmoothScene scene;
    scene.projection = projection;
    Figure figure = testing::smoothFigure(scene);
    figure.camera.direction = direction;
    figure.importance.emplace();
    figure.importance->weights.intensity = 1;
    Lens lens;
    lens.anchorMm = anchor;
    figure.importance->lenses = {lens};
    PlanRequest request;
    request.size = size;
    return testing::planOf(figure, request);
}

TEST(Lenses, OnAPointOfTheVolumeFollowIt) {
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
        for (const glm::dvec3 direction : {glm::dvec3(0, 1, 0), glm::dvec3(0.7, 0.3, -0.4)}) {
            const auto plan = anchored(projection, direction, {80, 40}, {3, -4, 5});
            const PlanLens& lens = plan->importance->lenses.front();
            const glm::dvec2 pixel = lens.centre * 40.0;
            // The ray through the lens's middle passes through the point.
            const RayFrame& rays = plan->rays;
            const glm::dvec3 across = pixel.x * rays.rightVoxel + pixel.y * rays.downVoxel;
            const glm::dvec3 origin = rays.originVoxel + (rays.perspective ? glm::dvec3(0) : across);
            const glm::dvec3 along = glm::normalize(rays.forwardVoxel + (rays.perspective ? across : glm::dvec3(0)));
            const glm::dvec3 to = plan->volume->grid().voxelFromMm({3, -4, 5}) - origin;
            EXPECT_LT(glm::length(to - glm::dot(to, along) * along), 1e-9);
            const auto poster = anchored(projection, direction, {800, 400}, {3, -4, 5});
            EXPECT_LT(glm::distance(poster->importance->lenses.front().centre, lens.centre), 1e-12)
                << "a poster shows the same lens";
        }
    }
    const auto behind = anchored(Projection::perspective, {0, 1, 0}, {80, 40}, {0, -1e5, 0});
    EXPECT_FALSE(behind->importance->lenses.front().seen);
}

} // namespace
} // namespace limner
