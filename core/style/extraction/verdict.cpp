#include "core/style/extraction/verdict.h"

namespace limner {
namespace {

// Against what one sees: two balls side by side look the same at a hundredth, alike at three, different at eight.
constexpr double kSeen = 0.01;
constexpr double kPlain = 0.03;
constexpr double kStriking = 0.08;
/// A quarter more depth moves soft shading by 0.02; twice that, and edges of light are at stake.
constexpr double kUncertain = 0.05;
/// Below half, most of what is drawn would come from filling.
constexpr double kLittleCoverage = 0.5;
/// A ninth of the half turn that a ball shows: one sees that there is something missing.
constexpr double kWideHole = 40;

std::string placementWords(double rmse) {
    if (rmse < kSeen) {
        return "the outline sits on the edge";
    }
    if (rmse < kPlain) {
        return "the outline is a little off the edge";
    }
    return "the outline is off the edge";
}

} // namespace

Verdict verdictOf(const ExtractionFigures& figures, bool region) {
    Verdict verdict;
    if (figures.formRmse && region) {
        verdict.form = *figures.formRmse < kPlain ? "its depth matters little" : "its depth matters";
        if (*figures.formRmse >= kUncertain) {
            verdict.advice.emplace_back(
                "How deep the form is no picture tells, and here it matters: set the depth in the "
                "marks, or mark some normals inside it.");
        }
    } else if (figures.formRmse) {
        verdict.form = placementWords(*figures.formRmse);
        if (*figures.formRmse >= kPlain) {
            verdict.advice.emplace_back("The outline does not follow the picture's edge, so colours come to lie at the "
                                        "wrong places of the ball: snap it, or move it by hand.");
        }
    }
    if (figures.residualRmse >= kStriking) {
        verdict.advice.emplace_back(
            "Shaded again by this ball the region looks different: the form is rounder or "
            "flatter than its outline, or its colour is more texture than light. Take a plainer "
            "part, mark some normals, or separate the texture.");
    }
    if (figures.coverage < kLittleCoverage) {
        verdict.advice.emplace_back("Less than half of the ball was seen; the rest is filled in smoothly: take a form "
                                    "that shows more of its sides, or ignore less.");
    }
    if (figures.largestHoleDegrees >= kWideHole) {
        verdict.advice.emplace_back("One side of the ball was not seen at all and is filled in smoothly: take a form "
                                    "that turns that way too, or make the style symmetric.");
    }
    return verdict;
}

} // namespace limner
