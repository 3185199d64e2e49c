// What is going on, in words. Pure.
#pragma once

#include <string>

#include "core/procedure/procedure_state.h"

namespace gripscan::ui {

/// What is going on or being stopped; null: nothing is.
[[nodiscard]] const Activity* activity_of(const ProcedureState& state);

/// "Moving to `−40.000°`", "Aligning captures `14` and `15`".
[[nodiscard]] std::string activity_sentence(const Activity& activity);
/// "Moving", "Aligning": one word or two.
[[nodiscard]] std::string_view activity_word(const Activity& activity);

/// The warm-up is going on.
[[nodiscard]] bool warming_up(const ProcedureState& state);

}  // namespace gripscan::ui
