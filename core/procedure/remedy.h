// What may be tried against a cause, and what a person does about it: one row a cause.
#pragma once

#include <string_view>

#include "core/registration/turn_report.h"

namespace gripscan {

/// What is left once retaking and halving are spent.
enum class LastResort {
    kStop,        ///< going on would not help
    kStopIfBad,   ///< stop for a rejected row; one that is to be checked is merged and shown
    kLockAxis,    ///< the robot's angle takes the place of the surface's
    kGatherRows,  ///< the rows that follow will tell what it is
};

struct Remedy {
    int retakes = 0;  ///< worth making; the plan's budget counts too
    bool halving_helps = false;
    LastResort last = LastResort::kStop;
    std::string_view what_is_wrong;  ///< in the middle of a sentence
    std::string_view what_to_do;     ///< in the cell, when the procedure stops
};

[[nodiscard]] const Remedy& remedy_for(Cause cause);

}  // namespace gripscan
