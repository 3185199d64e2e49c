// Each in a process of its own: signals belong to the whole process.
#include "app/interrupt.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "app/context.h"

namespace gripscan::app {
namespace {

using namespace std::chrono_literals;

/// No other exit status of these tests.
constexpr int kAsked = 40;
constexpr int kNeverAsked = 41;

/// Sends a signal to this process and waits until a stop is asked for; false: it never was.
bool asked_after(const Interrupt& interrupt, int signal) {
    ::kill(::getpid(), signal);
    for (int i = 0; i < 500 && !interrupt.token().stop_requested(); ++i) {
        std::this_thread::sleep_for(10ms);
    }
    return interrupt.token().stop_requested();
}

[[noreturn]] void one_request(int signal, int times) {
    const Interrupt interrupt;
    bool asked = false;
    for (int i = 0; i < times; ++i) asked = asked_after(interrupt, signal);
    std::this_thread::sleep_for(100ms);  // the last is taken by the listener's thread
    std::_Exit(asked ? kAsked : kNeverAsked);
}

[[noreturn]] void again_later(int signal) {
    const Interrupt interrupt;
    if (!asked_after(interrupt, signal)) std::_Exit(kNeverAsked);
    std::this_thread::sleep_for(700ms);
    ::kill(::getpid(), signal);
    std::this_thread::sleep_for(5s);
    std::_Exit(kAsked);
}

class Interrupts : public testing::TestWithParam<int> {
  protected:
    Interrupts() { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};

TEST_P(Interrupts, AskForAStop) {
    EXPECT_EXIT(one_request(GetParam(), 1), testing::ExitedWithCode(kAsked), "");
}

/// As `timeout` sends them: to the process, and to its group.
TEST_P(Interrupts, ThatComeTogetherAreOne) {
    EXPECT_EXIT(one_request(GetParam(), 2), testing::ExitedWithCode(kAsked), "");
}

TEST_P(Interrupts, AgainLaterEndTheProgram) {
    EXPECT_EXIT(again_later(GetParam()), testing::ExitedWithCode(kCancelled), "");
}

INSTANTIATE_TEST_SUITE_P(OfBothKinds, Interrupts, testing::Values(SIGINT, SIGTERM),
                         [](const auto& one) {
                             return one.param == SIGINT ? std::string("SigInt") : "SigTerm";
                         });

}  // namespace
}  // namespace gripscan::app
