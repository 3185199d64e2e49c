// The procedure over real sockets, with faults of link and controller in the middle of its turn: a
// picture never belongs to another angle than the one it is kept with, and the turn is completed.
#include <gmock/gmock.h>

#include <cctype>
#include <opencv2/core.hpp>
#include <thread>

#include "core/procedure/engine.h"
#include "core/procedure/exposure.h"
#include "core/procedure/robot_effects.h"
#include "core/robot/gsp_link.h"
#include "core/sim/cabinet.h"
#include "core/sim/sim_cell.h"
#include "tests/support/fake_work.h"

namespace gripscan::test {
namespace {

using namespace std::chrono_literals;

/// Standing exactly, a joint is off by its repeatability and its encoder: six deviations of both.
constexpr double kStanding_deg = 6.0 * (0.005 + 0.001);

/// Where joint 6 truly was when each picture was taken.
class NotingCamera : public StereoSource {
  public:
    explicit NotingCamera(SimCell& cell) : cell_(cell) {}
    Result<StereoFrame> grab(const FrameRequest& request) override {
        const sim::ArmState arm = cell_.cabinet().arm();
        if (request.exposure == 0) truly_rad[request.capture] = arm.true_rad[5];
        moved = moved || arm.moving;
        StereoFrame frame;
        frame.left = cv::Mat::zeros(1, 1, CV_8U);
        frame.right = frame.left;
        return frame;
    }
    std::map<int, double> truly_rad;
    bool moved = false;  ///< during any picture

  private:
    SimCell& cell_;
};

/// Link and exposures are the real ones; only what is computed from the pictures is made up.
class LinkedWork : public EffectRunner {
  public:
    static constexpr double kTimeScale = 50.0;

    LinkedWork(RobotLink& robot, StereoSource& camera) : robot_(robot), camera_(camera) {}

    Event run(const Effect& effect, const ProcedureState& state, std::stop_token stop) override {
        if (std::holds_alternative<effect::OpenLink>(effect)) return open_link(&robot_);
        if (const auto* e = std::get_if<effect::Turn>(&effect)) {
            return turn(&robot_, e->command, stop);
        }
        if (const auto* e = std::get_if<effect::Expose>(&effect)) return exposed(e->shot, stop);
        return computed_.run(effect, state, stop);
    }
    void halt() override { (void)robot_.stop(); }

  private:
    Event exposed(const Shot& shot, const std::stop_token& stop) {
        const StillnessTest still = [](const auto&, const auto&) { return std::nullopt; };
        // The arm trembles for a while after it has arrived.
        const ExposureSettings settings{.settle_s = 0.3 / kTimeScale, .tries = 1, .pause_s = 0.0};
        const auto exposure = expose(&robot_, camera_, shot, still, settings, stop);
        if (!exposure) return event::ExposureFailed{exposure.error().message};
        return event::Exposed{record_of(shot, *exposure)};
    }

    RobotLink& robot_;
    StereoSource& camera_;
    FakeCell unused_;
    FakeWork computed_{unused_};
};

gsp::GspSettings impatient(const SimCell& cell) {
    gsp::GspSettings settings;
    settings.motion_port = cell.motion_port();
    settings.monitor_port = cell.monitor_port();
    settings.connect_limit = 1000ms;
    settings.reply_limit = 300ms;
    settings.done_margin = 500ms;
    settings.retry_pause = 10ms;
    return settings;
}

class FaultInTheTurn : public testing::TestWithParam<const char*> {};

TEST_P(FaultInTheTurn, NoPictureIsKeptWithAnotherAngleAndTheTurnIsCompleted) {
    auto cell = SimCell::create({.seed = 4,
                                 .image_fraction = 8,
                                 .faults = {GetParam()},
                                 .step_deg = 30.0,
                                 .time_scale = LinkedWork::kTimeScale});
    ASSERT_TRUE(cell) << cell.error().message;
    NotingCamera camera(*cell);
    gsp::GspLink robot(impatient(*cell));
    LinkedWork work(robot, camera);
    MemoryStore store;
    MemoryJournal journal;
    ProcedureState state;
    state.plan.step_rad = state.data.step_rad = rad_from_deg(30.0);
    state.plan.largest_move_rad = rad_from_deg(40.0);
    Engine engine(state, work, store, journal);

    const auto in = [&]<typename T>(T) { return std::holds_alternative<T>(engine.state().phase); };
    // As an operator who connects again and resumes until the turn is done.
    std::vector<std::string> troubles;
    const auto end = std::chrono::steady_clock::now() + 60s;
    while (!in(phase::Finished{}) && std::chrono::steady_clock::now() < end) {
        ASSERT_TRUE(engine.pump(20ms));
        std::optional<Command> next;
        if (const auto* offline = std::get_if<phase::Offline>(&engine.state().phase)) {
            if (!offline->why.empty()) troubles.push_back(offline->why);
            next = command::Connect{};
        } else if (const auto* cut = std::get_if<phase::Interrupted>(&engine.state().phase)) {
            troubles.push_back(cut->why);
            std::this_thread::sleep_for(20ms);  // an emergency stop is released by then
            next = command::Resume{};
        } else if (in(phase::Idle{}) && !engine.state().running) {
            next = command::Run{};
        }
        if (next) {
            const auto refused = engine.submit(*next);
            ASSERT_TRUE(refused);
            EXPECT_FALSE(*refused) << **refused;
        }
        ASSERT_LT(troubles.size(), 20U) << testing::PrintToString(troubles);
    }
    ASSERT_TRUE(in(phase::Finished{})) << testing::PrintToString(troubles);

    const ProcedureState& done = engine.state();
    const auto used = done.data.used();
    ASSERT_EQ(used.size(), 13U);
    EXPECT_FALSE(camera.moved) << "a picture was taken of a travelling arm";
    for (std::size_t k = 0; k < used.size(); ++k) {
        const CaptureRecord& capture = done.data.captures[used[k]];
        ASSERT_TRUE(capture.before && capture.joint6_after_rad);
        const double wanted_deg = -180.0 + 30.0 * static_cast<double>(k);
        EXPECT_NEAR(deg_from_rad(capture.commanded_rad), 30.0 * static_cast<double>(k), 1e-9);
        EXPECT_NEAR(deg_from_rad(capture.before->joints_rad[5]), wanted_deg, kStanding_deg);
        EXPECT_NEAR(deg_from_rad(*capture.joint6_after_rad), wanted_deg, kStanding_deg);
        EXPECT_NEAR(deg_from_rad(camera.truly_rad.at(capture.index)), wanted_deg, kStanding_deg)
            << "the picture shows another angle than the one it is kept with";
    }
    // What the journal says leads to the same end.
    const auto replayed = replay_inputs(state, journal.inputs());
    ASSERT_TRUE(replayed) << replayed.error().message;
    EXPECT_EQ(replayed->data, done.data);
}

// In the middle of the turn, or from the start where the exchange is only made there.
INSTANTIATE_TEST_SUITE_P(
    EveryFault, FaultInTheTurn,
    testing::Values("delay@6=accept:0.5", "delay@6=done:1.2", "delay@6=pos:0.5", "drop@0=hello",
                    "drop@0=state", "drop@6=pos", "drop@6=accept", "drop@6=run", "drop@6=done",
                    "drop@6=after_done", "garble@0=hello", "garble@0=state", "garble@6=pos",
                    "garble@6=accept", "garble@6=done", "split@6=accept:0.01", "split@6=done:0.01",
                    "split@6=pos:0.01", "halfopen@0=hello", "halfopen@0=state", "halfopen@6=pos",
                    "halfopen@6=accept", "halfopen@6=run", "halfopen@6=done",
                    "halfopen@6=after_done", "restart@6=accept:0.3", "restart@6=run:0.3",
                    "restart@6=done:0.3", "restart@6=after_done:0.3", "estop@6=run:0.5",
                    "servo_off@6=run:0.5"),
    [](const auto& test) {
        std::string name = test.param;
        std::ranges::replace_if(
            name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
        return name;
    });

}  // namespace
}  // namespace gripscan::test
