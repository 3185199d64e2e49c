// Typed numbers: an input with a unit, and a slider that has one beside it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ui/widgets/ui.h"

namespace gripscan::ui {

struct NumberSpec {
    std::string_view id = {};
    std::string_view label = {};  ///< for the log and the tooltip
    double value = 0.0;           ///< in `unit`
    std::string_view unit = {};
    int decimals = 1;
    double min = 0.0;
    double max = 0.0;
    std::string_view why_disabled = {};
};

struct NumberEvent {
    std::optional<double> committed;  ///< typed, in range, and left or confirmed by Enter
    std::string problem;              ///< while what stands there is no number in range
};

/// The number in what was typed (blanks, comma or point, − or -, a trailing unit), or the problem.
[[nodiscard]] NumberEvent typed_number(std::string_view text, const NumberSpec& spec);

[[nodiscard]] NumberEvent number_input(const Ui& ui, const Rect& rect, const NumberSpec& spec);

/// The new value while it is dragged.
[[nodiscard]] std::optional<double> slider(const Ui& ui, const Rect& rect, const NumberSpec& spec);

enum class InputLook { kNormal, kEditing, kWrong };
/// The picture alone.
void draw_input(const Ui& ui, const Rect& rect, std::string_view text, std::string_view unit,
                InputLook look);

}  // namespace gripscan::ui
