#include "program_run.h"

#include <algorithm>
#include <fstream>
#include <set>

namespace limner {
namespace {

using testing::ProgramRun;
using testing::run;

class SelfTest : public ::testing::Test {
  protected:
    void TearDown() override { std::filesystem::remove(path_); }

    /// Runs on a file with these lines.
    ProgramRun runOn(const std::string& lines, const std::vector<std::string>& more = {}) {
        std::ofstream(path_) << lines;
        std::vector<std::string> arguments{"self-test", "--vectors", path_.string()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run(arguments);
    }

    static constexpr const char* kRight = "{\"f\": \"stipple_interior\", \"in\": [0.25, 0.5], \"out\": [0.5]}\n";
    static constexpr const char* kWrong = "{\"f\": \"stipple_interior\", \"in\": [0.25, 0.5], \"out\": [0.501]}\n";

    std::filesystem::path path_ =
        std::filesystem::temp_directory_path() / ("limner-self-test-" + std::to_string(::getpid()) + ".jsonl");
};

TEST_F(SelfTest, PassesOnThisMachine) {
    const ProgramRun plain = run({"self-test"});
    EXPECT_EQ(plain.code, 0) << plain.out;
    EXPECT_NE(plain.out.find("contour_width"), std::string::npos);
    EXPECT_EQ(plain.out.find("FAIL"), std::string::npos);

    const ProgramRun json = run({"self-test", "--json"});
    EXPECT_EQ(json.code, 0);
    const auto facts = json.facts();
    EXPECT_TRUE(facts.at("passed").get<bool>());
    std::set<std::string> backends;
    for (const auto& entry : facts.at("formulas")) {
        backends.insert(entry.at("backend").get<std::string>());
        EXPECT_TRUE(entry.at("passed").get<bool>());
        EXPECT_GT(entry.at("count").get<int>(), 0);
        for (const char* key : {"largest_absolute", "largest_relative"}) {
            EXPECT_TRUE(entry.at(key).is_number()) << key;
        }
        for (const char* key : {"target", "formula", "worst", "bound"}) {
            EXPECT_TRUE(entry.at(key).is_string()) << key;
        }
    }
    backends.erase("gl"); // where OpenGL works
    EXPECT_EQ(backends, (std::set<std::string>{"cpu", "reference"}));
}

TEST_F(SelfTest, RunsOneBackendOnly) {
    for (const std::string backend : {"cpu", "reference"}) {
        const ProgramRun r = run({"self-test", "--backend", backend, "--json"});
        ASSERT_EQ(r.code, 0);
        for (const auto& entry : r.facts().at("formulas")) {
            EXPECT_EQ(entry.at("backend"), backend);
        }
    }
    const ProgramRun unknown = run({"self-test", "--backend", "vulkan"});
    EXPECT_EQ(unknown.code, 2);
    EXPECT_NE(unknown.err.find("use reference, cpu, gl"), std::string::npos) << unknown.err;
}

TEST_F(SelfTest, FailsWithTheWorstLineAndNine) {
    EXPECT_EQ(runOn(kRight).code, 0);
    const ProgramRun failed = runOn(std::string(kRight) + kWrong, {"--backend", "reference"});
    EXPECT_EQ(failed.code, 9);
    EXPECT_NE(failed.out.find("line 2"), std::string::npos) << failed.out;
    EXPECT_NE(failed.out.find("FAIL"), std::string::npos) << failed.out;
    const auto facts = runOn(std::string(kRight) + kWrong, {"--json"}).facts();
    EXPECT_FALSE(facts.at("passed").get<bool>());
    EXPECT_NEAR(facts.at("formulas").at(0).at("largest_absolute").get<double>(), 0.001, 1e-12);
}

TEST_F(SelfTest, RefusesABadFileByItsLine) {
    const ProgramRun bad = runOn(std::string(kRight) + "{\"f\": \"stipple_interior\"}\n");
    EXPECT_EQ(bad.code, 3);
    EXPECT_EQ(bad.out, "");
    EXPECT_NE(bad.err.find("line 2"), std::string::npos) << bad.err;
    EXPECT_EQ(run({"self-test", "--vectors", "nowhere.jsonl"}).code, 3);
}

} // namespace
} // namespace limner
