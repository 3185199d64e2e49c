// One line of evidence: a number with its unit, a bar against its limit, and its state by shape.
#pragma once

#include <string_view>

#include "ui/widgets/state_shape.h"

namespace gripscan::ui {

enum class LimitKind { kAtMost, kAtLeast };

struct Evidence {
    std::string_view id;     ///< "evidence.angle_error"
    std::string_view label;  ///< "Angle error"
    double value = 0.0;      ///< in `unit`; no number: unknown
    std::string_view unit = {};
    int decimals = 3;
    bool with_sign = false;
    double limit = 0.0;  ///< no number: there is none, and neither bar nor shape
    int limit_decimals = 3;
    LimitKind kind = LimitKind::kAtMost;
    State state = State::kAccept;
    std::string_view meaning = {};  ///< tooltip: what it is and how it is computed
    bool past = false;              ///< of what is over: grey
};

/// How much of the bar is filled, 0 … 1; the limit stands at 2/3.
[[nodiscard]] double bar_part(double value, double limit);

/// Returns true when clicked: the limit wants to be edited.
[[nodiscard]] bool evidence_row(const Ui& ui, const Rect& rect, const Evidence& evidence);

}  // namespace gripscan::ui
