// The advisor's question, put together from the state.
#include "core/procedure/draft.h"
#include "core/procedure/retry_advisor.h"

namespace gripscan {
namespace {

/// Judged steps of earlier attempts at the angle of the last used view.
std::vector<JudgedStep> earlier_attempts(const ProcedureState& state) {
    std::vector<JudgedStep> attempts;
    const CaptureRecord& last = *state.data.last_used();
    for (const CaptureRecord& capture : state.data.captures) {
        if (capture.index >= last.index) break;
        if (!same_angle(capture.commanded_rad, last.commanded_rad)) continue;
        for (const auto& [pair, step] : state.judged) {
            if (pair.second == capture.index) attempts.push_back(step);
        }
    }
    return attempts;
}

}  // namespace

Advice advice_for(const ProcedureState& state) {
    std::vector<JudgedStep> table = table_of(state);
    const JudgedStep last = table.back();
    table.pop_back();
    const auto used = state.data.used();
    const double step_rad = state.data.captures[used.back()].commanded_rad -
                            state.data.captures[used[used.size() - 2]].commanded_rad;
    const std::vector<JudgedStep> attempts = earlier_attempts(state);
    return advise({last, table, attempts, step_rad, state.data.axis_locked}, state.plan);
}

}  // namespace gripscan
