#include "core/procedure/procedure_state.h"

namespace gripscan {
namespace {

/// A turn that ends this near to its total is complete: operators stop by eye.
constexpr double kComplete_rad = 0.5 * kRadPerDeg;

void put_note(JudgedStep& step, const std::string& note) {
    if (note.empty() || step.row.verdict == Verdict::kAccept || !step.row.T) return;
    step.row.verdict = Verdict::kAcceptNoted;
    step.row.sentence += "; accepted with note: " + note;
}

}  // namespace

std::optional<double> standing_joint6_rad(const ProcedureState& state) {
    if (state.reading) return state.reading->joints_rad[5];
    return state.told_joint6_rad;
}

std::vector<JudgedStep> table_of(const ProcedureState& state) {
    std::vector<JudgedStep> table;
    const auto used = state.data.used();
    for (std::size_t i = 1; i < used.size(); ++i) {
        const CaptureRecord& to = state.data.captures[used[i]];
        const auto found = state.judged.find({state.data.captures[used[i - 1]].index, to.index});
        if (found == state.judged.end()) continue;
        table.push_back(found->second);
        table.back().row.index = static_cast<int>(table.size());
        put_note(table.back(), to.note);
    }
    return table;
}

bool turn_complete(const ProcedureState& state) {
    const CaptureRecord* last = state.data.last_used();
    return last != nullptr && last->commanded_rad >= state.plan.total_rad - kComplete_rad;
}

}  // namespace gripscan
