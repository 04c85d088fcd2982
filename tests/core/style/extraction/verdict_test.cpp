#include "core/style/extraction/verdict.h"

#include <gtest/gtest.h>

namespace limner {
namespace {

ExtractionFigures good() {
    ExtractionFigures figures;
    figures.coverage = 0.95;
    figures.residualRmse = 0.01;
    figures.largestHoleDegrees = 6;
    figures.formRmse = 0.004;
    return figures;
}

TEST(Verdict, GoodFiguresNeedNoAdvice) {
    EXPECT_TRUE(verdictOf(good(), false).advice.empty());
    EXPECT_EQ(verdictOf(good(), false).form, "the outline sits on the edge");
    ExtractionFigures region = good();
    region.formRmse.reset();
    EXPECT_EQ(verdictOf(region, false).form, "");
}

TEST(Verdict, EveryBadFigureHasItsOwnAdvice) {
    const auto only = [](const auto& spoil) {
        ExtractionFigures figures = good();
        spoil(figures);
        const std::vector<std::string> advice = verdictOf(figures, false).advice;
        EXPECT_EQ(advice.size(), 1U);
        return advice.empty() ? std::string() : advice.front();
    };
    EXPECT_NE(only([](auto& f) { f.formRmse = 0.05; }).find("snap"), std::string::npos);
    EXPECT_NE(only([](auto& f) { f.residualRmse = 0.2; }).find("texture"), std::string::npos);
    EXPECT_NE(only([](auto& f) { f.coverage = 0.3; }).find("half"), std::string::npos);
    EXPECT_NE(only([](auto& f) { f.largestHoleDegrees = 80; }).find("side"), std::string::npos);
}

TEST(Verdict, OfARegionItIsTheDepthThatIsUnknown) {
    ExtractionFigures figures = good();
    EXPECT_EQ(verdictOf(figures, true).form, "its depth matters little");
    figures.formRmse = 0.1;
    ASSERT_EQ(verdictOf(figures, true).advice.size(), 1U);
    EXPECT_NE(verdictOf(figures, true).advice[0].find("depth"), std::string::npos);
}

} // namespace
} // namespace limner
