// What each command does, once guards.cpp has let it through.
#include <algorithm>

#include "core/procedure/draft.h"

namespace gripscan {
namespace {

/// Restores data, without losing captures that were taken since: they stay, given up.
void restore(Draft& draft, const TurnData& earlier) {
    TurnData data = earlier;
    for (const CaptureRecord& capture : draft.state.data.captures) {
        if (data.find(capture.index) != nullptr) continue;
        data.captures.push_back(capture);
        if (capture.status == CaptureStatus::kUsed) {
            data.captures.back().status = CaptureStatus::kSuperseded;
        }
    }
    std::sort(data.captures.begin(), data.captures.end(),
              [](const auto& a, const auto& b) { return a.index < b.index; });
    for (const CaptureRecord& capture : data.captures) {
        const CaptureRecord* now = draft.state.data.find(capture.index);
        if (now != nullptr && (now->mode != capture.mode || now->attempt != capture.attempt)) {
            draft.forget_judged(capture.index);
        }
    }
    draft.state.data = std::move(data);
    draft.data_changed();
}

struct TakeCommand {
    Draft& draft;
    ProcedureState& s = draft.state;

    void operator()(const command::Connect&) const {
        std::optional<Activity> interrupted;
        if (auto* offline = std::get_if<phase::Offline>(&s.phase)) {
            interrupted = std::move(offline->interrupted);
        }
        if (auto* stopped = std::get_if<phase::Interrupted>(&s.phase)) {
            interrupted = std::move(stopped->activity);
        }
        s.phase = phase::Connecting{std::move(interrupted)};
        draft.effects.emplace_back(effect::OpenLink{});
    }

    void operator()(const command::CheckCell&) const { draft.begin(activity::CheckingCell{}); }

    void operator()(const command::WarmUp&) const {
        draft.settle_start();
        s.warm_up.reset();
        s.warm_up_shots = 0;
        s.warm_up_joint6_rad = draft.start_of_warm_up();
        draft.shoot(draft.warm_up_shot());
    }

    void operator()(const command::Capture&) const {
        if (const auto* busy = std::get_if<phase::Busy>(&s.phase)) {
            const Shot shot = std::get<activity::AwaitingOperator>(busy->activity).shot;
            return draft.begin(activity::Exposing{shot});
        }
        draft.settle_start();
        draft.remember();
        const Shot shot = draft.shot_at(0.0);
        // Without motion rights the turn begins where the joint stands.
        if (s.plan.mode == MotionMode::kManual) return draft.begin(activity::Exposing{shot});
        draft.shoot_from_below(shot);
    }

    void operator()(const command::Step&) const {
        if (s.plan.mode == MotionMode::kDry) {
            draft.settle_start();
            const double at_rad = s.rehearsed_joint6_rad.empty() ? draft.joint6_of(0.0)
                                                                 : s.rehearsed_joint6_rad.back();
            const double end_rad = draft.joint6_of(s.plan.total_rad);
            return draft.drive_to(std::min(at_rad + s.data.step_rad, end_rad), std::nullopt);
        }
        draft.remember();
        const double next = s.data.last_used()->commanded_rad + s.data.step_rad;
        draft.shoot(draft.shot_at(std::min(next, s.plan.total_rad)));
    }

    void operator()(const command::Retry&) const {
        draft.remember();
        draft.shoot(draft.shot_at(s.data.last_used()->commanded_rad));
    }

    void operator()(const command::Halve&) const {
        draft.remember();
        const auto used = s.data.used();
        const double to = s.data.captures[used.back()].commanded_rad;
        const double from = s.data.captures[used[used.size() - 2]].commanded_rad;
        s.data.step_rad = 0.5 * (to - from);
        draft.shoot(draft.shot_at(from + s.data.step_rad));
    }

    void operator()(const command::LockAxis&) const {
        draft.remember();
        s.data.axis_locked = true;
        const auto used = s.data.used();
        if (used.size() > 1) {
            CaptureRecord& last = s.data.captures[used.back()];
            last.mode = TurnMode::kAxisLocked;
            draft.forget_judged(last.index);
        }
        draft.data_changed();
    }

    void operator()(const command::Accept& c) const {
        if (s.data.captures.empty()) {
            s.cell_note = c.note;
            return;
        }
        draft.remember();
        s.data.find(s.data.last_used()->index)->note = c.note;
        draft.data_changed();
    }

    void operator()(const command::Back&) const {
        draft.remember();
        const auto used = s.data.used();
        s.data.captures[used.back()].status = CaptureStatus::kSuperseded;
        draft.data_changed();
        draft.drive_to(draft.joint6_of(s.data.captures[used[used.size() - 2]].commanded_rad),
                       std::nullopt);
    }

    void operator()(const command::Undo&) const {
        while (s.undo.size() > 1 && s.undo.back() == s.data) s.undo.pop_back();
        const TurnData earlier = s.undo.back();
        s.undo.pop_back();
        s.redo.push_back(s.data);
        restore(draft, earlier);
    }

    void operator()(const command::Redo&) const {
        const TurnData later = s.redo.back();
        s.redo.pop_back();
        s.undo.push_back(s.data);
        restore(draft, later);
    }

    void operator()(const command::Exclude& c) const {
        draft.remember();
        s.data.find(c.index)->status = CaptureStatus::kExcluded;
        draft.data_changed();
    }

    void operator()(const command::Retake& c) const {
        const CaptureRecord capture = *s.data.find(c.index);
        if (c.index == s.data.last_used()->index) return (*this)(command::Retry{});
        draft.remember();
        draft.shoot({ShotPurpose::kTurn, c.index, capture.attempt + 1, capture.commanded_rad});
    }

    void operator()(const command::TellAngle& c) const {
        s.told_joint6_rad = c.joint6_rad;
        const auto* busy = std::get_if<phase::Busy>(&s.phase);
        const auto* waiting =
            busy == nullptr ? nullptr : std::get_if<activity::AwaitingOperator>(&busy->activity);
        if (waiting == nullptr) return;
        Shot shot = waiting->shot;
        shot.commanded_rad = c.joint6_rad - s.plan.start_joint6_rad.value_or(0.0);
        draft.begin(activity::Exposing{shot});
    }

    void operator()(const command::Run&) const { s.running = true; }
    void operator()(const command::Pause&) const { s.running = false; }

    void operator()(const command::Stop&) const {
        s.running = false;
        const auto* busy = std::get_if<phase::Busy>(&s.phase);
        if (busy == nullptr) return;
        Activity activity = busy->activity;
        if (std::holds_alternative<activity::AwaitingOperator>(activity)) {
            s.phase = phase::Idle{};
            return;
        }
        draft.effects.emplace_back(effect::Halt{});
        s.phase = phase::Halting{std::move(activity)};
    }

    void operator()(const command::Resume&) const {
        const Activity activity = std::get<phase::Interrupted>(s.phase).activity;
        draft.begin_again(activity);
    }

    void operator()(const command::SetPlan& c) const {
        draft.effects.emplace_back(effect::SavePlan{});
        if (!s.data.captures.empty()) {  // only the speed is another
            s.plan.speed_percent = c.plan.speed_percent;
            return;
        }
        s.plan = c.plan;
        s.data.step_rad = c.plan.step_rad;
        // Range and duration were measured for the plan before.
        s.cell.reset();
        s.cell_note.clear();
        s.undo.clear();
        s.redo.clear();
    }

    void operator()(const command::Finish&) const { draft.begin(activity::Solving{}); }
};

}  // namespace

void take_command(Draft& draft, const Command& command) {
    if (auto why = refusal(draft.state, command)) return draft.refuse(std::move(*why));
    std::visit(TakeCommand{draft}, command);
}

}  // namespace gripscan
