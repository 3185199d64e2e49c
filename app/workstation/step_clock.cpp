#include "app/workstation/step_clock.h"

#include <cmath>

namespace gripscan::app {
namespace {
/// A step that took longer was waited for: the operator thought, or went away.
constexpr double kLongest_s = 60.0;
constexpr double kWeightOfLatest = 0.3;
}  // namespace

void StepClock::tell(const ProcedureState& state, double now_s) {
    const auto* busy = std::get_if<phase::Busy>(&state.phase);
    if (busy == nullptr) {
        busy_since_s_.reset();
    } else if (!busy_since_s_ || activity_ != busy->activity.index()) {
        busy_since_s_ = now_s;
        activity_ = busy->activity.index();
    }
    const std::size_t steps = state.judged.size();
    if (steps == steps_) return;
    if (last_step_s_ && steps > steps_ && now_s - *last_step_s_ < kLongest_s) {
        const double took_s = (now_s - *last_step_s_) / static_cast<double>(steps - steps_);
        step_takes_s_ = step_takes_s_ == 0.0
                            ? took_s
                            : step_takes_s_ + kWeightOfLatest * (took_s - step_takes_s_);
    }
    steps_ = steps;
    last_step_s_ = now_s;
}

std::optional<double> StepClock::seconds_left(const ProcedureState& state) const {
    const CaptureRecord* last = state.data.last_used();
    if (step_takes_s_ == 0.0 || last == nullptr || turn_complete(state)) return std::nullopt;
    const double turned_rad = last->commanded_rad;
    const double steps =
        std::ceil((state.plan.total_rad - turned_rad) / state.data.step_rad - 1e-6);
    return steps * step_takes_s_;
}

}  // namespace gripscan::app
