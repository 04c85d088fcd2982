#include "renderer/gl/functions.h"
#include "renderer/marks/dot_cloud.h"
#include "renderer/marks/draw_marks.h"
#include "renderer/marks/ink.h"
#include "renderer/marks/marked_picture.h"
#include "support/gl_backend.h"
#include "support/mark_scenes.h"
#include "support/rendering.h"
#include "support/transfer_scenes.h"

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

std::vector<Scene> oneByOne() {
    return {
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
        {"near", [](Figure& f) { f.camera.heightMm = 26; }},
    };
}

std::vector<Scene> together() {
    return {
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
        {"ofLayers",
         [](Figure& f) {
             testing::makeLine(f.layers.emplace_back(), "value");
             ink(f).matter = "layers";
         },
         100},
        {"ofNoStrength",
         [](Figure& f) {
             allFactors(f);
             ink(f).boundary = StippleBoundary{0, 0, 0};
         },
         0},
        {"ofAllStrength",
         [](Figure& f) {
             allFactors(f);
             ink(f).boundary = StippleBoundary{100, 100, 100};
             ink(f).silhouette = StippleSilhouette{100, 100, 100};
             ink(f).resolution->kre = 100;
             ink(f).distance->kde = -100;
             ink(f).interior->kte = 1e-6;
             ink(f).lighting->kle = 100;
         },
         100},
        {"otherSeed", [](Figure& f) { ink(f).seed = 77; }},
    };
}

const std::vector<Scene>& scenes() {
    static const std::vector<Scene> all = [] {
        std::vector<Scene> both = oneByOne();
        const std::vector<Scene> more = together();
        both.insert(both.end(), more.begin(), more.end());
        return both;
    }();
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

/// As the card draws it: the second picture of a setting, since the first is the processor's.
Picture cardsPicture(const RenderPlan& plan, const Backend& gl) {
    markedPicture(plan, gl);
    return markedPicture(plan, gl);
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

/// A context that counts what is put on the card through it.
class CountingContext : public gl::Context {
  public:
    explicit CountingContext(std::unique_ptr<gl::Context> context) : context_(std::move(context)) { uploads = 0; }
    [[nodiscard]] std::string library() const override { return context_->library(); }
    bool makeCurrent() override { return context_->makeCurrent(); }
    void release() override { context_->release(); }
    [[nodiscard]] void* find(const char* function) const override {
        void* found = context_->find(function);
        const std::string name = function;
        if (name == "glBufferData") {
            bufferData = reinterpret_cast<PFNGLBUFFERDATAPROC>(found);
            return reinterpret_cast<void*>(&countBuffer);
        }
        if (name == "glBufferSubData") {
            bufferSubData = reinterpret_cast<PFNGLBUFFERSUBDATAPROC>(found);
            return reinterpret_cast<void*>(&countPart);
        }
        if (name == "glTexImage2D") {
            texImage2d = reinterpret_cast<PFNGLTEXIMAGE2DPROC>(found);
            return reinterpret_cast<void*>(&countPicture);
        }
        return found;
    }
    static inline std::uint64_t uploads = 0;

  private:
    static void APIENTRY countBuffer(GLenum target, GLsizeiptr size, const void* data, GLenum usage) {
        uploads += data != nullptr ? 1 : 0;
        bufferData(target, size, data, usage);
    }
    static void APIENTRY countPart(GLenum target, GLintptr offset, GLsizeiptr size, const void* data) {
        ++uploads;
        bufferSubData(target, offset, size, data);
    }
    static void APIENTRY countPicture(GLenum target, GLint level, GLint inside, GLsizei width, GLsizei height,
                                      GLint border, GLenum format, GLenum type, const void* data) {
        uploads += data != nullptr ? 1 : 0;
        texImage2d(target, level, inside, width, height, border, format, type, data);
    }
    static inline PFNGLBUFFERDATAPROC bufferData = nullptr;
    static inline PFNGLBUFFERSUBDATAPROC bufferSubData = nullptr;
    static inline PFNGLTEXIMAGE2DPROC texImage2d = nullptr;

    std::unique_ptr<gl::Context> context_;
};

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
        ASSERT_TRUE(gl().laysDots(*plan));
        const Picture expected = markedPicture(*plan, *cpu);
        const Picture drawn = cardsPicture(*plan, gl());
        EXPECT_LT(testing::rootMeanSquare(drawn, expected), 0.002) << degrees;
        EXPECT_EQ(testing::unsoundPixels(drawn), 0);
        if (GetParam().leastDots > 0) {
            EXPECT_GT(testing::rootMeanSquare(drawn, Picture(plan->size)), 0.01);
        }
        RecordProperty("rmse at " + std::to_string(degrees), std::to_string(testing::rootMeanSquare(drawn, expected)));
    }
}

class GlDotsOfAView : public testing::GlTest {};

TEST_F(GlDotsOfAView, TurningPutsNothingOnTheCard) {
    const auto contexts = gl::contextFactory(gl().facts().library);
    const auto counted = makeGlBackend([&] { return std::make_unique<CountingContext>(contexts()); });
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
        Planner planner;
        Figure figure = figureOf({"", allFactors});
        figure.camera.projection = projection;
        const std::uint64_t before = CountingContext::uploads;
        markedPicture(*turnedPlan(planner, figure, 0), *counted);
        EXPECT_EQ(CountingContext::uploads, before) << "for a setting that is still being moved";
        markedPicture(*turnedPlan(planner, figure, 0), *counted);
        const std::uint64_t first = CountingContext::uploads;
        EXPECT_GT(first, before);
        for (int degrees = 1; degrees < 360; degrees += 23) {
            markedPicture(*turnedPlan(planner, figure, degrees), *counted);
            EXPECT_EQ(CountingContext::uploads, first) << degrees;
        }
        // Nor does the light, or the tile; what the dots are made from does.
        figure.stipple->lighting->light.direction = {1, 0, 0};
        markedPicture(*turnedPlan(planner, figure, 0), *counted);
        EXPECT_EQ(CountingContext::uploads, first);
        figure.stipple->kMax *= 0.5;
        cardsPicture(*turnedPlan(planner, figure, 0), *counted);
        EXPECT_GT(CountingContext::uploads, first);
    }
}

TEST_F(GlDotsOfAView, LieWithStrokesOverAndUnderLayers) {
    const auto cpu = makeCpuBackend();
    for (const std::string order : {"under", "over"}) {
        Figure figure = figureOf({"", [](Figure& f) { ink(f).kMax = 0.7; }});
        figure.stipple->layerOpacity = order;
        figure.stipple->inkRgb = {0.6, 0.1, 0.2};
        figure.stipple->curves.emplace();
        figure.stipple->hatching.emplace();
        Layer& layer = figure.layers.emplace_back();
        testing::makeLine(layer, "value");
        Planner planner;
        const auto plan = turnedPlan(planner, figure, 20);
        ASSERT_TRUE(plan->marks->layersDrawn);
        EXPECT_LT(testing::rootMeanSquare(cardsPicture(*plan, gl()), markedPicture(*plan, *cpu)), 0.002) << order;
    }
}

TEST_F(GlDotsOfAView, AnyTilingGivesTheSameBits) {
    Planner planner;
    for (const double sizeMm : {0.35, 3.0}) {
        const auto plan = turnedPlan(planner, figureOf({"", [&](Figure& f) { ink(f).sizeMm = sizeMm; }}), 30);
        Task task;
        markedPicture(*plan, gl());
        const MarkedPicture marked(*plan, gl(), task);
        const Picture whole = marked.render({{0, 0}, plan->size}, task).picture;
        for (const Tile tile : {Tile{{0, 0}, {64, 200}}, Tile{{64, 31}, {100, 90}}, Tile{{199, 0}, {1, 200}}}) {
            const Picture part = marked.render(tile, task).picture;
            for (int y = 0; y < tile.size.y; ++y) {
                ASSERT_TRUE(std::equal(part.pixel(0, y), part.pixel(0, y) + 4 * tile.size.x,
                                       whole.pixel(tile.origin.x, tile.origin.y + y)))
                    << sizeMm << ' ' << tile.origin.x << ' ' << y;
            }
        }
    }
}

TEST_F(GlDotsOfAView, AreTheProcessorsWhereTheCardDoesNotDrawThem) {
    const auto cpu = makeCpuBackend();
    Task task;
    Planner planner;
    Figure figure = figureOf({"", [](Figure&) {}});
    const auto still = testing::markPlan(figure, false);
    EXPECT_FALSE(gl().laysDots(*still));
    EXPECT_TRUE(testing::sameBits(markedPicture(*still, gl()), markedPicture(*still, *cpu)));
    figure.stipple->kMax = 0;
    EXPECT_FALSE(gl().laysDots(*turnedPlan(planner, figure, 0)));
    figure.stipple->kMax = 1;
    figure.stipple->sizeMm = 100; // points larger than any card has
    EXPECT_FALSE(gl().laysDots(*turnedPlan(planner, figure, 0)));
    figure = figureOf({"", [](Figure&) {}});
    figure.camera.projection = Projection::perspective;
    figure.camera.heightMm = 1; // the eye is in the ball
    EXPECT_FALSE(gl().laysDots(*turnedPlan(planner, figure, 0)));
    EXPECT_FALSE(cpu->laysDots(*turnedPlan(planner, figure, 0)));
}

TEST_F(GlDotsOfAView, MoreThanTheCardHoldsAreTheProcessors) {
    const auto cpu = makeCpuBackend();
    const auto small = makeGlBackend(gl::contextFactory(gl().facts().library));
    small->setRoom(100'000);
    Planner planner;
    const auto plan = turnedPlan(planner, figureOf({"", [](Figure&) {}}), 0);
    EXPECT_TRUE(testing::sameBits(cardsPicture(*plan, *small), markedPicture(*plan, *cpu)));
}

TEST_F(GlDotsOfAView, OutliveALostContext) {
    Planner planner;
    const auto plan = turnedPlan(planner, figureOf({"", allFactors}), 10);
    const Picture before = cardsPicture(*plan, gl());
    for (int i = 0; i < 3; ++i) {
        gl().loseContext();
        EXPECT_TRUE(testing::sameBits(cardsPicture(*plan, gl()), before));
    }
}

TEST_F(GlDotsOfAView, ACancelledPictureEnds) {
    Planner planner;
    const auto plan = turnedPlan(planner, figureOf({"", [](Figure&) {}}), 10);
    markedPicture(*plan, gl());
    Task task;
    task.cancel();
    Picture picture(plan->size);
    EXPECT_THROW(gl().layDots(*plan, {{0, 0}, plan->size}, picture, task), Error);
}

/// All that any view draws is there, whatever makes it denser or larger.
TEST(DotClouds, HoldTheDotsOfEveryView) {
    for (const Scene& scene : scenes()) {
        Planner planner;
        for (const double degrees : {0.0, 65.0, 200.0}) {
            const auto plan = turnedPlan(planner, figureOf(scene), degrees);
            const MarkField& field = *plan->marks->field;
            const Stipple& stipple = *plan->figure->stipple;
            Task task;
            const MarkScene marks = makeMarkScene(*plan, field, true, task);
            const double density = inkView(*plan, field, marks.view, task).density;
            const auto cloud =
                makeDotCloud(stipple, field, density, dotHeadroom(*plan, field, marks.view), 10'000'000, task);
            ASSERT_TRUE(cloud) << scene.name;
            double asked = 0;
            for (const VoxelInk& one : marks.ink) {
                asked += static_cast<double>(one.dots);
            }
            EXPECT_GE(static_cast<double>(cloud->dotCount()), asked) << scene.name;
            if (scene.name == "plain") { // half look away, half of the rest by their slant; and some room to zoom
                EXPECT_LE(static_cast<double>(cloud->dotCount()), 6 * asked);
            }
        }
    }
}

} // namespace
} // namespace limner
