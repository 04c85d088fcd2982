#include "renderer/accuracy/formula_vectors.h"

#include "core/base/error.h"
#include "support/test_data.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>

#include <unistd.h>

// The formulas against 60-digit arithmetic, printed values and laws that they must keep, in double and in single
// precision with every instruction set of this machine.

namespace limner {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

class Formulas : public ::testing::TestWithParam<FormulaEngine> {
  protected:
    [[nodiscard]] static bool inDouble() { return GetParam().backend == "reference"; }
    /// The first bound for double, the second for single precision.
    [[nodiscard]] static double bound(double ofDouble, double ofSingle) { return inDouble() ? ofDouble : ofSingle; }

    static std::vector<double> results(Formula formula, const std::vector<double>& in) {
        return evaluateFormulas(GetParam(), {{formula, in, std::vector<double>(kindOf(formula).results), ""}}).front();
    }
    static double result(Formula formula, const std::vector<double>& in) { return results(formula, in).front(); }
};

void expectPassed(const std::vector<FormulaReport>& reports) {
    for (const FormulaReport& report : reports) {
        EXPECT_TRUE(report.passed) << report.formula << ": " << report.largestAbsolute << " absolute, "
                                   << report.largestRelative << " relative, worst at " << report.worst;
    }
}

TEST_P(Formulas, AgreeWithTheSixtyDigitVectors) {
    const auto file = testing::testData("../spec/vectors/vectors.jsonl");
    if (!file) {
        GTEST_SKIP();
    }
    const auto reports = checkFormulas(readFormulaVectors(*file), GetParam());
    EXPECT_EQ(reports.size(), kFormulas.size());
    for (const FormulaReport& report : reports) {
        EXPECT_GE(report.count, 200) << report.formula;
    }
    expectPassed(reports);
}

TEST_P(Formulas, HaveThePublishedValues) { expectPassed(checkFormulas(publishedFormulaValues(), GetParam())); }

TEST_P(Formulas, AreJudged) {
    const FormulaVector right{Formula::stippleInterior, {0.25, 0.5}, {0.5}, "right"};
    FormulaVector wrong = right;
    wrong.source = "wrong";
    wrong.out = {0.5 + bound(1e-12, 4e-6)};
    const auto reports = checkFormulas({right, wrong, right}, GetParam());
    ASSERT_EQ(reports.size(), 1U);
    EXPECT_FALSE(reports.front().passed);
    EXPECT_EQ(reports.front().worst, "wrong");
    EXPECT_EQ(reports.front().count, 3);
    EXPECT_NEAR(reports.front().largestAbsolute, std::abs(wrong.out[0] - 0.5), bound(1e-15, 1e-6));
    // A result that is no number never passes.
    const FormulaVector poisoned{Formula::contourPush, {kNaN, kNaN, kNaN}, {0.5}, "poisoned"};
    EXPECT_FALSE(checkFormulas({poisoned}, GetParam()).front().passed);
}

TEST_P(Formulas, SmallOpacitiesAddUp) {
    // numerics.md 2b: the literal 1 - (1 - a)^(d/d0) gives .011857 and 0.
    const auto gathered = [](double opacity, int samples) { return -std::expm1(samples * std::log1p(-opacity)); };
    EXPECT_NEAR(gathered(result(Formula::opacityPerLength, {1e-4, 1e-3}), 100000), 0.00995066, 6e-9);
    EXPECT_NEAR(gathered(result(Formula::opacityPerLength, {1e-8, 1}), 1000), 9.99995e-6, 6e-12);
}

TEST_P(Formulas, SmallAnglesKeepTheirDigits) {
    // numerics.md 2a: the arc cosine in single precision has no digit left at 1e-4.
    std::mt19937 random(3);
    std::normal_distribution<float> normal;
    for (const double angle : {1.0, 1e-2, 1e-3, 1e-4}) {
        for (int i = 0; i < 50; ++i) {
            std::vector<double> in;
            for (int k = 0; k < 3; ++k) {
                in.push_back(normal(random));
            }
            for (std::size_t k = 0; k < 3; ++k) { // a change of some size in any direction; lengths differ
                in.push_back(static_cast<float>(in[k] + angle * normal(random)));
            }
            in.push_back(2);
            const long double cx = in[1] * static_cast<long double>(in[5]) - in[2] * static_cast<long double>(in[4]);
            const long double cy = in[2] * static_cast<long double>(in[3]) - in[0] * static_cast<long double>(in[5]);
            const long double cz = in[0] * static_cast<long double>(in[4]) - in[1] * static_cast<long double>(in[3]);
            const double cosine = in[0] * in[3] + in[1] * in[4] + in[2] * in[5];
            const double expected = static_cast<double>(std::atan2(std::sqrt(cx * cx + cy * cy + cz * cz), cosine)) / 2;
            // A change along the vector cancels in the cross product: only its part across counts.
            const double across = expected / angle;
            const double relative = bound(1e-13, 1e-6) * std::max(1.0, 1 / across);
            EXPECT_NEAR(result(Formula::curvature, in), expected, relative * expected) << angle;
        }
    }
}

TEST_P(Formulas, CurvatureOfNothingIsZero) {
    EXPECT_EQ(result(Formula::curvature, {0, 0, 0, 0, 0, 1, 1}), 0);
    EXPECT_EQ(result(Formula::curvature, {0, 0, 1, 0, 0, 0, 1}), 0);
    EXPECT_EQ(result(Formula::curvature, {0, 0, 1, 0, 1, 0, 0}), 0);
    EXPECT_NEAR(result(Formula::curvature, {0, 0, 3, 0, 0, -1, 1}), M_PI, bound(1e-15, 4e-7));
    EXPECT_NEAR(result(Formula::curvature, {0, 0, 3, 0, 0.5, -0.5, 1}), 0.75 * M_PI, bound(1e-15, 4e-7));
}

TEST_P(Formulas, ThePushIsContinuousWhereAContourEnds) {
    for (const double radius : {0.0, 0.3, 0.8, 1.0}) {
        for (const double width : {0.01, 0.5, 0.99}) {
            EXPECT_NEAR(result(Formula::contourPush, {radius, width * (1 - 1e-6), width}), radius, 3e-6);
            EXPECT_NEAR(result(Formula::contourPush, {radius, width * (1 + 1e-6), width}), radius, bound(1e-15, 1e-7));
        }
    }
}

TEST_P(Formulas, TransparencyKeepsItsConstraints) { // style-transfer-functions.md 5
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0, 1);
    const double slack = bound(1e-14, 1e-6);
    for (int i = 0; i < 200; ++i) {
        const double facing = unit(random);
        const double width = unit(random);
        const double gradient = 1.2 * unit(random);
        const double directional = static_cast<float>(unit(random));
        const auto alpha = [&](double opacity) {
            return result(Formula::transparency, {directional, opacity, facing, width, gradient});
        };
        EXPECT_EQ(alpha(1), directional);
        EXPECT_EQ(alpha(0), 0);
        double before = 0;
        for (const double opacity : {1e-6, 0.01, 0.1, 0.4, 0.9, 0.999}) {
            const double now = alpha(opacity);
            EXPECT_GE(now, before);
            EXPECT_GE(now, directional * std::pow(opacity, 1.5) * (1 - slack));
            EXPECT_LE(now, directional * std::sqrt(opacity) * (1 + slack));
            before = now;
        }
    }
}

TEST_P(Formulas, SmallerOpacityClearsFlatRegionsBeforeContours) {
    double before = 1;
    for (const double opacity : {0.9, 0.5, 0.1, 0.01, 1e-4}) {
        const double flat = result(Formula::transparency, {1, opacity, 1, 0.2, 0});
        const double contour = result(Formula::transparency, {1, opacity, 0.1, 0.2, 0});
        EXPECT_LT(flat / contour, before);
        before = flat / contour;
    }
    EXPECT_LT(before, 1e-3);
}

TEST_P(Formulas, CompositionIsInvariantUnderSplitting) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < 100; ++i) {
        const double spread = std::vector<double>{0, 1, 5, 20, 1e3}[static_cast<std::size_t>(i) % 5];
        std::vector<double> whole;
        std::vector<double> split;
        for (int sample = 0; sample < 12; ++sample) {
            const double colour = unit(random);
            const double opacity = std::vector<double>{0, 1e-6, 0.01, unit(random), 1}[random() % 5];
            const double importance = spread * unit(random);
            const int parts = 1 + static_cast<int>(random() % 7);
            whole.insert(whole.end(), {colour, opacity, importance});
            for (int part = 0; part < parts; ++part) {
                const double each = opacity == 1 ? 1 : -std::expm1(std::log1p(-opacity) / parts);
                split.insert(split.end(), {colour, each, importance});
            }
        }
        const auto a = results(Formula::importanceRay, whole);
        const auto b = results(Formula::importanceRay, split);
        EXPECT_NEAR(a[0], b[0], bound(1e-13, 2e-6)) << spread;
        EXPECT_NEAR(a[1], b[1], bound(1e-14, 2e-6)) << spread;
        EXPECT_NEAR(a[2], b[2], bound(1e-12, 2e-6) * std::max(1.0, spread)) << spread;
    }
}

TEST_P(Formulas, ManyFaintImportantSamplesDoNotStagnate) {
    // numerics.md 2c: 4000 samples of a colour ramp behind a = .99. The literal form in single precision gives up to
    // .991266 here.
    for (const auto& [opacity, expected] : {std::pair(1e-3, 0.231088), std::pair(1e-4, 0.463501)}) {
        for (const double importance : {20.0, 1e3, 1e5, 1e6}) {
            std::vector<double> in = {0, 0.99, 0};
            for (int k = 0; k < 4000; ++k) {
                in.insert(in.end(), {k / 4000.0, opacity, importance});
            }
            // 5e-7: as it is printed. 1.5e-6 more: 4000 roundings of single precision.
            EXPECT_NEAR(result(Formula::importanceRay, in), expected, bound(5e-7, 2e-6)) << importance;
        }
    }
}

TEST_P(Formulas, CompositionWithoutImportanceIsTheOrdinary) {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<double> in;
    double colour = 0;
    double opacity = 0;
    for (int k = 0; k < 40; ++k) {
        const double c = unit(random);
        const double a = 0.2 * unit(random);
        colour += (1 - opacity) * a * c;
        opacity += (1 - opacity) * a;
        in.insert(in.end(), {c, a, 0});
    }
    const auto ray = results(Formula::importanceRay, in);
    EXPECT_NEAR(ray[0], colour, bound(1e-15, 1e-6));
    EXPECT_NEAR(ray[1], opacity, bound(1e-15, 1e-6));
    EXPECT_EQ(ray[2], 0);
}

TEST_P(Formulas, WhatIsNotANumberDoesNoHarm) {
    EXPECT_EQ(result(Formula::stippleBoundary, {kNaN, 0.5, 0.5, 0.5, 1}), 1);
    EXPECT_EQ(result(Formula::stippleResolution, {kNaN, 1, 1, 2}), 1);
    EXPECT_EQ(result(Formula::stippleResolution, {std::numeric_limits<double>::infinity(), 1, 1, 2}), 1);
    EXPECT_EQ(result(Formula::transparency, {1, kNaN, 0.9, 0.1, 0.5}), 0);
    EXPECT_EQ(result(Formula::extinctionImportance, {kNaN}), 0);
    const auto ray = results(Formula::importanceRay, {1, 0.5, 0, 0.25, kNaN, 3});
    EXPECT_EQ(ray[0], 0.5);
    EXPECT_EQ(ray[1], 0.5);
    EXPECT_EQ(ray[2], 0);
}

INSTANTIATE_TEST_SUITE_P(Engines, Formulas, ::testing::ValuesIn(formulaEngines()),
                         [](const auto& engine) { return engine.param.backend + "_" + engine.param.target; });

TEST(FormulaEngines, AreOfOneBackendWhereAsked) {
    EXPECT_EQ(formulaEngines("reference").size(), 1U);
    for (const FormulaEngine& engine : formulaEngines("cpu")) {
        EXPECT_EQ(engine.backend, "cpu");
    }
    for (const FormulaEngine& engine : formulaEngines("gl")) {
        EXPECT_EQ(engine.backend, "gl");
    }
    EXPECT_EQ(formulaEngines("cpu").size() + formulaEngines("gl").size() + 1, formulaEngines().size());
}

// ---- the reader -----------------------------------------------------------------------------------------------------

class FormulaReader : public ::testing::Test {
  protected:
    void TearDown() override { std::filesystem::remove(path_); }

    std::vector<FormulaVector> read(const std::string& text) {
        std::ofstream(path_, std::ios::binary) << text;
        return readFormulaVectors(path_);
    }
    /// The message; empty where nothing was refused.
    std::string refusal(const std::string& text) {
        try {
            read(text);
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::badInput);
            return error.what();
        }
        return "";
    }

    std::filesystem::path path_ =
        std::filesystem::temp_directory_path() / ("limner-vectors-" + std::to_string(::getpid()) + ".jsonl");
};

TEST_F(FormulaReader, ReadsLines) {
    const auto vectors = read("{\"f\": \"contour_width\", \"in\": [0.5], \"out\": [0.8660254037844386]}\r\n\n"
                              "{\"f\": \"importance_ray\", \"in\": [1, 0.5, 0, 0, 1, 2], \"out\": [0, 1, 2]}");
    ASSERT_EQ(vectors.size(), 2U);
    EXPECT_EQ(vectors[0].formula, Formula::contourWidth);
    EXPECT_EQ(vectors[0].out[0], 0.8660254037844386);
    EXPECT_EQ(vectors[1].in.size(), 6U);
    EXPECT_EQ(vectors[1].source, "line 3");
}

TEST_F(FormulaReader, RefusesABadLineByItsNumber) {
    const std::string good = "{\"f\": \"contour_width\", \"in\": [0.5], \"out\": [1]}\n";
    for (const std::string& bad : {
             std::string("{\"f\": \"contour_width\", \"in\": [0.5], \"out\": [1]"), // cut off
             std::string("[]"),
             std::string("{\"f\": 7, \"in\": [0.5], \"out\": [1]}"),
             std::string("{\"f\": \"contour\", \"in\": [0.5], \"out\": [1]}"),
             std::string("{\"f\": \"contour_width\", \"out\": [1]}"),
             std::string("{\"f\": \"contour_width\", \"in\": [0.5, 1], \"out\": [1]}"),
             std::string("{\"f\": \"contour_width\", \"in\": [0.5], \"out\": []}"),
             std::string("{\"f\": \"contour_width\", \"in\": [\"0.5\"], \"out\": [1]}"),
             std::string("{\"f\": \"contour_width\", \"in\": [0.1], \"out\": [1]}"), // no float32 value
             std::string("{\"f\": \"contour_width\", \"in\": [1e300], \"out\": [1]}"),
             std::string("{\"f\": \"contour_width\", \"in\": [0.5], \"out\": [1e999]}"),
             std::string("{\"f\": \"importance_ray\", \"in\": [], \"out\": [0, 0, 0]}"),
             std::string("{\"f\": \"importance_ray\", \"in\": [1, 1], \"out\": [0, 0, 0]}"),
             std::string(100'000, '['),
             std::string("\0\0", 2),
         }) {
        EXPECT_NE(refusal(good + bad + "\n").find("line 2"), std::string::npos) << bad.substr(0, 80);
    }
}

TEST_F(FormulaReader, RefusesWhatIsNoFile) {
    EXPECT_FALSE(refusal("").empty());
    EXPECT_THROW(readFormulaVectors("nowhere.jsonl"), Error);
    EXPECT_THROW(readFormulaVectors(std::filesystem::temp_directory_path()), Error);
}

} // namespace
} // namespace limner
