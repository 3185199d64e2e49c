// States of a step, a stage or a line of evidence, with their word and colour.
#pragma once

#include <string_view>

#include "ui/theme/theme.h"

namespace gripscan::ui {

enum class State { kAccept, kCheck, kReject, kRunning, kWaiting };

[[nodiscard]] std::string_view word(State state);
[[nodiscard]] const Colour& colour_of(const Theme& theme, State state);
[[nodiscard]] const Colour& tint_of(const Theme& theme, State state);

}  // namespace gripscan::ui
