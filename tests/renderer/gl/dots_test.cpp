#include "renderer/marks/dot_cloud.h"
#include "renderer/marks/draw_marks.h"
#include "renderer/marks/ink.h"
#include "renderer/marks/marked_picture.h"
#include "support/gl_backend.h"
#include "support/mark_scenes.h"
#include "support/rendering.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>

// Dots that the graphics card draws from one buffer of candidates, against those of renderer/marks.

namespace limner {
namespace {

using testing::bodyVolume;
using testing::inkFigure;

struct Scene {
    std::string name;
    std::function<void(Figure&)> apply;
    std::size_t leastDots = 1000;
};

void PrintTo(const Scene& scene, std::ostream* out) { *out << scene.name; }

/// A ball with a dent and a smaller one before it.
std::shared_ptr<const Volume> twoBalls() {
    static const auto volume = bodyVolume(48, [](const glm::dvec3& p) {
        const double large = std::max(glm::length(p) - 16, 7 - glm::length(p - glm::dvec3(-6, -14, 6)));
        return std::min(large, glm::length(p - glm::dvec3(8, -14, -6)) - 5);
    });
    return volume;
}

Figure figureOf(const Scene& scene) {
    Figure figure = inkFigure(twoBalls(), 60, 44);
    scene.apply(figure);
    return figure;
}

Stipple& ink(Figure& figure) { return *figure.stipple; }

void allFactors(Figure& figure) {
    Stipple& s = ink(figure);
    s.boundary.emplace();
    s.silhouette.emplace();
    s.resolution.emplace();
    s.distance.emplace();
    s.interior.emplace();
    s.lighting.emplace();
}

const std::vector<Scene>& scenes() {
    static const std::vector<Scene> all{
        {"plain", [](Figure& f) { ink(f).kMax = 0.5; }},
        {"dense", [](Figure&) {}},
        {"counted", [](Figure& f) { ink(f).tone = "count"; }},
        {"shownThrough", [](Figure& f) { ink(f).hidden = "show"; }},
        {"boundary", [](Figure& f) { ink(f).boundary.emplace(); }},
        {"silhouette", [](Figure& f) { ink(f).silhouette.emplace(); }},
        {"distance", [](Figure& f) { ink(f).distance.emplace(); }},
        {"interior", [](Figure& f) { ink(f).interior.emplace(); }},
        {"lighting", [](Figure& f) { ink(f).lighting.emplace(); }},
        {"farAway",
         [](Figure& f) {
             ink(f).resolution.emplace();
             f.camera.heightMm = 110;
         },
         200},
        {"near", [](Figure& f) { f.camera.heightMm = 16; }},
        {"allFactors", allFactors, 500},
        {"allFactorsCounted",
         [](Figure& f) {
             allFactors(f);
             ink(f).tone = "count";
         },
         500},
        {"perspective",
         [](Figure& f) {
             allFactors(f);
             f.camera.projection = Projection::perspective;
             f.camera.fovDeg = 30;
         },
         500},
        {"large", [](Figure& f) { ink(f).sizeMm = 3; }, 20},
        {"clipped",
         [](Figure& f) {
             f.clip.planes = {{glm::normalize(glm::dvec3(1, 0.3, 0)), 3}};
             f.clip.boxMm = BoxMm{{-30, -30, -8}, {30, 30, 9}};
         }},
        {"scattered", [](Figure& f) { ink(f).spreadVoxels = 2; }},
        {"otherSeed", [](Figure& f) { ink(f).seed = 77; }},
    };
    return all;
}

std::shared_ptr<const RenderPlan> turnedPlan(Planner& planner, Figure figure, double degrees, int pixels = 200) {
    const double angle = glm::radians(degrees);
    figure.camera.direction = {std::sin(angle), std::cos(angle), -0.3};
    Task task;
    PlanRequest request;
    request.size = {pixels, pixels};
    request.moving = true;
    return planner.plan(figure, request, task);
}

Picture markedPicture(const RenderPlan& plan, const Backend& backend) {
    Task task;
    return MarkedPicture(plan, backend, task).render({{0, 0}, plan.size}, task).picture;
}

/// Dots of `a` that `b` has not: at the place, of the size and the opacity.
std::size_t missingIn(const std::vector<Dot>& a, const std::vector<Dot>& b) {
    constexpr float kCellMm = 0.02F;
    constexpr float kPlaceMm = 1e-3F;
    std::multimap<std::pair<int, int>, const Dot*> places;
    const auto cellOf = [](const glm::vec2& mm) { return glm::ivec2(glm::floor(mm / kCellMm)); };
    for (const Dot& dot : b) {
        const glm::ivec2 cell = cellOf(dot.placeMm);
        places.emplace(std::pair(cell.x, cell.y), &dot);
    }
    const auto same = [](const Dot& p, const Dot& q) {
        return glm::distance(p.placeMm, q.placeMm) < kPlaceMm && std::abs(p.depthMm - q.depthMm) < kPlaceMm &&
               std::abs(p.radiusMm - q.radiusMm) < 1e-3F && std::abs(p.opacity - q.opacity) < 0.02F;
    };
    return static_cast<std::size_t>(std::count_if(a.begin(), a.end(), [&](const Dot& dot) {
        const glm::ivec2 cell = cellOf(dot.placeMm);
        for (int k = 0; k < 9; ++k) {
            const auto [from, to] = places.equal_range({cell.x + k % 3 - 1, cell.y + k / 3 - 1});
            if (std::any_of(from, to, [&](const auto& one) { return same(dot, *one.second); })) {
                return false;
            }
        }
        return true;
    }));
}

class GlDots : public testing::GlTest, public ::testing::WithParamInterface<Scene> {};
INSTANTIATE_TEST_SUITE_P(Of, GlDots, ::testing::ValuesIn(scenes()), [](const auto& one) { return one.param.name; });

TEST_P(GlDots, AreTheProcessorsDots) {
    Planner planner;
    std::size_t dots = 0;
    std::size_t apart = 0;
    for (const double degrees : {0.0, 40.0, 170.0}) {
        const auto plan = turnedPlan(planner, figureOf(GetParam()), degrees);
        ASSERT_TRUE(gl().laysDots(*plan));
        Task task;
        const auto expected = testing::allDots(drawMarks(*plan, task));
        const auto drawn = gl().dotsOf(*plan, task);
        EXPECT_GE(expected.size(), GetParam().leastDots);
        dots += expected.size();
        apart += missingIn(expected, drawn) + missingIn(drawn, expected);
    }
    EXPECT_LE(static_cast<double>(apart), 0.001 * static_cast<double>(dots)) << apart << " of " << dots;
    RecordProperty("dots", std::to_string(dots));
    RecordProperty("apart", std::to_string(apart));
}

TEST_P(GlDots, GiveTheProcessorsPicture) {
    const auto cpu = makeCpuBackend();
    Planner planner;
    for (const double degrees : {0.0, 40.0, 170.0}) {
        const auto plan = turnedPlan(planner, figureOf(GetParam()), degrees);
        const Picture expected = markedPicture(*plan, *cpu);
        const Picture drawn = markedPicture(*plan, gl());
        EXPECT_LT(testing::rootMeanSquare(drawn, expected), 0.002) << degrees;
        EXPECT_EQ(testing::unsoundPixels(drawn), 0);
        EXPECT_GT(testing::rootMeanSquare(drawn, Picture(plan->size)), 0.02);
        RecordProperty("rmse at " + std::to_string(degrees), std::to_string(testing::rootMeanSquare(drawn, expected)));
    }
}

} // namespace
} // namespace limner
