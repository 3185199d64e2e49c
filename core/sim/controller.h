// The simulated robot controller: what it answers to the requests of GSP/1, and when a turn is
// over. It knows messages and times, neither bytes nor sockets.
#pragma once

#include <optional>
#include <string>

#include "core/robot/gsp_message.h"
#include "core/sim/arm_motion.h"

namespace gripscan::sim {

enum class LinkKind { kMotion, kMonitor };

/// What the operator and the safety circuits decide.
struct Conditions {
    bool automatic = true;
    bool servo_on = true;
    bool emergency_stop = false;
    bool fault = false;
    bool pendant_enabled = false;
    int override_percent = 100;
    std::string alarm = "";  ///< empty: none
};

/// Why nothing may move under these conditions; nothing if it may.
[[nodiscard]] std::optional<gsp::ErrorCode> refusal(const Conditions& conditions);

struct ControllerSettings {
    double settle_s = 0.3;        ///< after the end of a travel, before it is confirmed
    double tolerance_deg = 0.03;  ///< of joint 6 at the end: six deviations of its repeatability
    double max_step_deg = 370.0;  ///< of one turn: a whole one back to the start is allowed
    double max_speed_percent = 100.0;
    double max_turn_s = 120.0;
};

/// Times are seconds of the arm's clock. Not for several threads at once.
class Controller {
  public:
    /// Drives this arm, which must outlive it.
    Controller(ArmMotion& arm, const ControllerSettings& settings);

    [[nodiscard]] gsp::Reply answer(LinkKind link, const gsp::Request& request, double now_s);
    /// The end of the turn that the present client of the motion link waits for, once it has come;
    /// told once. An id that is sent again is told again.
    [[nodiscard]] std::optional<gsp::Reply> outcome(double now_s);
    /// A new client of the motion link: it waits for nothing.
    void new_client() { awaited_ = false; }

    /// From the next call on; a turn under way ends if they forbid it. After `for_s` seconds they
    /// are as usual again, 0: never.
    void set_conditions(const Conditions& conditions, double now_s, double for_s = 0.0);
    /// Joint 6 may go no further than this from where it stands now.
    void limit_joint6(double margin_deg, double now_s);
    /// As after power off and on: the arm stands, ids and answers are forgotten.
    void restart(double now_s);

    /// A turn is under way and at least half of its travel is done.
    [[nodiscard]] bool half_way(double now_s) const;
    /// A turn is under way, and would be confirmed by now.
    [[nodiscard]] bool arrived(double now_s) const;

  private:
    struct Turn {
        gsp::TurnJoint6 command;
        std::optional<gsp::Reply> end;
    };
    [[nodiscard]] gsp::Reply accept(const gsp::TurnJoint6& command, double now_s);
    [[nodiscard]] std::optional<gsp::Failure> objection(const gsp::TurnJoint6& command,
                                                        double now_s) const;
    [[nodiscard]] std::optional<gsp::Failure> out_of_limits(const gsp::TurnJoint6& command,
                                                            double now_s) const;
    [[nodiscard]] gsp::StateReply state(double now_s) const;
    [[nodiscard]] gsp::Position position(double now_s) const;
    [[nodiscard]] bool under_way() const { return turn_ && !turn_->end; }
    void end_turn(gsp::ErrorCode code, std::string text, double now_s);
    void advance(double now_s);

    ArmMotion& arm_;
    ControllerSettings settings_;
    Conditions conditions_;
    std::optional<double> usual_again_s_;
    std::optional<std::pair<double, double>> limits_deg_;  ///< of joint 6, narrower than its range
    std::optional<Turn> turn_;                             ///< the last one accepted
    bool awaited_ = false;
};

}  // namespace gripscan::sim
