#include "renderer/marks/draw_marks.h"
#include "renderer/marks/ink.h"
#include "support/mark_scenes.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <gtest/gtest.h>

#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace limner {
namespace {

using namespace testing;

/// A flat face towards the viewer that asks for a tone: lit so that 1 - l.n is the tone.
Figure flatPatch(double tone) {
    Figure figure = inkFigure(slabVolume(64), 60, 60);
    lookFromAbove(figure);
    StippleLighting& lighting = figure.stipple->lighting.emplace();
    lighting.kle = 1;
    lighting.light.direction = {std::sqrt(1 - (1 - tone) * (1 - tone)), 0, 1 - tone};
    return figure;
}

class Placing : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(On, Placing, ::testing::Values("paper", "volume"),
                         [](const auto& parameter) { return parameter.param; });

TEST_P(Placing, InkIsTheToneThatIsAskedFor) {
    for (const double tone : {0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95}) {
        Figure figure = flatPatch(tone);
        figure.stipple->placing = GetParam();
        EXPECT_NEAR(inkedShare(marksOf(figure), 10, 50), tone, 0.03) << tone;
    }
}

TEST_P(Placing, CountsAreProportionalToTheTone) {
    Figure figure = flatPatch(1);
    figure.stipple->placing = GetParam();
    figure.stipple->tone = "count";
    const auto count = [](const Figure& of) {
        double sum = 0;
        for (const Dot& dot : allDots(marksOf(of))) {
            sum += static_cast<double>(dot.opacity); // a dot that fades is a part of one
        }
        return sum;
    };
    const double full = count(figure);
    for (const double tone : {0.05, 0.25, 0.5, 0.75}) {
        Figure less = flatPatch(tone);
        less.stipple->placing = GetParam();
        less.stipple->tone = "count";
        EXPECT_NEAR(count(less) / full, tone, 0.02) << tone;
    }
}

/// Mean power of the dots in a square of paper at frequencies below half of the principal one; 1 for random dots.
double lowPower(const std::vector<Dot>& dots, double low, double high) {
    std::vector<glm::dvec2> points;
    for (const Dot& dot : dots) {
        const glm::dvec2 p(dot.placeMm);
        if (p.x >= low && p.x < high && p.y >= low && p.y < high) {
            points.push_back((p - low) / (high - low));
        }
    }
    const double principal = std::sqrt(static_cast<double>(points.size()));
    double sum = 0;
    int count = 0;
    // A square's edge leaks power along the axes: whole waves across it only, and not the longest.
    for (double share = 0.2; share < 0.5; share += 0.06) {
        for (int i = 0; i < 16; ++i) {
            const double angle = std::numbers::pi * (i + 0.5) / 16;
            const double kx = std::round(principal * share * std::cos(angle));
            const double ky = std::round(principal * share * std::sin(angle));
            std::complex<double> wave = 0;
            for (const glm::dvec2& p : points) {
                wave += std::polar(1.0, -2 * std::numbers::pi * (kx * p.x + ky * p.y));
            }
            sum += std::norm(wave) / static_cast<double>(points.size());
            ++count;
        }
    }
    return sum / count;
}

TEST_P(Placing, DotsOfAFlatToneAreBlueNoise) {
    for (const double share : {0.1, 0.3, 1.0}) {
        Figure figure = flatPatch(share);
        figure.stipple->placing = GetParam();
        figure.stipple->tone = "count"; // of N_max
        figure.stipple->spreadVoxels = 0;
        const auto dots = allDots(marksOf(figure));
        EXPECT_GT(dots.size(), 1000U);
        EXPECT_LT(lowPower(dots, 10, 50), 0.3) << share;
    }
}

TEST_P(Placing, AreTheSameForAnyNumberOfThreads) {
    Figure figure = inkFigure(bodyVolume(40, [](const glm::dvec3& p) { return glm::length(p) - 14; }), 50, 44);
    figure.stipple->lighting.emplace();
    figure.stipple->placing = GetParam();
    const auto draw = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return allDots(marksOf(figure));
    };
    const auto one = draw(1);
    const auto four = draw(4);
    ASSERT_EQ(one.size(), four.size());
    ASSERT_GT(one.size(), 500U);
    for (std::size_t i = 0; i < one.size(); ++i) {
        ASSERT_EQ(one[i].placeMm, four[i].placeMm);
        ASSERT_EQ(one[i].radiusMm, four[i].radiusMm);
        ASSERT_EQ(one[i].opacity, four[i].opacity);
    }
    figure.stipple->seed = 2;
    EXPECT_NE(allDots(marksOf(figure)).front().placeMm, one.front().placeMm);
}

/// Changes between the dots of two views: those that come or go as a share of all, and the largest change of opacity
/// of one that stays. A dot of the volume is known by its place in it.
struct Turn {
    double changed = 0;
    double largestStep = 0;
};
Turn turned(const Figure& figure, double degrees) {
    // The dots' places in the volume: those of the first view, looked for in the second along its own projection.
    Figure other = figure;
    const double a = glm::radians(degrees);
    other.camera.direction = {std::sin(a), std::cos(a), 0};
    const auto before = allDots(marksOf(figure, true));
    const auto after = allDots(marksOf(other, true));
    const auto key = [](const Dot& dot, double angle, const Figure& f) {
        const double right =
            static_cast<double>(dot.placeMm.x) / f.output.widthMm * f.camera.heightMm - f.camera.heightMm / 2;
        const double near = static_cast<double>(dot.depthMm);
        // Right of the picture is direction x up; depth runs against the direction.
        const double x = right * std::cos(angle) - near * std::sin(angle);
        const double y = -right * std::sin(angle) - near * std::cos(angle);
        const double z = static_cast<double>(dot.placeMm.y) / f.output.heightMm * f.camera.heightMm;
        return glm::dvec3(x, y, z);
    };
    struct Known {
        glm::dvec3 at;
        double opacity;
    };
    std::vector<Known> later;
    for (const Dot& dot : after) {
        later.push_back({key(dot, a, other), static_cast<double>(dot.opacity)});
    }
    std::sort(later.begin(), later.end(), [](const Known& p, const Known& q) { return p.at.z < q.at.z; });
    std::vector<char> met(later.size(), 0);
    Turn turn;
    double ink = 0;
    constexpr double same = 2e-3; // mm: single precision of a scan's places
    for (const Dot& dot : before) {
        const glm::dvec3 at = key(dot, 0, figure);
        double found = 0;
        auto it = std::lower_bound(later.begin(), later.end(), at.z - same,
                                   [](const Known& p, double z) { return p.at.z < z; });
        for (; it != later.end() && it->at.z < at.z + same; ++it) {
            if (glm::distance(it->at, at) < same) {
                found = it->opacity;
                met[static_cast<std::size_t>(it - later.begin())] = 1;
                break;
            }
        }
        const double step = std::abs(found - static_cast<double>(dot.opacity));
        turn.changed += step;
        turn.largestStep = std::max(turn.largestStep, step);
        ink += static_cast<double>(dot.opacity);
    }
    for (std::size_t i = 0; i < later.size(); ++i) {
        if (met[i] == 0) {
            turn.changed += later[i].opacity;
            turn.largestStep = std::max(turn.largestStep, later[i].opacity);
        }
    }
    turn.changed /= ink;
    return turn;
}

TEST(DotsOnVolume, TurningByADegreeChangesFewDotsAndNoneAllAtOnce) {
    Figure figure = inkFigure(bodyVolume(48, [](const glm::dvec3& p) { return glm::length(p) - 18; }), 120, 44);
    figure.stipple->lighting.emplace();
    const Turn degree = turned(figure, 1);
    EXPECT_LT(degree.changed, 0.05);
    EXPECT_GT(degree.changed, 0);
    // What changes does so little by little: a tenth of the turn, a tenth of the change.
    const Turn tenth = turned(figure, 0.1);
    EXPECT_LT(tenth.largestStep, 0.35);
    EXPECT_LT(tenth.changed, 0.012);
}

TEST(Dots, WhatLiesBehindMatterIsHiddenOrShown) {
    // A small ball behind a wall.
    const auto volume = bodyVolume(48, [](const glm::dvec3& p) {
        return std::min(std::abs(p.y + 12) - 3, glm::length(p - glm::dvec3(0, 12, 0)) - 6);
    });
    Figure figure = inkFigure(volume, 60, 40);
    figure.stipple->placing = "volume";
    const auto deep = [&] {
        std::size_t count = 0;
        for (const Dot& dot : allDots(marksOf(figure))) {
            count += dot.depthMm < 0 ? 1U : 0U;
        }
        return count;
    };
    EXPECT_EQ(deep(), 0U);
    figure.stipple->hidden = "show";
    EXPECT_GT(deep(), 100U);
}

TEST(Dots, ClipsCutThem) {
    Figure figure = inkFigure(bodyVolume(40, [](const glm::dvec3& p) { return glm::length(p) - 14; }), 50, 40);
    figure.clip.planes = {{{1, 0, 0}, 0}};
    for (const std::string placing : {"paper", "volume"}) {
        figure.stipple->placing = placing;
        const auto dots = allDots(marksOf(figure));
        ASSERT_GT(dots.size(), 100U);
        for (const Dot& dot : dots) {
            // Seen along +y, x grows to the left of the picture... or right: what is kept is x <= 0, one half.
            EXPECT_LT(static_cast<double>(dot.placeMm.x) * (figure.camera.heightMm / 50) - 20, 0.8) << placing;
        }
    }
}

TEST(Dots, FartherViewsKeepTheirToneWithTheResolutionFactor) {
    // Paper 004, Fig. 4: three distances, one tone.
    std::vector<double> ink;
    for (const double height : {48.0, 96.0, 144.0}) {
        Figure figure = flatPatch(0.4);
        figure.camera.heightMm = 64 * height / 48;
        figure.stipple->resolution.emplace();
        const double half = 0.3 * 60 * 48 / height;
        ink.push_back(inkedShare(marksOf(figure), 30 - half, 30 + half));
    }
    EXPECT_NEAR(ink[1], ink[0], 0.04);
    EXPECT_NEAR(ink[2], ink[0], 0.05);
}

TEST(Dots, SizesOnPaperDoNotDependOnThePicture) {
    const Figure figure = flatPatch(0.5);
    Planner planner;
    Task task;
    PlanRequest small;
    small.size = {100, 100};
    PlanRequest large;
    large.size = {3000, 3000};
    const auto a = allDots(drawMarks(*planner.plan(figure, small, task), task));
    const auto b = allDots(drawMarks(*planner.plan(figure, large, task), task));
    ASSERT_EQ(a.size(), b.size());
    EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), [](const Dot& p, const Dot& q) {
        return p.placeMm == q.placeMm && p.radiusMm == q.radiusMm;
    }));
}

TEST(Dots, ExtremeSettingsDrawSoundDots) {
    const auto volume = bodyVolume(24, [](const glm::dvec3& p) { return glm::length(p) - 8; });
    for (const double k : {0.0, 1e-6, 100.0}) {
        Figure figure = inkFigure(volume, 40, 24);
        Stipple& s = *figure.stipple;
        s.boundary.emplace() = {k, k, k};
        s.silhouette.emplace() = {k, k, k};
        s.resolution.emplace().kre = k;
        s.distance.emplace().kde = -k;
        s.interior.emplace().kte = k;
        s.lighting.emplace().kle = k;
        for (const bool moving : {false, true}) {
            for (const Dot& dot : allDots(marksOf(figure, moving))) {
                ASSERT_TRUE(std::isfinite(dot.placeMm.x) && std::isfinite(dot.placeMm.y) && std::isfinite(dot.depthMm));
                ASSERT_TRUE(dot.radiusMm >= 0 && dot.radiusMm <= 0.5 * s.sizeMm + 1e-6);
                ASSERT_TRUE(dot.opacity > 0 && dot.opacity <= 1);
            }
        }
    }
}

TEST(Dots, ACapOnPointsIsSaid) {
    Figure figure = flatPatch(0.5);
    figure.stipple->kMax = 64;
    figure.stipple->sizeMm = 0.005; // a voxel then has tens of thousands
    Task task;
    const auto plan = markPlan(figure);
    const auto warned = [&] {
        const auto warnings = task.warnings();
        return std::any_of(warnings.begin(), warnings.end(),
                           [](const std::string& line) { return line.find("50 million") != std::string::npos; });
    };
    EXPECT_FALSE(warned());
    makeMarkScene(*plan, *plan->marks->field, false, task); // the counts, without the dots
    EXPECT_TRUE(warned());
}

} // namespace
} // namespace limner
