// Everything that can happen to the procedure, as values: what the operator commands, and what the
// devices and the computation report. Inputs are journalled before they take effect; the same
// inputs in the same order always lead to the same state.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "core/procedure/capture_record.h"
#include "core/procedure/cell_report.h"
#include "core/procedure/judged_step.h"
#include "core/procedure/turn_plan.h"
#include "core/robot/robot_link.h"

namespace gripscan {

namespace command {
struct Connect {};    ///< open the link, again after a loss
struct CheckCell {};  ///< measure every prerequisite
struct WarmUp {};     ///< small turns that find the axis
struct Capture {};    ///< here and now: the first view, or the one the operator has turned to
struct Step {};       ///< turn by the step, capture, judge
struct Retry {};      ///< the last view again, at the same angle
struct Halve {};      ///< back by half the last step, capture, judge; later steps are halved too
struct LockAxis {};   ///< from here on the robot tells the angle and the scans only the axis
struct Accept {       ///< the last step, or a failed cell check, on the operator's word
    std::string note;
};
struct Back {};  ///< the last view is given up and the robot turns back to the one before
struct Undo {};
struct Redo {};
struct Exclude {  ///< leave a view out
    int index = 0;
};
struct Retake {  ///< an earlier view again
    int index = 0;
};
struct TellAngle {  ///< without a link that reads: where joint 6 stands, as the operator reads it
    double joint6_rad = 0.0;
};
struct Run {};    ///< go on by itself, as the advisor says, until the turn is complete
struct Pause {};  ///< after what is going on
struct Stop {};   ///< at once; the arm too
struct Resume {};  ///< what was interrupted
struct Finish {};  ///< solve for what there is
struct SetPlan {   ///< before the first view: step, speed, limits
    TurnPlan plan;
};
}  // namespace command

using Command = std::variant<command::Connect, command::CheckCell, command::WarmUp,
                             command::Capture, command::Step, command::Retry, command::Halve,
                             command::LockAxis, command::Accept, command::Back, command::Undo,
                             command::Redo, command::Exclude, command::Retake, command::TellAngle,
                             command::Run, command::Pause, command::Stop, command::Resume,
                             command::Finish, command::SetPlan>;

namespace event {
struct LinkUp {
    RobotIdentity identity;
    ControllerState controller;
    std::optional<RobotReading> reading;  ///< nothing where no robot can be read
};
struct LinkDown {  ///< it could not be opened, or was lost
    std::string why;
};
struct CellChecked {
    CellReport report;
};
struct Arrived {  ///< joint 6 stands at the target
    RobotReading reading;
};
struct TurnFailed {
    RobotFault fault = RobotFault::kLost;
    int last_id = 0;  ///< with kStaleId
    std::string why;
};
struct TurnLogged {};  ///< DRY: the motion was written down and not sent
struct Exposed {
    CaptureRecord record;
};
struct ExposureFailed {
    std::string why;
};
struct Judged {
    JudgedStep step;
};
struct AxisFound {
    std::optional<AxisEstimate> axis;  ///< nothing: the surface does not show its turn
    std::string sentence;
    std::optional<CellReport> cell;  ///< checked again, with what the warm-up has shown
    std::optional<Cause> why_none;   ///< where there is no axis; older journals do not say
};
struct Solved {
    int accepted = 0;
    int steps = 0;
    std::size_t template_points = 0;
};
struct WorkFailed {  ///< a computation or the disk
    std::string why;
};
struct ProgramEnded {};  ///< written when a recording is opened again: what was going on is not
}  // namespace event

using Event = std::variant<event::LinkUp, event::LinkDown, event::CellChecked, event::Arrived,
                           event::TurnFailed, event::TurnLogged, event::Exposed,
                           event::ExposureFailed, event::Judged, event::AxisFound, event::Solved,
                           event::WorkFailed, event::ProgramEnded>;

using Input = std::variant<Command, Event>;

/// "connect", "check_cell", …: for journal, messages and logs.
[[nodiscard]] std::string_view word(const Command& command);
[[nodiscard]] std::string_view word(const Event& event);

}  // namespace gripscan
