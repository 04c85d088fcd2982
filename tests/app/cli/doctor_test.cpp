#include "program_run.h"
#include "renderer/backend_choice.h"

#include <gtest/gtest.h>

namespace limner {
namespace {

using testing::run;

TEST(Doctor, SaysWhatTheMachineDrawsWith) {
    const auto text = run({"doctor"});
    EXPECT_EQ(text.code, 0);
    EXPECT_NE(text.out.find("Backend:"), std::string::npos) << text.out;
    EXPECT_NE(text.out.find("OpenGL, osmesa:"), std::string::npos) << text.out;
    const auto json = run({"doctor", "--json"});
    EXPECT_EQ(json.code, 0);
    const auto facts = json.facts();
    EXPECT_EQ(facts.at("backend").get<std::string>(), automaticBackend().name);
    EXPECT_GT(facts.at("memory_bytes").get<double>(), 1e8);
    EXPECT_FALSE(facts.at("instruction_sets").empty());
    for (const auto& library : facts.at("opengl")) {
        if (library.at("works").get<bool>()) {
            EXPECT_FALSE(library.at("renderer").get<std::string>().empty());
            EXPECT_GE(library.at("texture_units").get<int>(), 16);
        } else {
            EXPECT_FALSE(library.at("why").get<std::string>().empty());
        }
    }
}

TEST(Doctor, NamesAVariableThatHarms) {
    ASSERT_EQ(::setenv("LP_NUM_THREADS", "1", 1), 0);
    const auto text = run({"doctor"});
    ::unsetenv("LP_NUM_THREADS");
    EXPECT_NE(text.out.find("LP_NUM_THREADS=1"), std::string::npos) << text.out;
}

} // namespace
} // namespace limner
