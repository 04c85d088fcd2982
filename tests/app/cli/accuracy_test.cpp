#include "program_run.h"

#include <set>

namespace limner {
namespace {

using testing::run;

class Accuracy : public testing::WithScan {
  protected:
    std::vector<std::string> study(std::vector<std::string> more) const {
        std::vector<std::string> all = {"accuracy", scan(),  "--preset",      "skull",
                                        "--size",   "64x64", "--time-budget", "20"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
};

TEST_F(Accuracy, ReportsErrorAgainstTime) {
    const auto result = run(study({"--json", "-o", path("report.html")}));
    EXPECT_EQ(result.code, 0) << result.err;
    const auto facts = result.facts();
    EXPECT_EQ(facts.at("width"), 64);
    EXPECT_FALSE(facts.at("rows").empty());
    EXPECT_FALSE(facts.at("limiting_knob").get<std::string>().empty());
    EXPECT_GT(facts.at("reference").at("error_bar").get<double>(), 0);
    EXPECT_TRUE(exists("report.html"));
    for (const char* name : {"report.csv", "report.json"}) {
        EXPECT_EQ(run(study({"--quiet", "-o", path(name)})).code, 0);
        EXPECT_TRUE(exists(name));
    }
}

TEST_F(Accuracy, RefusesWhatMakesNoSense) {
    for (const std::vector<std::string>& wrong : {std::vector<std::string>{"-o", path("report.txt")},
                                                  {"-o", path("no/report.html")},
                                                  {"--apply"},
                                                  {"--tolerance", "fine"},
                                                  {"--tolerance", "-1"},
                                                  {"--metric", "taste"},
                                                  {"--knobs", "colour"}}) {
        const auto result = run(study(wrong));
        EXPECT_EQ(result.code, 2) << wrong.front() << result.out;
        EXPECT_NE(result.err.find(wrong.front() == "-o" ? "report" : wrong.front()), std::string::npos) << result.err;
    }
    EXPECT_EQ(filesLeft(), 1U) << "only the scan";
}

TEST_F(Accuracy, AppliesTheSettingsToAProject) {
    ASSERT_EQ(run({"new", scan(), "-o", path("head.limner"), "--preset", "skull"}).code, 0);
    const auto result =
        run({"accuracy", path("head.limner"), "--size", "64x64", "--tolerance", "draft", "--apply", "--quiet"});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_TRUE(exists("head.limner~")) << "the old one is kept";
}

TEST_F(Accuracy, ATolerancesPictureSaysWhatItDelivers) {
    const auto result = run({"render", scan(), "--preset", "skull", "--size", "64x64", "--tolerance", "screen",
                             "--json", "-o", path("head.png")});
    EXPECT_EQ(result.code, 0) << result.err;
    const auto tolerance = result.facts().at("tolerance");
    EXPECT_EQ(tolerance.at("asked"), 1.5);
    EXPECT_TRUE(tolerance.at("reached").get<bool>());
    EXPECT_LE(tolerance.at("delivered").get<double>(), 1.5);
    EXPECT_FALSE(tolerance.at("settings").get<std::string>().empty());
}

TEST_F(Accuracy, TestsTheScenesWithKnownResults) {
    const auto result = run({"accuracy", "--self-test", "--backend", "cpu", "--json"});
    EXPECT_EQ(result.code, 0) << result.out;
    const auto facts = result.facts();
    EXPECT_TRUE(facts.at("passed").get<bool>());
    std::set<std::string> scenes;
    for (const auto& row : facts.at("scenes"))
        scenes.insert(row.at("scene").get<std::string>());
    EXPECT_EQ(scenes, (std::set<std::string>{"A1", "A2", "A3", "A4", "A5", "A6", "A7", "A8"}));
    EXPECT_EQ(run({"accuracy"}).code, 2) << "a figure is missing";
}

TEST_F(Accuracy, WhatCannotBeToldIsExitCode7) {
    const auto result = run({"render", scan(), "--preset", "skull", "--size", "64x64", "--tolerance", "1e-9",
                             "--metric", "max", "-o", path("head.png")});
    EXPECT_EQ(result.code, 7) << result.out;
    EXPECT_FALSE(exists("head.png")) << "nothing is claimed";
}

} // namespace
} // namespace limner
