#include "core/concurrency/worker_pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace gripscan {
namespace {

class Pools : public testing::TestWithParam<unsigned> {};

TEST_P(Pools, EveryTurnIsTakenOnce) {
    WorkerPool pool(GetParam());
    EXPECT_EQ(pool.threads(), GetParam());
    const ForEach for_each = pool.for_each();
    for (const std::size_t n : {0, 1, 2, 3, 7, 1000, 100000}) {
        std::vector<std::atomic<int>> taken(n);
        for_each(n, [&](std::size_t i) { taken[i].fetch_add(1, std::memory_order_relaxed); });
        for (std::size_t i = 0; i < n; ++i) ASSERT_EQ(taken[i].load(), 1) << i << " of " << n;
    }
}

TEST_P(Pools, SlotsAddUpToTheSameBits) {
    WorkerPool pool(GetParam());
    std::vector<double> slots(5000);
    pool.for_each()(slots.size(),
                    [&](std::size_t i) { slots[i] = 1.0 / (1.0 + static_cast<double>(i)); });
    double sum = 0.0;
    for (const double x : slots) sum += x;
    double expected = 0.0;
    for (std::size_t i = 0; i < slots.size(); ++i) expected += 1.0 / (1.0 + static_cast<double>(i));
    EXPECT_EQ(sum, expected);
}

TEST_P(Pools, LoopsInsideLoopsNeitherDeadlockNorLoseTurns) {
    WorkerPool pool(GetParam());
    const ForEach for_each = pool.for_each();
    std::atomic<int> turns{0};
    for_each(20, [&](std::size_t) {
        for_each(20, [&](std::size_t) { for_each(3, [&](std::size_t) { turns.fetch_add(1); }); });
    });
    EXPECT_EQ(turns.load(), 20 * 20 * 3);
}

TEST_P(Pools, AnExceptionReachesTheCallerAndThePoolStaysUsable) {
    WorkerPool pool(GetParam());
    const ForEach for_each = pool.for_each();
    for (int round = 0; round < 20; ++round) {
        EXPECT_THROW(for_each(100,
                              [](std::size_t i) {
                                  if (i == 37) throw std::runtime_error("37");
                              }),
                     std::runtime_error);
        std::atomic<int> turns{0};
        for_each(100, [&](std::size_t) { turns.fetch_add(1); });
        EXPECT_EQ(turns.load(), 100);
    }
}

TEST_P(Pools, ManyShortLoopsInARow) {
    WorkerPool pool(GetParam());
    const ForEach for_each = pool.for_each();
    std::size_t sum = 0;
    for (std::size_t loop = 0; loop < 3000; ++loop) {
        std::vector<std::size_t> slots(5);
        for_each(slots.size(), [&](std::size_t i) { slots[i] = i + loop; });
        for (const std::size_t x : slots) sum += x;
    }
    EXPECT_EQ(sum, 5U * 3000U * 2999U / 2U + 3000U * 10U);
}

INSTANTIATE_TEST_SUITE_P(Threads, Pools, testing::Values(1, 2, 3, 4, 5, 6, 7, 8));

TEST(WorkerPool, UsesItsThreads) {
    WorkerPool pool(4);
    std::vector<std::thread::id> ids(64);
    pool.for_each()(ids.size(), [&](std::size_t i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        ids[i] = std::this_thread::get_id();
    });
    EXPECT_GT(std::set<std::thread::id>(ids.begin(), ids.end()).size(), 1U);
}

TEST(WorkerPool, TwoCallersTakeTurns) {
    WorkerPool pool(3);
    const ForEach for_each = pool.for_each();
    std::atomic<int> turns{0};
    const auto caller = [&] {
        for (int i = 0; i < 100; ++i) for_each(50, [&](std::size_t) { turns.fetch_add(1); });
    };
    {
        const std::jthread first(caller);
        const std::jthread second(caller);
    }
    EXPECT_EQ(turns.load(), 2 * 100 * 50);
}

TEST(ThreadsWanted, TakesASensibleNumberFromTheEnvironment) {
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    const auto wanted_with = [](const char* text) {
        ::setenv("GRIPSCAN_THREADS", text, 1);
        const unsigned wanted = threads_wanted();
        ::unsetenv("GRIPSCAN_THREADS");
        return wanted;
    };
    EXPECT_EQ(threads_wanted(), cores);
    EXPECT_EQ(wanted_with("1"), 1U);
    EXPECT_EQ(wanted_with("7"), 7U);
    for (const char* text : {"0", "-2", "many", "", "99999", "nan"}) {
        EXPECT_EQ(wanted_with(text), cores) << text;
    }
}

}  // namespace
}  // namespace gripscan
