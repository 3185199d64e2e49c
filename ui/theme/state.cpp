#include "ui/theme/state.h"

#include <array>

namespace gripscan::ui {

std::string_view word(State state) {
    constexpr std::array<std::string_view, 5> kWords{"Accept", "Check", "Reject", "Running",
                                                     "Waiting"};
    return kWords[static_cast<std::size_t>(state)];
}

const Colour& colour_of(const Theme& theme, State state) {
    switch (state) {
        case State::kAccept:
            return theme.ok;
        case State::kCheck:
            return theme.check;
        case State::kReject:
            return theme.reject;
        case State::kRunning:
            return theme.accent;
        case State::kWaiting:
            break;
    }
    return theme.text_third;
}

const Colour& tint_of(const Theme& theme, State state) {
    switch (state) {
        case State::kAccept:
            return theme.ok_bg;
        case State::kCheck:
            return theme.check_bg;
        case State::kReject:
            return theme.reject_bg;
        case State::kRunning:
            return theme.accent_bg;
        case State::kWaiting:
            break;
    }
    return theme.raised;
}

}  // namespace gripscan::ui
