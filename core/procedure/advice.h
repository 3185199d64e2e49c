// What to do about a step that was not accepted, and why.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/registration/turn_report.h"

namespace gripscan {

enum class AdvisedAction {
    kRetake,    ///< expose again at the same angle
    kHalve,     ///< go back half the step
    kLockAxis,  ///< take the angle from the robot: the surface does not show it
    kGoOn,      ///< keep the row as it is and take the next step
    kStop,      ///< stop and ask: going on would not help
};

/// "retake", "halve", "lock the axis", "go on", "stop and ask".
[[nodiscard]] std::string_view word(AdvisedAction action);

struct Advice {
    AdvisedAction action = AdvisedAction::kStop;
    Cause cause = Cause::kNone;
    std::string sentence;               ///< one: what to do and why
    std::vector<std::string> evidence;  ///< value against limit, the worst first

    friend bool operator==(const Advice&, const Advice&) = default;
};

}  // namespace gripscan
