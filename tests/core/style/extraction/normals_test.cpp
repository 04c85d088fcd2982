#include "core/style/extraction/normals.h"

#include "core/base/task.h"
#include "support/artworks.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace limner {
namespace {

using namespace limner::testing;

ArtCut cutOf(const SyntheticArt& art) { return {art.picture, {0, 0}, 1}; }

struct Errors {
    double mean = 0;
    double worst = 0; ///< two pixels and more within the outline
};

Errors errorsOf(const NormalField& field, const SyntheticArt& art) {
    Errors errors;
    int count = 0;
    for (int y = 2; y + 2 < field.height; ++y) {
        for (int x = 2; x + 2 < field.width; ++x) {
            const std::size_t i = art.form.offset(x, y);
            const bool inside = art.form.has(x, y) && art.form.has(x - 2, y) && art.form.has(x + 2, y) &&
                                art.form.has(x, y - 2) && art.form.has(x, y + 2);
            if (inside) {
                const double error = glm::length(field.normals[i] - art.normals[i]);
                errors.mean += error;
                errors.worst = std::max(errors.worst, error);
                ++count;
            }
        }
    }
    errors.mean /= count;
    return errors;
}

NormalField normalsOf(const SyntheticArt& art, const FormMarks& marks = {}) {
    Task task;
    return formNormals(cutOf(art), art.form, marks, task);
}

TEST(EllipseNormals, AreTheUnitDiskStretchedAndNotTurned) {
    const ArtCut cut{{200, 200, std::vector<Rgba>(40'000)}, {50, 20}, 2};
    const NormalField field = ellipseNormals(cut, {{250, 220}, {100, 60}, 30});
    // A quarter along the first axis, which points 30 degrees below +x as the picture shows it.
    const glm::dvec2 place = cut.toCut(glm::dvec2(250, 220) + 25.0 * glm::dvec2(std::sqrt(0.75), 0.5));
    const auto x = static_cast<int>(place.x);
    const auto y = static_cast<int>(place.y);
    const glm::vec2 n = field.normals[cut.picture.offset(x, y)];
    EXPECT_NEAR(n.x, 0.25 * std::sqrt(0.75), 0.02);
    EXPECT_NEAR(n.y, -0.25 * 0.5, 0.02);
    EXPECT_TRUE(std::isnan(field.normals[0].x));
}

TEST(FormNormals, AnOutlineAloneGivesAnEllipsoid) {
    const LitSphere style = plainStyle(64);
    for (const glm::dvec3 axes : {glm::dvec3(90, 90, 90), glm::dvec3(120, 80, 80), glm::dvec3(60, 110, 60)}) {
        const SyntheticArt art = drawn(280, 260, ellipsoidForm({140, 130}, axes), style);
        const Errors errors = errorsOf(normalsOf(art), art);
        EXPECT_LT(errors.mean, 0.006) << axes.x;
        EXPECT_LT(errors.worst, 0.12) << axes.x; // beside a staircase of pixels
    }
}

TEST(FormNormals, ARingIsNearlyOne) {
    const SyntheticArt art = drawn(300, 300, torusForm({150, 150}, 90, 40), plainStyle(64));
    const Errors errors = errorsOf(normalsOf(art), art);
    // An inflated ring bulges a little outwards: that is the model's, not the solver's error.
    EXPECT_LT(errors.mean, 0.05);
    EXPECT_LT(errors.worst, 0.15);
}

TEST(FormNormals, DepthFlattensAndDeepens) {
    const SyntheticArt art = drawn(220, 220, ballForm({{110, 110}, {90, 90}, 0}), plainStyle(64));
    FormMarks flat;
    flat.depth = 0.5;
    const std::size_t at = art.form.offset(155, 110);
    // Half way out on an ellipsoid half as deep: x / a^2 against z / c^2.
    const double expected = 45.5 / std::hypot(45.5, std::sqrt(8100 - 45.5 * 45.5) / 0.5);
    EXPECT_NEAR(normalsOf(art, flat).normals[at].x, expected, 0.01);
}

TEST(FormNormals, AMarkHoldsAtItsPlaceAndFadesAway) {
    const SyntheticArt art = drawn(220, 220, ballForm({{110, 110}, {90, 90}, 0}), plainStyle(64));
    FormMarks marks;
    marks.normals.push_back({{110, 80}, {0.6, 0.0}});
    const NormalField plain = normalsOf(art);
    const NormalField marked = normalsOf(art, marks);
    const std::size_t there = art.form.offset(110, 80);
    const std::size_t near = art.form.offset(118, 80);
    const std::size_t far = art.form.offset(110, 180);
    EXPECT_NEAR(marked.normals[there].x, 0.6, 0.02);
    EXPECT_NEAR(marked.normals[there].y, 0.0, 0.02);
    EXPECT_GT(marked.normals[near].x, plain.normals[near].x + 0.1);
    EXPECT_NEAR(glm::distance(marked.normals[far], plain.normals[far]), 0, 0.08);
}

TEST(FormNormals, ACreaseTiltsItsTwoSidesApart) {
    const SyntheticArt art = drawn(220, 220, ballForm({{110, 110}, {90, 90}, 0}), plainStyle(64));
    FormMarks marks;
    marks.creases.push_back({{{110, 60}, {110, 160}}, 40});
    NormalField field = normalsOf(art, marks);
    EXPECT_NEAR(field.normals[art.form.offset(107, 110)].x, -std::sin(40 * 3.14159265 / 180), 0.1);
    EXPECT_NEAR(field.normals[art.form.offset(112, 110)].x, std::sin(40 * 3.14159265 / 180), 0.1);
    marks.creases[0].tiltDegrees = -40;
    field = normalsOf(art, marks);
    EXPECT_GT(field.normals[art.form.offset(107, 110)].x, 0.4);
}

TEST(FormNormals, AnOpenOutlineIsNoEdge) {
    // The left half of a ball whose right half is hidden: along the cut it faces the viewer, not sideways.
    SyntheticArt art = drawn(220, 220, ballForm({{110, 110}, {90, 90}, 0}), plainStyle(64));
    for (int y = 0; y < 220; ++y) {
        for (int x = 110; x < 220; ++x) {
            art.form.values[art.form.offset(x, y)] = 0;
        }
    }
    FormMarks open;
    open.open.push_back({{110, 20}, {110, 200}});
    const std::size_t atCut = art.form.offset(108, 110);
    EXPECT_GT(normalsOf(art).normals[atCut].x, 0.7);
    EXPECT_NEAR(normalsOf(art, open).normals[atCut].x, 0, 0.05);
    const std::size_t half = art.form.offset(65, 110);
    EXPECT_NEAR(normalsOf(art, open).normals[half].x, art.normals[half].x, 0.05);
}

TEST(FormNormals, MarksBeyondThePictureDoNoHarm) {
    const SyntheticArt art = drawn(64, 64, ballForm({{32, 32}, {25, 25}, 0}), plainStyle(64));
    FormMarks marks;
    marks.normals.push_back({{1e30, -1e30}, {5, 5}});
    marks.creases.push_back({{{-1e9, 0}, {1e9, 0}}, 90});
    marks.open.push_back({{32, 32}});
    const NormalField field = normalsOf(art, marks);
    for (const glm::vec2& n : field.normals) {
        EXPECT_TRUE(std::isnan(n.x) || glm::length(n) <= 1.0001F);
    }
}

} // namespace
} // namespace limner
