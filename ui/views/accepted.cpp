#include "ui/views/accepted.h"

#include <fmt/format.h>

#include "core/procedure/step.h"

namespace gripscan::ui {
namespace {

/// What failed, the first sentence of it and how many more.
std::string failures_of(const CellReport& report) {
    std::string first;
    int more = -1;
    for (const CellCheckItem& item : report.items) {
        if (item.outcome != CheckOutcome::kFailed) continue;
        if (first.empty()) first = item.sentence;
        ++more;
    }
    return more > 0 ? fmt::format("{} And {} more failed.", first, more) : first;
}

}  // namespace

Accepted accepted_by_note(const ProcedureState& state) {
    Accepted accepted;
    accepted.refused = refusal(state, command::Accept{"a note"}).value_or("");
    const auto table = table_of(state);
    if (!table.empty()) {
        accepted.title = fmt::format("Accept step {}", table.size());
        accepted.finding = table.back().row.sentence;
    } else if (state.cell) {
        accepted.title = "Accept the cell as it is";
        accepted.finding = failures_of(*state.cell);
    } else {
        accepted.title = "Accept";
    }
    return accepted;
}

std::string note_problem(std::string_view note) {
    return note.find_first_not_of(" \t\r\n") == std::string_view::npos
               ? "Say why: the note appears in the report."
               : "";
}

}  // namespace gripscan::ui
