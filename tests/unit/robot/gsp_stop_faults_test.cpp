// STOP over a monitor connection in trouble, over real sockets: the arm stops whatever becomes of
// the reply.
#include <gtest/gtest.h>

#include <functional>
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

constexpr std::array kTroubles{Mischief::kDrop,   Mischief::kHalfOpen, Mischief::kNever,
                               Mischief::kLate,   Mischief::kGarbled,  Mischief::kSplit,
                               Mischief::kJoined, Mischief::kTwice,    Mischief::kBabble};

/// A turn of a minute under way.
class Turning {
  public:
    Turning(MockController& controller, GspSettings settings,
            std::function<void(const RobotBeat&)> on_beat = {})
        : link(with_patience(std::move(settings))) {
        controller.turns_for(std::chrono::minutes(1));
        link.on_beat(std::move(on_beat));
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

// A connection that has gone silent: STOP does not wait for what hangs on it.

/// Questions are waited for as good as for ever.
GspSettings patient_settings(const MockController& controller) {
    auto settings = test::quick_settings(controller);
    settings.reply_limit = std::chrono::seconds(30);
    settings.connect_limit = std::chrono::seconds(30);
    return settings;
}

/// Twice the patience, and something for a busy machine.
constexpr milliseconds kSoon = 2 * GspMonitor::kStopPatience + milliseconds(1500);

bool halts_soon(MockController& controller) {
    const auto limit = deadline_in(kSoon);
    while (controller.arm().moving()) {
        if (steady_clock::now() >= limit) return false;
        std::this_thread::sleep_for(milliseconds(1));
    }
    return true;
}

/// Waits until a beat hangs.
void expect_no_more_beats(const std::atomic<int>& beats) {
    for (int i = 0; i < 100; ++i) {
        const int before = beats;
        std::this_thread::sleep_for(milliseconds(150));
        if (beats == before) return;
    }
    ADD_FAILURE() << "the heart still beats";
}

struct Silence {
    std::string what;
    std::vector<std::pair<Point, Mischief>> script;
};

const std::vector<Silence>& silences() {
    static const std::vector<Silence> all{
        {"the beat is not answered", {{Point::kQuestion, Mischief::kNever}}},
        {"the beat's connection is half-open", {{Point::kQuestion, Mischief::kHalfOpen}}},
        {"the beat is answered with empty lines", {{Point::kQuestion, Mischief::kBabble}}},
        {"the beat's new connection is not greeted",
         {{Point::kQuestion, Mischief::kDrop}, {Point::kMonitorHello, Mischief::kNever}}},
        {"the beat's new connection is half-open",
         {{Point::kQuestion, Mischief::kDrop}, {Point::kMonitorHello, Mischief::kHalfOpen}}},
    };
    return all;
}

/// Calls `stop` with a turn under way behind each silence, once its beat hangs.
void behind_each_silence(const std::function<void(Turning&, MockController&)>& stop) {
    for (const Silence& silence : silences()) {
        SCOPED_TRACE(silence.what);
        MockController controller;
        std::atomic<int> beats = 0;
        Turning turning(controller, patient_settings(controller),
                        [&](const RobotBeat&) { ++beats; });
        for (const auto& [point, mischief] : silence.script) controller.at(point, mischief);
        expect_no_more_beats(beats);
        stop(turning, controller);
    }
}

TEST(GspStopFaults, StopDoesNotWaitForABeatThatHangs) {
    behind_each_silence([](Turning& turning, MockController& controller) {
        const auto begin = steady_clock::now();
        const auto stopped = turning.link.stop();
        EXPECT_LT(steady_clock::now() - begin, kSoon);
        EXPECT_TRUE(stopped) << stopped.error().message;
        expect_stopped(turning.outcome(), controller);
        EXPECT_TRUE(turning.link.read()) << "the question that made way is not missed";
    });
}

TEST(GspStopFaults, AStopRequestDoesNotWaitForABeatThatHangs) {
    behind_each_silence([](Turning& turning, MockController& controller) {
        turning.request_stop();
        EXPECT_TRUE(halts_soon(controller));
        expect_stopped(turning.outcome(), controller);
    });
}

TEST(GspStopFaults, StopIsOutBeforeAnythingIsAnswered) {
    MockController controller;
    std::atomic<int> beats = 0;
    auto settings = patient_settings(controller);
    settings.reply_limit = milliseconds(3000);
    Turning turning(controller, settings, [&](const RobotBeat&) { ++beats; });
    // A controller that hears on every connection and answers on none.
    for (const Point point : {Point::kQuestion, Point::kMonitorHello, Point::kStop}) {
        controller.at(point, Mischief::kNever, kForEver);
    }
    expect_no_more_beats(beats);
    auto stopped = std::async(std::launch::async, [&] { return turning.link.stop(); });
    EXPECT_TRUE(halts_soon(controller));
    EXPECT_FALSE(stopped.get());
    expect_stopped(turning.outcome(), controller);
    controller.heals();
}

TEST(GspStopFaults, StopOnAConnectionThatDiedUnnoticedIsSaidOnANewOne) {
    for (const Mischief m : {Mischief::kHalfOpen, Mischief::kDrop}) {
        SCOPED_TRACE(name_of(m));
        MockController controller;
        auto settings = patient_settings(controller);
        settings.beat_period = settings.beat_period_moving = std::chrono::minutes(5);
        Turning turning(controller, settings);
        ASSERT_TRUE(turning.link.read()) << "no beat is under way behind it";
        controller.at(Point::kMonitorRequest, m);
        EXPECT_TRUE(turning.link.stop());
        EXPECT_TRUE(halts_soon(controller));
        expect_stopped(turning.outcome(), controller);
    }
}

TEST(GspStopFaults, QuestionsOfManyThreadsDoNotHoldItUp) {
    MockController controller;
    Turning turning(controller, patient_settings(controller));
    std::atomic<bool> going_on = true;
    std::vector<std::jthread> askers;
    for (int i = 0; i < 4; ++i) {
        askers.emplace_back([&] {
            while (going_on) (void)turning.link.read();
        });
    }
    controller.at(Point::kQuestion, Mischief::kNever, kForEver);
    std::this_thread::sleep_for(milliseconds(150));
    const auto begin = steady_clock::now();
    EXPECT_TRUE(turning.link.stop());
    EXPECT_LT(steady_clock::now() - begin, kSoon);
    EXPECT_TRUE(halts_soon(controller));
    controller.heals();
    going_on = false;
    while (!turning.link.stop()) std::this_thread::yield();  // cuts the last question that hangs
    askers.clear();
    expect_stopped(turning.outcome(), controller);
}

}  // namespace
}  // namespace gripscan::gsp
