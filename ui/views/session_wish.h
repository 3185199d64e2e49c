// A new session as it is typed, checked before it is begun.
#pragma once

#include <string>

#include "ui/views/request.h"

namespace gripscan::ui {

/// What the dialog holds.
struct TypedSession {
    SessionWish wish;
    std::string folder;
    std::string cell_file;
    std::string gripper;  ///< of an object's turn
    bool simulated = true;
};

/// Why it cannot be begun, in words; empty: it can.
[[nodiscard]] std::string session_problem(const TypedSession& typed);

/// What is asked for; of the wish only what applies to that kind of cell.
[[nodiscard]] SessionWish session_wish(const TypedSession& typed);

}  // namespace gripscan::ui
