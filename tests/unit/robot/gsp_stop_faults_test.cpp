// STOP over a monitor connection in trouble, over real sockets: the arm stops whatever becomes of
// the reply.
#include <gtest/gtest.h>

#include <future>

#include "tests/support/gsp_link_settings.h"
#include "tests/unit/robot/one_turn.h"
#include "tests/unit/robot/printers.h"

namespace gripscan::gsp {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;
using test::Mischief;
using test::MockController;
using test::Point;

constexpr int kForEver = 100000;
constexpr std::array kTroubles{Mischief::kDrop,   Mischief::kHalfOpen, Mischief::kNever,
                               Mischief::kLate,   Mischief::kGarbled,  Mischief::kSplit,
                               Mischief::kJoined, Mischief::kTwice,    Mischief::kBabble};

/// A turn of a minute under way.
class Turning {
  public:
    explicit Turning(MockController& controller, GspSettings settings)
        : link(with_patience(std::move(settings))) {
        controller.turns_for(std::chrono::minutes(1));
        EXPECT_TRUE(link.connect());
        outcome_ = std::async(std::launch::async,
                              [this] { return link.turn_joint6(kTurn, stop_.get_token()); });
        while (!controller.arm().moving()) std::this_thread::sleep_for(milliseconds(1));
    }
    void request_stop() { stop_.request_stop(); }
    RobotResult<RobotReading> outcome() { return outcome_.get(); }

    GspLink link;

  private:
    static GspSettings with_patience(GspSettings settings) {
        settings.done_margin = std::chrono::minutes(2);
        return settings;
    }
    std::stop_source stop_;
    std::future<RobotResult<RobotReading>> outcome_;
};

void expect_stopped(const RobotResult<RobotReading>& outcome, MockController& controller) {
    ASSERT_FALSE(outcome);
    EXPECT_EQ(outcome.error().fault, RobotFault::kStopped) << outcome.error().message;
    EXPECT_FALSE(controller.arm().moving());
    EXPECT_LT(controller.arm().travelled_deg(), kTarget_deg / 2);
}

TEST(GspStopFaults, AStopRequestStopsTheArmWhateverBecomesOfTheReply) {
    for (const int times : {1, kForEver}) {
        for (const Mischief m : kTroubles) {
            SCOPED_TRACE(name_of(m) + (times == 1 ? "" : " for ever"));
            MockController controller;
            Turning turning(controller, test::quick_settings(controller));
            controller.at(Point::kStop, m, times);
            turning.request_stop();
            expect_stopped(turning.outcome(), controller);
            controller.heals();
        }
    }
}

TEST(GspStopFaults, AReplyThatGetsLostIsAskedForOnceMoreAndThenToldAsLost) {
    for (const int times : {1, kForEver}) {
        for (const Mischief m : kTroubles) {
            SCOPED_TRACE(name_of(m) + (times == 1 ? "" : " for ever"));
            MockController controller;
            Turning turning(controller, test::quick_settings(controller));
            controller.at(Point::kStop, m, times);
            const auto& settings = turning.link.settings();
            const auto begin = steady_clock::now();
            const auto stopped = turning.link.stop();
            EXPECT_LT(steady_clock::now() - begin,
                      2 * (settings.connect_limit + 2 * settings.reply_limit));
            const bool heals = times == 1 || m == Mischief::kSplit || m == Mischief::kTwice;
            // A late reply may still be under way when it is asked for once more.
            if (m != Mischief::kLate) {
                EXPECT_EQ(stopped.has_value(), heals);
            }
            expect_stopped(turning.outcome(), controller);
            controller.heals();
        }
    }
}

}  // namespace
}  // namespace gripscan::gsp
