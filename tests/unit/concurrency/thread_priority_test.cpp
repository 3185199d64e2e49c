#include "core/concurrency/thread_priority.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <thread>

namespace gripscan {
namespace {

int niceness() {
    return ::getpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()));
}

TEST(ThreadPriority, ABackgroundThreadAndItsChildrenLetOthersGoFirst) {
    const int ordinary = niceness();
    if (ordinary >= 10) GTEST_SKIP() << "the test itself runs in the background";
    int background = ordinary;
    int child = ordinary;
    std::thread([&] {
        work_in_background();
        background = niceness();
        std::thread([&] { child = niceness(); }).join();
    }).join();
    EXPECT_GT(background, ordinary);
    EXPECT_EQ(child, background);
    EXPECT_EQ(niceness(), ordinary);
}

}  // namespace
}  // namespace gripscan
