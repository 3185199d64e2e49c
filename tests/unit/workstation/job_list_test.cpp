#include "app/workstation/job_list.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace gripscan::app {
namespace {
using namespace std::chrono_literals;

void pump_until(JobList& jobs, const std::atomic<bool>& done) {
    for (int i = 0; i < 1000 && !done; ++i) {
        jobs.pump();
        std::this_thread::sleep_for(2ms);
    }
}

TEST(JobList, TheOutcomeIsTakenInOnTheCallersThread) {
    std::atomic<int> woken = 0;
    JobList jobs([&] { ++woken; });
    std::atomic<bool> done = false;
    std::thread::id worked_on;
    std::thread::id taken_on;
    jobs.start("Export", [&](const Progress& progress) -> JobList::Outcome {
        worked_on = std::this_thread::get_id();
        progress.tell("points", 1, 4);
        return [&] {
            taken_on = std::this_thread::get_id();
            done = true;
        };
    });
    EXPECT_TRUE(jobs.running("Export"));
    pump_until(jobs, done);
    EXPECT_EQ(taken_on, std::this_thread::get_id());
    EXPECT_NE(worked_on, taken_on);
    EXPECT_GE(woken, 2) << "progress and end wake the window";
    EXPECT_FALSE(jobs.running("Export"));
    EXPECT_FALSE(jobs.shown());
}

TEST(JobList, ANewJobOfTheSameNameReplacesTheOneBefore) {
    JobList jobs([] {});
    std::atomic<bool> first_cancelled = false;
    std::atomic<bool> done = false;
    std::atomic<int> outcomes = 0;
    jobs.start("Filter", [&](const Progress& progress) -> JobList::Outcome {
        while (!progress.cancelled()) std::this_thread::sleep_for(1ms);
        first_cancelled = true;
        return [&] { outcomes += 10; };
    });
    jobs.start("Filter", [&](const Progress&) -> JobList::Outcome {
        return [&] {
            ++outcomes;
            done = true;
        };
    });
    pump_until(jobs, done);
    pump_until(jobs, first_cancelled);
    jobs.pump();
    EXPECT_TRUE(first_cancelled);
    EXPECT_EQ(outcomes, 1) << "the outcome of the first is never taken";
}

TEST(JobList, AnOutcomeMayStartTheNextJob) {
    JobList jobs([] {});
    std::atomic<bool> done = false;
    jobs.start("one", [&](const Progress&) -> JobList::Outcome {
        return [&] {
            jobs.start("two",
                       [&](const Progress&) -> JobList::Outcome { return [&] { done = true; }; });
        };
    });
    pump_until(jobs, done);
    EXPECT_TRUE(done);
}

TEST(JobList, TheEndCancelsAndWaits) {
    std::atomic<bool> ended = false;
    {
        JobList jobs([] {});
        jobs.start("endless", [&](const Progress& progress) -> JobList::Outcome {
            while (!progress.cancelled()) std::this_thread::sleep_for(1ms);
            ended = true;
            return {};
        });
    }
    EXPECT_TRUE(ended);
}

}  // namespace
}  // namespace gripscan::app
