// The verdict of a step: shape and word, what it rests on, one sentence.
#pragma once

#include <string_view>

#include "ui/widgets/state_shape.h"

namespace gripscan::ui {

struct VerdictText {
    State state = State::kWaiting;
    std::string_view word = {};      ///< instead of the state's own: "Both found"
    std::string_view basis = {};     ///< at the right: "Free, 8 of 8 starts agree", "REG-012"
    bool basis_is_number = false;    ///< a code or a time
    std::string_view sentence = {};  ///< with numbers in back quotes
};

/// Draws it; returns its height, which verdict_card_height tells beforehand.
int draw_verdict_card(const Ui& ui, int x, int y, int width, const VerdictText& verdict);
[[nodiscard]] int verdict_card_height(const Ui& ui, int width, const VerdictText& verdict);

}  // namespace gripscan::ui
