// What an Accept would accept, and why it needs a note.
#pragma once

#include <string>
#include <string_view>

#include "core/procedure/procedure_state.h"

namespace gripscan::ui {

struct Accepted {
    std::string title;    ///< "Accept step 6"
    std::string finding;  ///< what was found against it
    std::string refused;  ///< why nothing can be accepted; empty: it can
};
[[nodiscard]] Accepted accepted_by_note(const ProcedureState& state);

/// Why the note is none, in words; empty: it is one.
[[nodiscard]] std::string note_problem(std::string_view note);

}  // namespace gripscan::ui
