// What a wrong angle means, read from the rows before it and from earlier attempts at it: one wrong
// capture, or the robot, or the gripper.
#pragma once

#include <string>

#include "core/procedure/retry_advisor.h"

namespace gripscan {

/// How sure a cause is, by what other pictures and other steps say.
enum class Certainty {
    kFirstLook,    ///< one picture
    kUnsteady,     ///< pictures at the same angle contradict each other
    kReproduced,   ///< they agree; more than one cause is left
    kEstablished,  ///< other causes are ruled out
};

struct AnglePattern {
    Cause cause = Cause::kMislabelled;
    Certainty certainty = Certainty::kFirstLook;
    std::string evidence;  ///< with the numbers; empty: nothing but this row
};

/// Was `attempt` made at the angle of `row`, or at a larger one?
[[nodiscard]] bool at_same_angle(const TurnStep& row, const TurnStep& attempt);

/// For a row whose angle is wrong by itself: error_rad is known and beyond what noise explains.
[[nodiscard]] AnglePattern angle_pattern(const AdvisorCase& c, const TurnLimits& limits);

}  // namespace gripscan
