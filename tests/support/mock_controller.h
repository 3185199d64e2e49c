// A controller on the loopback that keeps to GSP/1, except where its script says otherwise.
#pragma once

#include <atomic>
#include <map>
#include <optional>
#include <thread>
#include <vector>

#include "core/base/units.h"
#include "core/concurrency/tcp_listener.h"
#include "core/robot/gsp_message.h"
#include "core/robot/gsp_reading.h"
#include "core/robot/kinematics.h"
#include "tests/support/mock_arm.h"
#include "tests/support/mock_client.h"
#include "tests/support/mock_script.h"

namespace gripscan::test {

class MockController {
  public:
    MockController() {
        motion_thread_ = std::jthread([this](const std::stop_token& s) { serve_motion(s); });
        monitor_thread_ = std::jthread([this](const std::stop_token& s) { serve_monitor(s); });
    }

    ~MockController() { stopping_ = true; }
    MockController(const MockController&) = delete;

    // The script; each line holds for so many times.

    MockController& at(Point point, Mischief mischief, int times = 1) {
        script_.add(point, mischief, times);
        return *this;
    }
    /// kRequest: refuses. kMoving: halts the arm and ends with that code. kDone: ends with it.
    MockController& fails(Point point, gsp::ErrorCode code) {
        script_.add(point, code);
        return *this;
    }
    MockController& flaw(Flaw flaw) {
        script_.add(flaw);
        return *this;
    }
    /// From the next client on.
    MockController& hears(Side side, Bend bend) {
        const std::lock_guard lock(mutex_);
        bends_[side].heard = std::move(bend);
        return *this;
    }
    MockController& says(Side side, Bend bend) {
        const std::lock_guard lock(mutex_);
        bends_[side].said = std::move(bend);
        return *this;
    }
    /// Of all trouble of the link.
    MockController& heals() {
        script_.clear();
        return *this;
    }
    MockController& turns_joint5_along(double by_deg) {
        joint5_deg_ = by_deg;
        return *this;
    }
    MockController& reports_joint6_off(double by_deg) {
        off_deg_ = by_deg;
        return *this;
    }
    MockController& turns_for(std::chrono::milliseconds duration) {
        duration_ = duration;
        return *this;
    }
    /// As a controller whose program blocks its socket while the arm moves.
    MockController& takes_clients_only_when_still() {
        only_when_still_ = true;
        return *this;
    }
    MockController& introduces_itself_as(gsp::HelloReply hello) {
        const std::lock_guard lock(mutex_);
        hello_ = std::move(hello);
        return *this;
    }
    MockController& remembers(int last_id) {
        const std::lock_guard lock(mutex_);
        last_ = {last_id, 0.0, 0.0};
        return *this;
    }

    [[nodiscard]] std::uint16_t motion_port() const { return motion_.port(); }
    [[nodiscard]] std::uint16_t monitor_port() const { return monitor_.port(); }
    [[nodiscard]] MockArm& arm() { return arm_; }
    [[nodiscard]] int stops() const { return stops_; }
    [[nodiscard]] int turns_received() const { return turns_received_; }

    /// Longer than a reply is waited for in quick_settings, and not twice as long.
    static constexpr std::chrono::milliseconds kLate{600};

  private:
    static constexpr std::chrono::milliseconds kTick{2};

    MockClient client_of(TcpConnection connection, Side side) {
        const std::lock_guard lock(mutex_);
        return {std::move(connection), bends_[side]};
    }

    void say(MockClient& client, const gsp::Reply& what) {
        client.send(client.bytes_of(gsp::encode(what)));
    }

    /// Sends the reply as the script wants it.
    void reply(MockClient& client, const gsp::Reply& what, Point point) {
        const std::string line = client.bytes_of(gsp::encode(what));
        const auto mischief = script_.mischief_at(point);
        if (!mischief) return client.send(line);
        if (disturb(client, *mischief)) return;
        switch (*mischief) {
            case Mischief::kLate:
                std::this_thread::sleep_for(kLate);
                return client.send(line);
            case Mischief::kGarbled:
                return client.send("OK A\x01? 1#\r\n");
            case Mischief::kSplit:
                for (const char byte : line) client.send(std::string(1, byte));
                return;
            case Mischief::kJoined:
                return client.hold_back(line);
            case Mischief::kBabble:
                while (!client.gone() && !stopping_) client.send(std::string(1000, '\n'));
                return;
            case Mischief::kTwice:
                return client.send(line + line);
            default:
                return;
        }
    }

    /// Trouble of the connection itself.
    bool disturb(MockClient& client, Mischief mischief) {
        if (mischief == Mischief::kRestart) {
            arm_.halt();
            forget();
            restarted_ = true;
        }
        if (mischief == Mischief::kHalfOpen) {
            const std::lock_guard lock(mutex_);
            graveyard_.push_back(client.abandon());
            return true;
        }
        if (mischief != Mischief::kDrop && mischief != Mischief::kRestart) return false;
        client.close();
        return true;
    }

    void forget() {
        const std::lock_guard lock(mutex_);
        last_ = {};
        answer_.reset();
        running_ = false;
    }

    // The motion connection.

    void serve_motion(const std::stop_token& stop) {
        while (!stop.stop_requested()) {
            finish_motion(nullptr);
            if (only_when_still_ && running_) {
                std::this_thread::sleep_for(kTick);
                continue;
            }
            auto accepted = motion_.accept(stop, deadline_in(kTick));
            if (!accepted) continue;
            MockClient client = client_of(*std::move(accepted), Side::kMotion);
            while (!client.gone() && !stop.stop_requested()) serve(client);
            if (script_.has(Flaw::kForgetsOnLoss)) forget();
            stuck_ = stuck_ || (running_ && script_.has(Flaw::kStuckAfterLoss));
        }
    }

    void serve(MockClient& client) {
        const auto item = client.read(kTick);
        if (item) answer_motion(client, *item);
        if (!client.gone()) finish_motion(&client);
    }

    void answer_motion(MockClient& client, const FramedItem& item) {
        const auto request = request_of(client, item);
        if (!request) return;
        if (const auto* turn = std::get_if<gsp::TurnJoint6>(&*request)) {
            ++turns_received_;
            return take_turn(client, *turn);
        }
        answer_question(client, *request, Point::kRequest);
    }

    std::optional<gsp::Request> request_of(MockClient& client, const FramedItem& item) {
        if (std::holds_alternative<OverlongLine>(item)) {
            say(client, gsp::too_long());
            return std::nullopt;
        }
        if (std::holds_alternative<BrokenStream>(item)) {
            client.close();
            return std::nullopt;
        }
        auto request = gsp::decode_request(std::get<Line>(item).text);
        if (request) return *std::move(request);
        say(client, request.error());
        return std::nullopt;
    }

    void take_turn(MockClient& client, const gsp::TurnJoint6& turn) {
        if (const auto mischief = script_.mischief_at(Point::kRequest)) {
            (void)disturb(client, *mischief);
            return;
        }
        if (const auto refusal = refusal_of(turn)) return say(client, *refusal);
        const bool again = turn.id == last_.id && (turn == last_ || !takes_other_turns());
        if (again && script_.has(Flaw::kRepeatMoves)) arm_.start(turn.angle_deg + 1.0, duration_);
        if (!again) begin(turn);
        reply(client, gsp::Accepted{turn.id}, Point::kAccepted);
        if (again && answer_ && !client.gone()) return reply(client, *answer_, Point::kDone);
        if (again || client.gone()) return;
        if (const auto mischief = script_.mischief_at(Point::kMoving))
            (void)disturb(client, *mischief);
    }

    std::optional<gsp::Failure> refusal_of(const gsp::TurnJoint6& turn) {
        using gsp::ErrorCode;
        if (const auto code = script_.failure_at(Point::kRequest)) {
            return gsp::Failure{turn.id, *code, std::string(gsp::words_of(*code))};
        }
        const std::lock_guard lock(mutex_);
        const bool old = turn.id < last_.id && !script_.has(Flaw::kTakesOldIds);
        const bool other = turn.id == last_.id && !(turn == last_) && !takes_other_turns();
        if (old || other) {
            return gsp::Failure{turn.id, ErrorCode::kStaleId,
                                gsp::stale_text(last_.id, "passed or other arguments")};
        }
        if (turn == last_) return std::nullopt;
        if (stuck_) return gsp::Failure{turn.id, ErrorCode::kProgramFailed, "GRIPSCAN aborted"};
        if (running_ && !script_.has(Flaw::kNeverBusy))
            return gsp::Failure{turn.id, ErrorCode::kBusy, "busy"};
        if (script_.has(Flaw::kNoLimits)) return std::nullopt;
        if (turn.speed_percent < 1.0 || turn.speed_percent > 50.0) {
            return gsp::Failure{turn.id, ErrorCode::kSpeedRange, "speed outside 1..50"};
        }
        if (std::abs(turn.angle_deg) > 360.0) {
            return gsp::Failure{turn.id, ErrorCode::kTargetRange, "target out of range"};
        }
        return std::nullopt;
    }

    [[nodiscard]] bool takes_other_turns() const { return script_.has(Flaw::kTakesOtherTurns); }

    void begin(const gsp::TurnJoint6& turn) {
        const std::lock_guard lock(mutex_);
        last_ = turn;
        answer_.reset();
        stopped_ = false;
        running_ = true;
        const int slowness = script_.has(Flaw::kDoneTooEarly) ? 4 : 1;
        arm_.start(turn.angle_deg, slowness * duration_.load());
        arm_.shift_joint(4, joint5_deg_);
    }

    /// Once the arm stands: the answer, told to whoever is there.
    void finish_motion(MockClient* client) {
        if (restarted_.exchange(false) && client) client->close();
        if (!running_) return;
        if (const auto code = script_.failure_at(Point::kMoving)) {
            arm_.halt();
            return finish(client, gsp::Failure{last_.id, *code, "SRVO-002 deadman"});
        }
        const bool early = script_.has(Flaw::kDoneTooEarly);
        if (early) return finish(client, gsp::Done{last_.id, position(left_deg())});
        if (arm_.moving()) return;
        if (const auto code = script_.failure_at(Point::kDone)) {
            return finish(client, gsp::Failure{last_.id, *code, std::string(gsp::words_of(*code))});
        }
        if (stopped_) {
            return finish(client, gsp::Failure{last_.id, gsp::ErrorCode::kStopped, "stopped"});
        }
        finish(client, gsp::Done{last_.id, position(off_deg_)});
    }

    void finish(MockClient* client, const gsp::Reply& answer) {
        {
            const std::lock_guard lock(mutex_);
            answer_ = answer;
            running_ = false;
        }
        if (client) reply(*client, answer, Point::kDone);
    }

    // The monitor connection.

    void serve_monitor(const std::stop_token& stop) {
        while (!stop.stop_requested()) {
            auto accepted = monitor_.accept(stop, deadline_in(kTick));
            if (!accepted) continue;
            MockClient client = client_of(*std::move(accepted), Side::kMonitor);
            while (!client.gone() && !stop.stop_requested()) {
                const auto item = client.read(kTick);
                const auto request = item ? request_of(client, *item) : std::nullopt;
                if (!request) continue;
                const auto mischief = script_.mischief_at(Point::kMonitorRequest);
                if (mischief) {
                    (void)disturb(client, *mischief);
                } else {
                    answer_question(client, *request, Point::kQuestion);
                }
            }
            if (script_.has(Flaw::kOneMonitorEver)) return;
        }
    }

    void answer_question(MockClient& client, const gsp::Request& request, Point point) {
        if (const auto* hello = std::get_if<gsp::Hello>(&request)) {
            if (hello->version != gsp::kVersion) {
                return say(client, gsp::Failure{0, gsp::ErrorCode::kVersion, "speaks 1"});
            }
            return reply(client, identity(), point_of_hello(point));
        }
        if (std::holds_alternative<gsp::AskState>(request)) {
            return reply(client, state(), point);
        }
        if (std::holds_alternative<gsp::AskPosition>(request)) {
            return reply(client, gsp::PositionReply{position(0.0)}, point);
        }
        const auto* turn = std::get_if<gsp::TurnJoint6>(&request);
        if (turn && script_.has(Flaw::kTurnsOnMonitor)) {
            arm_.start(turn->angle_deg, duration_);
            return say(client, gsp::Accepted{turn->id});
        }
        if (turn || point == Point::kRequest) {
            return say(client, gsp::Failure{0, gsp::ErrorCode::kUnknownRequest, "not here"});
        }
        ++stops_;
        if (!script_.has(Flaw::kDeafToStop)) {
            stopped_ = stopped_ || arm_.moving();
            arm_.halt();
        }
        reply(client, gsp::StopReply{}, Point::kStop);
    }

    gsp::HelloReply identity() {
        const std::lock_guard lock(mutex_);
        return hello_;
    }
    static Point point_of_hello(Point of_question) {
        return of_question == Point::kRequest ? Point::kHello : Point::kMonitorHello;
    }

    gsp::StateReply state() { return {true, true, false, false, arm_.moving(), 100, ""}; }

    /// To the target of the last turn.
    double left_deg() { return last_.angle_deg - arm_.joints_deg()[5]; }

    gsp::Position position(double off_deg) {
        RobotReading reading;
        auto joints_deg = arm_.joints_deg();
        joints_deg[5] += off_deg;
        for (std::size_t i = 0; i < 6; ++i) reading.joints_rad[i] = rad_from_deg(joints_deg[i]);
        reading.T_world_tool = tool_pose(reading.joints_rad);
        const auto age = std::chrono::steady_clock::now() - begin_;
        return gsp::position_from(
            reading, std::chrono::duration_cast<std::chrono::milliseconds>(age).count());
    }

    const std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
    std::mutex mutex_;
    MockScript script_;
    std::map<Side, Bends> bends_;
    gsp::HelloReply hello_{"LRMate200iC/5L", 6, std::string(gsp::kVersionText)};
    gsp::TurnJoint6 last_;
    std::optional<gsp::Reply> answer_;
    std::atomic<bool> running_ = false, stopped_ = false, restarted_ = false;
    std::atomic<bool> stopping_ = false;
    std::atomic<bool> only_when_still_ = false, stuck_ = false;
    std::atomic<double> joint5_deg_ = 0.0, off_deg_ = 0.0;
    std::atomic<std::chrono::milliseconds> duration_{std::chrono::milliseconds(30)};
    std::atomic<int> stops_ = 0, turns_received_ = 0;
    MockArm arm_;
    std::vector<TcpConnection> graveyard_;
    TcpListener motion_ = TcpListener::open(0).value();
    TcpListener monitor_ = TcpListener::open(0).value();
    std::jthread motion_thread_, monitor_thread_;  // last: they use all of the above
};

}  // namespace gripscan::test
