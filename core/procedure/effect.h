// What the procedure wants done: by the link, the camera, the disk or the computation. Each but
// SaveTable, SavePlan and Halt ends in exactly one event.
#pragma once

#include <variant>
#include <vector>

#include "core/procedure/shot.h"
#include "core/robot/robot_link.h"

namespace gripscan {

namespace effect {
struct OpenLink {};
struct MeasureCell {};
struct Turn {
    Joint6Command command;
};
struct LogTurn {};  ///< DRY: what Moving would drive is written down and not sent
struct Expose {
    Shot shot;
};
struct Judge {
    int from = 0;
    int to = 0;
};
struct EstimateAxis {};
struct Solve {};
struct SaveTable {};  ///< the captures as they are now
struct SavePlan {};   ///< the plan as it is now
struct Halt {};       ///< stop the arm, give up the work that is going on
}  // namespace effect

using Effect = std::variant<effect::OpenLink, effect::MeasureCell, effect::Turn, effect::LogTurn,
                            effect::Expose, effect::Judge, effect::EstimateAxis, effect::Solve,
                            effect::SaveTable, effect::SavePlan, effect::Halt>;

}  // namespace gripscan
