#include "widgets/newest_job.h"

#include "support/qt/qt_events.h"
#include "widgets/job.h"

#include <gtest/gtest.h>

#include <atomic>
#include <semaphore>
#include <vector>

namespace limner {
namespace {

using testing::pumpUntil;

/// Work that waits to be let go, or for its cancellation.
NewestJob::Work held(std::binary_semaphore& gate) {
    return [&gate](Task& task) {
        while (!gate.try_acquire_for(std::chrono::milliseconds(1)))
            task.throwIfCancelled();
    };
}

TEST(NewestJob, OnlyTheNewestIsHeardOf) {
    NewestJob job("Work", nullptr);
    std::binary_semaphore gate(0);
    std::vector<int> done;
    job.want(held(gate), [&] { done.push_back(1); });
    job.want([](Task&) {}, [&] { done.push_back(2); });
    job.want([](Task&) {}, [&] { done.push_back(3); });
    ASSERT_TRUE(pumpUntil([&] { return !job.busy(); }));
    EXPECT_EQ(done, std::vector<int>{3}) << "the first was cancelled, the second never begun";
}

TEST(NewestJob, WhatRunsMayCompleteWhileAHandMoves) {
    NewestJob job("Work", nullptr);
    std::binary_semaphore gate(0);
    std::vector<int> done;
    job.want(held(gate), [&] { done.push_back(1); });
    job.want([](Task&) {}, [&] { done.push_back(2); }, NewestJob::Running::complete);
    job.want([](Task&) {}, [&] { done.push_back(3); }, NewestJob::Running::complete);
    gate.release();
    ASSERT_TRUE(pumpUntil([&] { return !job.busy(); }));
    EXPECT_EQ(done, (std::vector<int>{1, 3}));
}

TEST(NewestJob, AFailureOfTheNewestIsTold) {
    NewestJob job("Work", nullptr);
    std::vector<std::string> told;
    QObject::connect(&job, &NewestJob::failed, [&](const Error& error) { told.push_back(error.text().what); });
    std::binary_semaphore gate(0);
    job.want(
        [&gate](Task&) {
            gate.acquire();
            throw Error(ErrorKind::badInput, {"old", "", "", ""});
        },
        [] {});
    job.want([](Task&) { throw Error(ErrorKind::badInput, {"new", "", "", ""}); }, [] {});
    gate.release();
    ASSERT_TRUE(pumpUntil([&] { return !job.busy(); }));
    EXPECT_EQ(told, std::vector<std::string>{"new"});
}

TEST(NewestJob, ItIsToldWhenSomeoneElseStopsIt) {
    NewestJob job("Work", nullptr);
    int stopped = 0;
    QObject::connect(&job, &NewestJob::stopped, [&] { ++stopped; });
    std::binary_semaphore gate(0);
    job.want(held(gate), [] {});
    job.job()->cancel();
    ASSERT_TRUE(pumpUntil([&] { return !job.busy(); }));
    EXPECT_EQ(stopped, 1);
    job.want(held(gate), [] {});
    job.drop();
    ASSERT_TRUE(pumpUntil([&] { return !job.busy(); }));
    EXPECT_EQ(stopped, 1) << "it was not wanted any more";
}

TEST(NewestJob, DroppedWorkIsNotHeardOfAndItsEndIsWaitedFor) {
    std::atomic<bool> left{false};
    bool done = false;
    {
        NewestJob job("Work", nullptr);
        job.want(
            [&](Task& task) {
                while (!task.cancelled()) {
                }
                left = true;
            },
            [&] { done = true; });
        job.drop();
    }
    EXPECT_TRUE(left);
    EXPECT_FALSE(done);
}

TEST(NewestJob, NewWorkMayBeAskedForAtTheEndOfTheOld) {
    NewestJob job("Work", nullptr);
    std::vector<int> done;
    job.want([](Task&) {},
             [&] {
                 done.push_back(1);
                 job.want([](Task&) {}, [&] { done.push_back(2); });
             });
    ASSERT_TRUE(pumpUntil([&] { return done.size() == 2 && !job.busy(); }));
}

} // namespace
} // namespace limner
