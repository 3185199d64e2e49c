// Where the procedure stands: one phase at a time, and what has been gathered on the way. Plain
// data; only step() changes it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/procedure/advice.h"
#include "core/procedure/input.h"
#include "core/procedure/shot.h"
#include "core/procedure/turn_data.h"
#include "core/procedure/turn_plan.h"

namespace gripscan {

namespace activity {
struct CheckingCell {};
struct Moving {
    /// Sent, and to be sent again with the same id where its end is unknown. Id 0: its end is
    /// known, the motion has to be planned anew.
    Joint6Command command;
    std::vector<double> then_rad;  ///< further angles, in order
    std::optional<Shot> shot;      ///< what is taken there; nothing: only the motion was wanted
    bool renumbered = false;       ///< its id was behind the controller's last one once already

    [[nodiscard]] double target_rad() const {
        return then_rad.empty() ? command.angle_rad : then_rad.back();
    }
};
struct AwaitingOperator {  ///< without motion rights
    double target_rad = 0.0;
    Shot shot;
};
struct Exposing {
    Shot shot;
};
struct Judging {
    int from = 0;
    int to = 0;
};
struct EstimatingAxis {};
struct Solving {};
}  // namespace activity

using Activity = std::variant<activity::CheckingCell, activity::Moving, activity::AwaitingOperator,
                              activity::Exposing, activity::Judging, activity::EstimatingAxis,
                              activity::Solving>;

namespace phase {
struct Offline {
    std::string why;  ///< empty: not asked yet
    std::optional<Activity> interrupted;
};
struct Connecting {
    std::optional<Activity> interrupted;
};
struct Idle {};  ///< connected, nothing going on
struct Busy {
    Activity activity;
};
struct Deciding {  ///< the last step was not accepted
    Advice advice;
};
struct Halting {  ///< told to stop, not ended yet
    Activity activity;
};
struct Interrupted {
    Activity activity;
    std::string why;
};
struct Finished {};
}  // namespace phase

/// What the advisor said about a step, kept although the run has gone on since.
struct GivenAdvice {
    int from = 0;  ///< captures of the step
    int to = 0;
    Advice advice;

    friend bool operator==(const GivenAdvice&, const GivenAdvice&) = default;
};

using Phase = std::variant<phase::Offline, phase::Connecting, phase::Idle, phase::Busy,
                           phase::Deciding, phase::Halting, phase::Interrupted, phase::Finished>;

struct ProcedureState {
    Phase phase = phase::Offline{};
    TurnPlan plan;
    bool running = false;  ///< goes on by itself
    std::optional<RobotIdentity> robot;
    std::optional<RobotReading> reading;    ///< the last one of a standing arm
    std::optional<double> told_joint6_rad;  ///< by the operator, where no robot is read
    int next_motion_id = 1;
    std::optional<CellReport> cell;
    std::string cell_note;  ///< the operator's, who accepted a failed check
    std::optional<event::AxisFound> warm_up;
    int warm_up_shots = 0;                     ///< taken
    std::optional<double> warm_up_joint6_rad;  ///< at its first picture
    TurnData data;
    std::optional<event::Solved> solved;  ///< for the captures as they are
    /// Every judged pair of captures, by (from, to); Table 1 is read from it.
    std::map<std::pair<int, int>, JudgedStep> judged;
    std::vector<GivenAdvice> advice;           ///< in order
    std::vector<double> rehearsed_joint6_rad;  ///< DRY: the motions written down, in order
    std::vector<TurnData> undo;
    std::vector<TurnData> redo;
};

/// Joint 6 as last read, else as told; nothing: unknown.
[[nodiscard]] std::optional<double> standing_joint6_rad(const ProcedureState& state);
/// Table 1 as it stands: every judged pair of consecutive used captures, in order.
[[nodiscard]] std::vector<JudgedStep> table_of(const ProcedureState& state);
/// The used captures go all the way round.
[[nodiscard]] bool turn_complete(const ProcedureState& state);

}  // namespace gripscan
