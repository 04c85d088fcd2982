#include "renderer/accuracy/analytic_scenes.h"
#include "renderer/reference/layer_optics.h"
#include "support/rendering.h"

#include <glm/geometric.hpp>

#include <cmath>

// Contours and the curvature they follow, against closed forms: A4's ball (accuracy.md 1.5) and a torus.

namespace limner::accuracy {
namespace {

using testing::BackendTest;
using testing::planOf;

class ContourScenes : public BackendTest {};
LIMNER_ON_EVERY_BACKEND(ContourScenes);

TEST(ContourBallForms, AreThePublishedThicknesses) {
    ContourBall ball;
    EXPECT_NEAR(ball.radiusMm - ball.innerEndMm(), 5, 1e-7);
    ball.curvature = CurvatureEstimator::normals;
    EXPECT_NEAR(ball.radiusMm - ball.innerEndMm(), 50.0 * 5 / 55, 1e-7); // 4.545455
    ball = {};
    ball.projection = Projection::perspective;
    ball.eyeMm = 1e6; // as good as orthographic
    EXPECT_NEAR(ball.rimMm() - ball.innerEndMm(), 5, 1e-3);
}

/// Mean thickness of the contour along the rows of a strip's right end: what the white leaves of the ball.
double drawnThickness(const Backend& backend, const ContourBall& ball, const RenderPlan& plan) {
    const double pixelMm = plan.rays.footprintMm;
    const int middle = plan.size.x / 2; // widths are even
    const int first = middle + static_cast<int>(0.8 * ball.innerEndMm() / pixelMm);
    const int rows = plan.size.y;
    Task task;
    const Picture strip = backend.render(plan, {{first, 0}, {plan.size.x - first, rows}}, task).picture;
    double white = first - middle;
    for (std::size_t i = 0; i < strip.rgba().size(); i += 4) {
        white += strip.rgba()[i] / rows;
    }
    return ball.rimMm() - white * pixelMm;
}

/// The same of the closed form, through the middle. The white fades smoothly at its end and is 0 at the rim, so its sum
/// over pixels is as good as an integral.
double exactThickness(const ContourBall& ball) {
    constexpr int places = 20000;
    double white = 0;
    for (int i = 0; i < places; ++i) {
        const double x = (i + 0.5) / places * ball.rimMm();
        white += ball.paper(x) * ball.rimMm() / places;
    }
    return ball.rimMm() - white;
}

TEST_P(ContourScenes, AreAsThickAsAskedAtEveryStepAndZoom) {
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
        for (const CurvatureEstimator estimator : {CurvatureEstimator::hessian, CurvatureEstimator::normals}) {
            ContourBall ball;
            ball.projection = projection;
            ball.curvature = estimator;
            for (const double pixelMm : {0.4, 0.2, 0.1}) {
                const double exact = exactThickness(ball);
                const auto request = ball.scene(1, pixelMm);
                Planner planner;
                for (const double stepMm : {1.0, 0.5, 0.25}) {
                    PlanRequest other = request.request;
                    other.lattice->stepMm = stepMm;
                    Task task;
                    RenderPlan plan = *planner.plan(request.figure, other, task);
                    plan.gradientFloor = 0; // the field has no noise
                    const double drawn = drawnThickness(backend(), ball, plan);
                    EXPECT_NEAR(drawn, exact, 0.02 * exact) << pixelMm << ' ' << stepMm;
                }
            }
        }
    }
}

TEST_P(ContourScenes, HaveOneThicknessOnPaperWhateverTheResolution) {
    // 132 mm of a ball of 100 mm on 33 mm of paper, a pen of 1.25 mm: 5 mm on the object.
    const ContourBall ball;
    AnalyticScene scene = ball.scene(0.5, 0.4);
    scene.figure.camera.heightMm = 0.4;
    scene.figure.output.widthMm = 33;
    scene.figure.output.heightMm = 0.1;
    scene.figure.layers.front().contours->thicknessMm = 1.25;
    for (const int perPaperMm : {20, 40, 80}) { // 508, 1016 and 2032 dots per inch
        scene.request.size = {33 * perPaperMm, perPaperMm / 10};
        RenderPlan plan = *planOf(scene);
        plan.gradientFloor = 0;
        const double exact = exactThickness(ball);
        EXPECT_NEAR(drawnThickness(backend(), ball, plan), exact, 0.01 * exact) << perPaperMm;
    }
}

// ---- torus ---------------------------------------------------------------------------------------------------------

TEST(TorusForms, AreTheFieldsDerivatives) {
    const Torus torus;
    const glm::dvec3 view(0, 0, -1);
    constexpr double h = 1e-4;
    int places = 0;
    for (const glm::dvec2 at : {glm::dvec2(3, 14), glm::dvec2(-20, 2), glm::dvec2(15, -9), glm::dvec2(24, 3)}) {
        const auto depth = torus.frontMm(at);
        ASSERT_TRUE(depth);
        const glm::dvec3 mm(at, *depth);
        const auto slope = [&](const glm::dvec3& p) {
            const auto along = [&](const glm::dvec3& d) {
                return (torus.value(p + h * d) - torus.value(p - h * d)) / (2 * h);
            };
            return glm::dvec3(along({1, 0, 0}), along({0, 1, 0}), along({0, 0, 1}));
        };
        const glm::dvec3 n = torus.normal(mm);
        EXPECT_LT(glm::length(n + slope(mm)), 1e-6); // a distance field: its gradient is a unit vector
        const glm::dvec3 tangent = glm::normalize(view - glm::dot(view, n) * n);
        // How far the normal turns against the way along the surface.
        const double turn = glm::dot(slope(mm + h * tangent) - slope(mm - h * tangent), tangent) / (2 * h);
        EXPECT_NEAR(torus.curvatureAlong(mm, view), std::abs(turn), 1e-5);
        ++places;
    }
    EXPECT_EQ(places, 4);
}

/// RMS over the torus' picture where contours can be, in units of 1 / minorMm.
struct CurvatureErrors {
    double bend = 0;            ///< of the Hessian's measure
    double turn = 0;            ///< of two normals' measure against the angle of the torus' own normals there
    double turnAsCurvature = 0; ///< against the curvature along the view
};

CurvatureErrors curvatureErrors(const Torus& torus, int pixels) {
    AnalyticScene scene = torus.scene(pixels);
    Layer byNormals = scene.figure.layers.front();
    byNormals.contours.emplace();
    byNormals.contours->curvature = CurvatureEstimator::normals;
    scene.figure.layers.push_back(byNormals);
    RenderPlan plan = *planOf(scene);
    plan.gradientFloor = 0;
    const glm::dvec3 view(0, 0, -1);
    CurvatureErrors errors;
    double count = 0;
    for (int i = 0; i < pixels * pixels; ++i) {
        const glm::ivec2 pixel(i % pixels, i / pixels);
        const auto depth = torus.frontMm(pixelCentreMm(scene, pixel));
        const auto ray = reference::rayThrough(plan, glm::dvec2(pixel) + 0.5);
        const glm::dvec3 mm(pixelCentreMm(scene, pixel), depth.value_or(0));
        // Head-on the direction of the view on the surface is not defined.
        if (!depth || !ray || glm::dot(torus.normal(mm), view) > 0.9) {
            continue;
        }
        const double start = plan.volume->grid().mmFromVoxel(ray->positionVoxel(0)).z;
        const reference::SampleFacts facts = reference::sampleFacts(plan, *ray, {*depth - start, 0}, 0);
        const double turn = facts.turns.front().second;
        const glm::dvec3 before = torus.normal(mm + view); // a voxel towards the viewer
        const double angle =
            std::atan2(glm::length(glm::cross(before, torus.normal(mm))), glm::dot(before, torus.normal(mm)));
        const double exact = torus.curvatureAlong(mm, view);
        errors.bend += std::pow((facts.surface.bend - exact) * torus.minorMm, 2);
        errors.turn += std::pow((turn - angle) * torus.minorMm, 2);
        errors.turnAsCurvature += std::pow((turn - exact) * torus.minorMm, 2);
        ++count;
    }
    return {std::sqrt(errors.bend / count), std::sqrt(errors.turn / count), std::sqrt(errors.turnAsCurvature / count)};
}

TEST(TorusCurvature, OfTheHessianConvergesAndOfTwoNormalsIsAnotherMeasure) {
    const CurvatureErrors coarse = curvatureErrors({4, 10}, 100);
    const CurvatureErrors middle = curvatureErrors({8, 20}, 100);
    const CurvatureErrors fine = curvatureErrors({16, 40}, 100);
    EXPECT_NEAR(testing::observedOrder(coarse.bend, middle.bend), 2, 0.2);
    EXPECT_NEAR(testing::observedOrder(middle.bend, fine.bend), 2, 0.2);
    EXPECT_LT(fine.bend, 2e-3); // most of it the blur's, which falls as voxels do
    EXPECT_NEAR(testing::observedOrder(middle.turn, fine.turn), 2, 0.3);
    EXPECT_LT(fine.turn, 2e-3);
    // The normal also turns sideways where the view is along neither of the ring's directions, and less than the
    // surface bends where the view is steep: a difference of the measures, the same at every resolution.
    EXPECT_NEAR(fine.turnAsCurvature, coarse.turnAsCurvature, 0.1 * fine.turnAsCurvature);
    EXPECT_GT(fine.turnAsCurvature, 100 * fine.bend);
}

TEST_P(ContourScenes, ShowTheTorusCurvature) {
    const Torus torus;
    constexpr int pixels = 40;
    const AnalyticScene scene = torus.scene(pixels);
    RenderPlan plan = *planOf(scene);
    plan.gradientFloor = 0;
    const Picture picture = testing::renderWhole(backend(), plan);
    double sum = 0;
    int count = 0;
    for (int i = 0; i < pixels * pixels; ++i) {
        const glm::ivec2 pixel(i % pixels, i / pixels);
        const auto depth = torus.frontMm(pixelCentreMm(scene, pixel));
        if (!depth) {
            continue;
        }
        const glm::dvec3 mm(pixelCentreMm(scene, pixel), *depth);
        const double facing = -torus.normal(mm).z;
        if (facing < 0.2 || facing > 0.9) { // at the rim a twentieth of a voxel in depth is another place
            continue;
        }
        const double exact = torus.curvatureAlong(mm, {0, 0, -1}) * torus.minorMm / 2;
        EXPECT_NEAR(picture.pixel(pixel.x, pixel.y)[3], 1, 1e-6);
        sum += std::pow(picture.pixel(pixel.x, pixel.y)[0] - exact, 2);
        ++count;
    }
    EXPECT_GT(count, 300);
    EXPECT_LT(std::sqrt(sum / count), 0.005) << std::sqrt(sum / count);
}

} // namespace
} // namespace limner::accuracy
