#include "renderer/accuracy/analytic_scenes.h"
#include "renderer/reference/field.h"
#include "support/rendering.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <complex>
#include <numbers>

// Slices thicker than their pixels show as terraces on a smooth surface unless gradients make up for it.

namespace limner::accuracy {
namespace {

constexpr double kRadiusMm = 40;

/// A ball of 1 on 0 in voxels of 1 x 1 x `sliceMm`, each the mean over its own volume.
std::shared_ptr<const Volume> slicedBall(double sliceMm) {
    Grid grid;
    grid.dims = {95, 95, static_cast<int>(95 / sliceMm)};
    grid.spacingMm = {1, 1, sliceMm};
    // Off the middle, so that no voxel lies like another.
    grid.originMm = -grid.spacingMm * (glm::dvec3(grid.dims) - 1.0) / 2.0 + glm::dvec3(0.2, 0.3, 0.17);
    return sampleField(grid, [&](const glm::dvec3& mm) {
        if (std::abs(glm::length(mm) - kRadiusMm) > 0.5 * (2 + sliceMm)) {
            return glm::length(mm) < kRadiusMm ? 1.0 : 0.0;
        }
        constexpr int across = 4; // places per voxel
        const int along = static_cast<int>(across * sliceMm);
        double inside = 0;
        for (int i = 0; i < across * across * along; ++i) {
            const glm::dvec3 place((i % across + 0.5) / across - 0.5, (i / across % across + 0.5) / across - 0.5,
                                   (i / (across * across) + 0.5) / along - 0.5);
            inside += glm::length(mm + place * grid.spacingMm) <= kRadiusMm ? 1.0 / (across * across * along) : 0.0;
        }
        return inside;
    });
}

/// Over the ball's upper side as the light (0.6, 0, 0.8) falls on it.
struct Terraces {
    double harmonic = 0; ///< amplitude of the shading's error at the frequency of the slices
    double angleDeg = 0; ///< RMS error of the normals
};

Terraces terracesOf(const std::shared_ptr<const Volume>& volume, Interpolation interpolation,
                    GradientEstimator gradient) {
    Figure figure = plainFigure(volume, viewAlongZ(glm::dvec3(0), 2 * kRadiusMm));
    figure.quality.interpolation = interpolation;
    figure.quality.gradient = gradient;
    figure.layers.front().transfer.nodes = {{0, "", glm::dvec3(1)}};
    figure.layers.front().transfer.opacity = {{0.5, 1}};
    PlanRequest request;
    request.size = {8, 8};
    const auto plan = testing::planOf(figure, request);
    const Grid& grid = volume->grid();
    const glm::dvec3 light(0.6, 0, 0.8);
    constexpr int places = 4000;
    std::complex<double> harmonic = 0;
    double squares = 0;
    for (int k = 0; k < places; ++k) { // evenly over the ball from 20 to 70 degrees of latitude, by the golden angle
        const double z = 0.34 + (0.94 - 0.34) * (k + 0.5) / places;
        const double turn = k * std::numbers::pi * (3 - std::sqrt(5.0));
        const glm::dvec3 out(std::sqrt(1 - z * z) * glm::dvec2(std::cos(turn), std::sin(turn)), z);
        double low = kRadiusMm - 2;
        double high = kRadiusMm + 2;
        for (int halving = 0; halving < 20; ++halving) { // to where the value is one half
            const double middle = 0.5 * (low + high);
            (reference::valueAt(*plan, grid.voxelFromMm(middle * out)) >= 0.5 ? low : high) = middle;
        }
        const glm::dvec3 voxel = grid.voxelFromMm(low * out);
        const glm::dvec3 normal = -glm::normalize(reference::indexGradient(*plan, voxel) / grid.spacingMm);
        const double angle = std::atan2(glm::length(glm::cross(normal, out)), glm::dot(normal, out));
        squares += angle * angle;
        harmonic += glm::dot(normal - out, light) * std::polar(1.0, 2 * std::numbers::pi * voxel.z);
    }
    return {2 * std::abs(harmonic) / places, std::sqrt(squares / places) * 180 / std::numbers::pi};
}

TEST(ThickSlices, ShowNoTerracesByDefault) {
    for (const double sliceMm : {2.0, 3.0}) {
        const auto ball = slicedBall(sliceMm);
        const Terraces plain = terracesOf(ball, Interpolation::linear, GradientEstimator::central);
        const Terraces sobel = terracesOf(ball, Interpolation::automatic, GradientEstimator::sobel);
        const Terraces chosen = terracesOf(ball, Interpolation::automatic, GradientEstimator::automatic);
        EXPECT_GT(plain.harmonic, 0.01) << sliceMm;
        EXPECT_LT(chosen.harmonic, plain.harmonic / 8) << sliceMm;
        EXPECT_LT(chosen.harmonic, sobel.harmonic) << sliceMm;
        EXPECT_LT(chosen.angleDeg, plain.angleDeg / 4) << sliceMm;
    }
}

TEST(ThickSlices, AreLeftAloneWhereNothingIsAsked) {
    const auto ball = slicedBall(2);
    Figure figure = plainFigure(ball, viewAlongZ(glm::dvec3(0), 80));
    figure.layers.front().transfer.nodes = {{0, "", glm::dvec3(1)}};
    figure.layers.front().transfer.opacity = {{0.5, 1}};
    PlanRequest request;
    request.size = {8, 8};
    figure.quality.gradient = GradientEstimator::sobel;
    EXPECT_EQ(testing::planOf(figure, request)->gradientField, ball); // the user's choice is taken as it is
    figure.quality.gradient = GradientEstimator::automatic;
    EXPECT_NE(testing::planOf(figure, request)->gradientField, ball);
    EXPECT_EQ(testing::planOf(figure, request)->bendField, nullptr);
}

} // namespace
} // namespace limner::accuracy
