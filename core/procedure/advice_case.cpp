// The advisor's question, put together from the state.
#include "core/procedure/draft.h"
#include "core/procedure/retry_advisor.h"

namespace gripscan {
namespace {

/// Judged steps of earlier attempts at the step that ends at the last used view, oldest first: those
/// at the same angle and the larger ones that were halved.
std::vector<JudgedStep> earlier_attempts(const ProcedureState& state, int from, int to) {
    std::vector<JudgedStep> attempts;
    for (const CaptureRecord& capture : state.data.captures) {
        if (capture.index >= to) break;
        const auto judged = state.judged.find({from, capture.index});
        if (judged != state.judged.end()) attempts.push_back(judged->second);
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
    const std::vector<JudgedStep> attempts = earlier_attempts(state, last.row.from, last.row.to);
    const bool unseen = state.warm_up && state.warm_up->why_none == Cause::kSymmetry;
    return advise({last, table, attempts, step_rad, state.data.axis_locked,
                   unseen ? state.warm_up->sentence : std::string()},
                  state.plan);
}

}  // namespace gripscan
