#include "core/base/task.h"

#include "core/base/error.h"

#include <gtest/gtest.h>

namespace limner {
namespace {

struct Recorder : TaskListener {
    std::vector<double> fractions;
    std::vector<std::string> phases;
    void progressed(const std::string& phase, double fraction) override {
        phases.push_back(phase);
        fractions.push_back(fraction);
    }
    void warned(const std::string&) override {}
};

TEST(Task, ProgressNeverFallsWithinAPhase) {
    Recorder recorder;
    Task task(recorder);
    task.beginPhase("one");
    task.progress(0.5);
    task.progress(0.2);
    task.progress(7);
    task.beginPhase("two");
    EXPECT_EQ(recorder.fractions, (std::vector<double>{0, 0.5, 0.5, 1, 0}));
}

TEST(Task, APartMovesItsShareOfTheWhole) {
    Recorder recorder;
    Task whole(recorder);
    whole.beginPhase("whole");
    Task part(whole, 0.5, 0.75);
    part.beginPhase("not shown");
    part.progress(0);
    part.progress(0.5);
    part.progress(1);
    EXPECT_EQ(recorder.fractions, (std::vector<double>{0, 0.5, 0.625, 0.75}));
    EXPECT_EQ(recorder.phases.back(), "whole");
    part.warn("careful");
    EXPECT_EQ(whole.warnings(), std::vector<std::string>{"careful"});
    EXPECT_EQ(part.warnings(), whole.warnings());
}

TEST(Task, APartIsCancelledWithTheWholeButNotTheOtherWay) {
    Task whole;
    Task part(whole, 0, 1);
    part.cancel();
    EXPECT_FALSE(whole.cancelled());
    Task other(whole, 0, 1);
    EXPECT_NO_THROW(other.throwIfCancelled());
    whole.cancel();
    EXPECT_THROW(other.throwIfCancelled(), Error);
}

} // namespace
} // namespace limner
