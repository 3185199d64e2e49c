// What joint 6 may be asked for, wherever it is asked: command line, cell file, plan, link.
#pragma once

namespace gripscan {

constexpr double kLeastSpeed_percent = 1.0;
constexpr double kMostSpeed_percent = 30.0;

/// Step of a turn.
constexpr double kLeastStep_deg = 0.5;
constexpr double kMostStep_deg = 120.0;

/// Most that the controller's server turns at once (STEP_CAP of assets/fanuc/gs_conf.kl), from
/// where the joint stands.
constexpr double kMostTurn_deg = 45.0;
/// What longer motions are cut into: below that, as the joint never stands exactly.
constexpr double kPieceOfTurn_deg = 40.0;

}  // namespace gripscan
