// When a command makes sense: what greys a button, and what step() answers to a command that does
// not.
#include "core/procedure/journal_codec.h"
#include "core/procedure/step.h"
#include "core/robot/joint6_limits.h"

namespace gripscan {
namespace {

/// As their journals would tell: every member but the speed.
bool same_but_speed(const TurnPlan& a, TurnPlan b) {
    b.speed_percent = a.speed_percent;
    return encode(a).fields == encode(b).fields;
}

using Why = std::optional<std::string>;

/// What makes a plan none that `now` could be replaced by.
Why problem_of(const TurnPlan& now, const TurnPlan& plan) {
    if (plan.mode != now.mode) return "whether the arm may move is chosen when the cell is opened";
    const bool step =
        plan.step_rad >= plan.least_step_rad && plan.step_rad <= rad_from_deg(kMostStep_deg);
    if (!step) {
        return fmt::format("a step of {:.2f} deg is not within {:.2f} to {:.0f} deg",
                           deg_from_rad(plan.step_rad), deg_from_rad(plan.least_step_rad),
                           kMostStep_deg);
    }
    if (!(plan.speed_percent >= kLeastSpeed_percent && plan.speed_percent <= kMostSpeed_percent)) {
        return fmt::format("a speed of {} % is not within {} to {} %", plan.speed_percent,
                           kLeastSpeed_percent, kMostSpeed_percent);
    }
    const TurnLimits& l = plan.limits;
    const bool limits = l.angle_rad > 0.0 && l.sigmas > 0.0 && l.overlap > 0.0 &&
                        l.overlap <= 1.0 && l.slip_m > 0.0 && l.tilt_rad > 0.0;
    if (!limits) return "every limit is larger than zero, and the overlap at most 1";
    return std::nullopt;
}

bool is_blank(std::string_view text) {
    return text.find_first_not_of(" \t\r\n") == std::string_view::npos;
}

struct Guard {
    const ProcedureState& s;

    template <typename T>
    [[nodiscard]] bool in() const {
        return std::holds_alternative<T>(s.phase);
    }
    [[nodiscard]] bool waiting_for_operator() const {
        const auto* busy = std::get_if<phase::Busy>(&s.phase);
        return busy != nullptr &&
               std::holds_alternative<activity::AwaitingOperator>(busy->activity);
    }

    /// Connected and nothing going on; `finished` tells whether a finished turn counts.
    [[nodiscard]] Why not_at_rest(bool finished) const {
        if (in<phase::Offline>()) return "not connected: connect first";
        if (in<phase::Connecting>()) return "connecting";
        if (in<phase::Busy>()) return "something is going on: stop it or wait";
        if (in<phase::Halting>()) return "stopping";
        if (in<phase::Interrupted>()) return "something was interrupted: resume it first";
        if (in<phase::Finished>() && !finished) return "the turn is finished";
        return std::nullopt;
    }
    [[nodiscard]] Why blocked_by_check() const {
        if (!s.cell) return "the cell has not been checked";
        if (!s.cell->passed() && s.cell_note.empty()) {
            return "the cell check has failed: see its rows, check again, or accept with a note";
        }
        return std::nullopt;
    }
    [[nodiscard]] Why no_pair() const {
        if (s.data.used().size() < 2) return "there is no step yet";
        return std::nullopt;
    }
    [[nodiscard]] Why dry() const {
        if (s.plan.mode == MotionMode::kDry) return "DRY: nothing is moved and nothing is captured";
        return std::nullopt;
    }
    [[nodiscard]] Why no_such_capture(int index) const {
        const CaptureRecord* capture = s.data.find(index);
        if (capture == nullptr) return fmt::format("there is no capture {}", index);
        if (capture->status != CaptureStatus::kUsed) {
            return fmt::format("capture {} is not used", index);
        }
        return std::nullopt;
    }
    static Why first_of(std::initializer_list<Why> whys) {
        for (const Why& why : whys) {
            if (why) return why;
        }
        return std::nullopt;
    }

    Why operator()(const command::Connect&) const {
        if (in<phase::Offline>() || in<phase::Interrupted>()) return std::nullopt;
        return in<phase::Connecting>() ? "connecting already" : "connected already";
    }
    Why operator()(const command::CheckCell&) const {
        if (auto why = not_at_rest(false)) return why;
        if (!s.data.captures.empty()) return "the turn has begun";
        return std::nullopt;
    }
    Why operator()(const command::WarmUp&) const {
        if (s.plan.mode == MotionMode::kManual) return "without motion rights there is no warm-up";
        if (auto why = first_of({dry(), not_at_rest(false), blocked_by_check()})) return why;
        if (!s.data.captures.empty()) return "the turn has begun";
        return std::nullopt;
    }
    Why operator()(const command::Capture&) const {
        if (waiting_for_operator()) return std::nullopt;
        if (auto why = first_of({dry(), not_at_rest(false), blocked_by_check()})) return why;
        if (s.data.last_used() != nullptr)
            return "there is a view at this angle: retry it, or step";
        return std::nullopt;
    }
    Why operator()(const command::Step&) const {
        if (auto why = first_of({not_at_rest(false), blocked_by_check()})) return why;
        if (s.plan.mode == MotionMode::kDry) return std::nullopt;
        if (s.data.last_used() == nullptr) return "take the first view first";
        if (turn_complete(s)) return "the turn is complete";
        return std::nullopt;
    }
    Why operator()(const command::Retry&) const {
        if (auto why = first_of({dry(), not_at_rest(true)})) return why;
        if (s.data.last_used() == nullptr) return "there is no view yet";
        return std::nullopt;
    }
    Why operator()(const command::Halve&) const {
        if (auto why = first_of({dry(), not_at_rest(true), no_pair()})) return why;
        const auto used = s.data.used();
        const double step_rad = s.data.captures[used.back()].commanded_rad -
                                s.data.captures[used[used.size() - 2]].commanded_rad;
        if (0.5 * step_rad < s.plan.least_step_rad * (1.0 - 1e-9)) {
            return fmt::format("half of {:.2f} deg is below the least step of {:.2f} deg",
                               deg_from_rad(step_rad), deg_from_rad(s.plan.least_step_rad));
        }
        return std::nullopt;
    }
    Why operator()(const command::LockAxis&) const {
        if (auto why = first_of({dry(), not_at_rest(true)})) return why;
        if (s.data.axis_locked) return "the axis is locked already";
        return std::nullopt;
    }
    Why operator()(const command::Accept& c) const {
        if (auto why = not_at_rest(true)) return why;
        if (is_blank(c.note)) return "accepting needs a note that says why";
        if (s.data.captures.empty()) {
            if (s.cell && !s.cell->passed()) return std::nullopt;
            return "there is nothing to accept";
        }
        const auto table = table_of(s);
        if (table.empty()) return "there is no step yet";
        if (table.back().row.verdict == Verdict::kAccept) return "the step is accepted already";
        if (!table.back().row.T) return "no alignment was found: there is nothing to accept";
        return std::nullopt;
    }
    Why operator()(const command::Back&) const {
        return first_of({dry(), not_at_rest(true), no_pair()});
    }
    Why operator()(const command::Undo&) const {
        if (auto why = not_at_rest(true)) return why;
        for (const TurnData& data : s.undo) {
            if (!(data == s.data)) return std::nullopt;
        }
        return "there is nothing to undo";
    }
    Why operator()(const command::Redo&) const {
        if (auto why = not_at_rest(true)) return why;
        if (s.redo.empty()) return "there is nothing to redo";
        return std::nullopt;
    }
    Why operator()(const command::Exclude& c) const {
        return first_of({not_at_rest(true), no_such_capture(c.index)});
    }
    Why operator()(const command::Retake& c) const {
        return first_of({dry(), not_at_rest(true), no_such_capture(c.index)});
    }
    Why operator()(const command::TellAngle&) const {
        if (s.plan.mode != MotionMode::kManual) return "the robot itself tells its angle";
        if (s.reading) return "the robot is read";
        if (waiting_for_operator()) return std::nullopt;
        return not_at_rest(true);
    }
    Why operator()(const command::Run&) const {
        if (s.running) return "running already";
        if (in<phase::Offline>() || in<phase::Connecting>()) return "not connected: connect first";
        if (in<phase::Interrupted>()) return "something was interrupted: resume it first";
        if (in<phase::Finished>()) return "the turn is finished";
        if (in<phase::Halting>()) return "stopping";
        return std::nullopt;
    }
    Why operator()(const command::Pause&) const {
        if (!s.running) return "not running";
        return std::nullopt;
    }
    Why operator()(const command::Stop&) const {
        if (s.running || in<phase::Busy>()) return std::nullopt;
        return "nothing is going on";
    }
    Why operator()(const command::Resume&) const {
        if (in<phase::Offline>()) return "not connected: connect first";
        if (!in<phase::Interrupted>()) return "nothing was interrupted";
        return std::nullopt;
    }
    Why operator()(const command::Finish&) const {
        return first_of({dry(), not_at_rest(true), no_pair()});
    }
    Why operator()(const command::SetPlan& c) const {
        if (in<phase::Connecting>()) return "connecting";
        if (in<phase::Busy>() || in<phase::Halting>()) {
            return "something is going on: stop it or wait";
        }
        if (!s.data.captures.empty() && !same_but_speed(s.plan, c.plan)) {
            return "the turn has begun: its views are judged by the limits it began with";
        }
        return problem_of(s.plan, c.plan);
    }
};

}  // namespace

std::optional<std::string> refusal(const ProcedureState& state, const Command& command) {
    return std::visit(Guard{state}, command);
}

}  // namespace gripscan
