// What each report of devices and computation changes.
#include <algorithm>
#include <limits>

#include "core/procedure/draft.h"
#include "core/procedure/motion_plan.h"

namespace gripscan {
namespace {

/// The new view takes its place: one at the same angle is retaken by it, those beyond it were
/// halved over or gone back from.
void insert(ProcedureState& state, CaptureRecord record) {
    TurnData& data = state.data;
    record.mode = data.axis_locked ? TurnMode::kAxisLocked : TurnMode::kFree;
    if (state.plan.mode == MotionMode::kManual && record.before) {
        record.commanded_rad =
            record.before->joints_rad[5] - state.plan.start_joint6_rad.value_or(0.0);
    }
    if (CaptureRecord* earlier = data.find(record.index)) {
        record.mode = earlier->mode;
        *earlier = std::move(record);
        return;
    }
    for (CaptureRecord& other : data.captures) {
        const bool taken_over = other.commanded_rad > record.commanded_rad ||
                                same_angle(other.commanded_rad, record.commanded_rad);
        if (other.status == CaptureStatus::kUsed && taken_over) {
            other.status = CaptureStatus::kSuperseded;
        }
    }
    data.captures.push_back(std::move(record));
}

bool is_warm_up(const std::optional<Shot>& shot) {
    return shot && shot->purpose == ShotPurpose::kWarmUp;
}

/// What is left of an activity once the program has ended. Pictures of a warm-up are not kept: it
/// begins anew, after a motion whose end is unknown.
std::optional<Activity> after_restart(Activity activity) {
    if (std::holds_alternative<activity::EstimatingAxis>(activity)) return std::nullopt;
    if (const auto* exposing = std::get_if<activity::Exposing>(&activity)) {
        if (is_warm_up(exposing->shot)) return std::nullopt;
    }
    if (auto* moving = std::get_if<activity::Moving>(&activity)) {
        if (is_warm_up(moving->shot)) moving->shot.reset();
    }
    return activity;
}

struct TakeEvent {
    Draft& draft;
    ProcedureState& s = draft.state;

    /// The activity that is going on, if it is of this kind.
    template <typename T>
    const T* going_on() const {
        const Activity* activity = nullptr;
        if (const auto* busy = std::get_if<phase::Busy>(&s.phase)) activity = &busy->activity;
        if (const auto* halting = std::get_if<phase::Halting>(&s.phase)) {
            activity = &halting->activity;
        }
        return activity == nullptr ? nullptr : std::get_if<T>(activity);
    }

    void not_expected() const { draft.refuse("nothing that could report this is going on"); }

    void interrupt(Activity activity, const std::string& why) const {
        s.running = false;
        s.phase = phase::Interrupted{std::move(activity), why};
    }

    void operator()(const event::LinkUp& e) const {
        auto* connecting = std::get_if<phase::Connecting>(&s.phase);
        if (connecting == nullptr) return not_expected();
        s.robot = e.identity;
        s.reading = e.reading;
        if (connecting->interrupted) {
            const Activity activity = *connecting->interrupted;
            s.phase = phase::Interrupted{
                activity, "it was cut off here; the robot is connected again and it can go on"};
        } else {
            draft.judge_next();
        }
    }

    void operator()(const event::LinkDown& e) const {
        std::optional<Activity> interrupted;
        if (auto* connecting = std::get_if<phase::Connecting>(&s.phase)) {
            interrupted = std::move(connecting->interrupted);
        } else if (auto* stopped = std::get_if<phase::Interrupted>(&s.phase)) {
            interrupted = std::move(stopped->activity);
        } else if (std::holds_alternative<phase::Offline>(s.phase)) {
            return draft.refuse("the link is known to be down");
        } else if (std::holds_alternative<phase::Busy>(s.phase) ||
                   std::holds_alternative<phase::Halting>(s.phase)) {
            return draft.refuse("what is going on will report it");
        }
        s.running = false;
        s.phase = phase::Offline{e.why, std::move(interrupted)};
    }

    void operator()(const event::CellChecked& e) const {
        if (going_on<activity::CheckingCell>() == nullptr) return not_expected();
        s.cell = e.report;
        s.cell_note.clear();
        if (!e.report.passed()) s.running = false;
        s.phase = phase::Idle{};
    }

    void operator()(const event::Arrived& e) const {
        const auto* found = going_on<activity::Moving>();
        if (found == nullptr) return not_expected();
        activity::Moving moving = *found;
        s.reading = e.reading;
        const double asked_rad = moving.command.angle_rad;
        if (!stands_at(e.reading.joints_rad[5], asked_rad)) {
            moving.command.id = 0;
            return interrupt(moving, fmt::format("joint 6 stands at {:.3f} deg instead of {:.3f} "
                                                 "deg; the robot did not finish its motion",
                                                 deg_from_rad(e.reading.joints_rad[5]),
                                                 deg_from_rad(asked_rad)));
        }
        if (!moving.then_rad.empty()) {
            moving.command.id = s.next_motion_id++;
            moving.command.angle_rad = moving.then_rad.front();
            moving.renumbered = false;
            moving.then_rad.erase(moving.then_rad.begin());
            return draft.begin(moving);
        }
        if (moving.shot) return draft.begin(activity::Exposing{*moving.shot});
        draft.rest();
    }

    void operator()(const event::TurnFailed& e) const {
        const auto* found = going_on<activity::Moving>();
        if (found == nullptr) return not_expected();
        activity::Moving moving = *found;
        switch (e.fault) {
            case RobotFault::kStaleId:
                // Ids of an earlier session: go on above them, once.
                if (moving.renumbered || e.last_id == std::numeric_limits<int>::max()) {
                    moving.command.id = 0;
                    moving.renumbered = false;
                    return interrupt(moving,
                                     fmt::format("{}; restart the server on the controller, "
                                                 "then resume",
                                                 e.why));
                }
                s.next_motion_id = std::max(s.next_motion_id, e.last_id + 1);
                moving.command.id = s.next_motion_id++;
                moving.renumbered = true;
                return draft.begin(moving);
            case RobotFault::kLost:
            case RobotFault::kTimeout:
            case RobotFault::kUnreachable:
                s.running = false;
                s.phase = phase::Offline{e.why, moving};
                return;
            default:
                moving.command.id = 0;
                return interrupt(moving, e.why);
        }
    }

    void operator()(const event::TurnLogged&) const {
        const auto* moving = going_on<activity::Moving>();
        if (moving == nullptr) return not_expected();
        std::vector<double>& logged = s.rehearsed_joint6_rad;
        logged.push_back(moving->command.angle_rad);
        logged.insert(logged.end(), moving->then_rad.begin(), moving->then_rad.end());
        if (!same_angle(logged.back(), draft.joint6_of(s.plan.total_rad))) {
            s.phase = phase::Idle{};
            return;
        }
        const auto home = draft.way_from(logged.back(), draft.joint6_of(0.0));
        logged.insert(logged.end(), home.begin(), home.end());
        s.phase = phase::Finished{};
    }

    void operator()(const event::Exposed& e) const {
        const auto* exposing = going_on<activity::Exposing>();
        if (exposing == nullptr) return not_expected();
        if (e.record.before) s.reading = e.record.before;
        if (exposing->shot.purpose == ShotPurpose::kWarmUp) {
            ++s.warm_up_shots;
            if (s.warm_up_shots < s.plan.warm_up_shots) return draft.shoot(draft.warm_up_shot());
            return draft.begin(activity::EstimatingAxis{});
        }
        draft.forget_judged(e.record.index);
        insert(s, e.record);
        draft.data_changed();
    }

    void operator()(const event::ExposureFailed& e) const {
        const auto* exposing = going_on<activity::Exposing>();
        if (exposing == nullptr) return not_expected();
        interrupt(*exposing, e.why);
    }

    void operator()(const event::Judged& e) const {
        const auto* judging = going_on<activity::Judging>();
        if (judging == nullptr) return not_expected();
        s.judged.insert_or_assign({judging->from, judging->to}, e.step);
        draft.judge_next();
    }

    void operator()(const event::AxisFound& e) const {
        if (going_on<activity::EstimatingAxis>() == nullptr) return not_expected();
        s.warm_up = e;
        if (e.cell) s.cell = e.cell;
        if (s.cell && !s.cell->passed() && s.cell_note.empty()) s.running = false;
        s.phase = phase::Idle{};
    }

    void operator()(const event::Solved& e) const {
        if (going_on<activity::Solving>() == nullptr) return not_expected();
        s.solved = e;
        const bool home = s.running && s.plan.start_joint6_rad && standing_joint6_rad(s) &&
                          s.plan.mode != MotionMode::kManual;
        s.running = false;
        draft.rest();
        // The safe pose at the end; the cable is unwound.
        if (home) draft.drive_to(*s.plan.start_joint6_rad, std::nullopt);
    }

    void operator()(const event::WorkFailed& e) const {
        for (const bool known : {going_on<activity::Judging>() != nullptr,
                                 going_on<activity::EstimatingAxis>() != nullptr,
                                 going_on<activity::Solving>() != nullptr,
                                 going_on<activity::CheckingCell>() != nullptr}) {
            if (!known) continue;
            if (const auto* busy = std::get_if<phase::Busy>(&s.phase)) {
                return interrupt(busy->activity, e.why);
            }
            return interrupt(std::get<phase::Halting>(s.phase).activity, e.why);
        }
        not_expected();
    }

    void operator()(const event::ProgramEnded&) const {
        s.running = false;
        s.reading.reset();
        std::optional<Activity> interrupted;
        if (auto* busy = std::get_if<phase::Busy>(&s.phase)) interrupted = busy->activity;
        if (auto* halting = std::get_if<phase::Halting>(&s.phase)) interrupted = halting->activity;
        if (auto* stopped = std::get_if<phase::Interrupted>(&s.phase)) {
            interrupted = stopped->activity;
        }
        if (auto* offline = std::get_if<phase::Offline>(&s.phase)) {
            interrupted = offline->interrupted;
        }
        if (auto* connecting = std::get_if<phase::Connecting>(&s.phase)) {
            interrupted = connecting->interrupted;
        }
        if (interrupted) interrupted = after_restart(std::move(*interrupted));
        s.phase = phase::Offline{"the program was started again", std::move(interrupted)};
    }
};

}  // namespace

void take_event(Draft& draft, const Event& event) {
    const bool halting = std::holds_alternative<phase::Halting>(draft.state.phase);
    std::visit(TakeEvent{draft}, event);
    // What was told to stop and ended well all the same does not go on to the next activity.
    const auto* busy = std::get_if<phase::Busy>(&draft.state.phase);
    if (!halting || busy == nullptr || draft.refused) return;
    Activity next = busy->activity;
    if (auto* moving = std::get_if<activity::Moving>(&next)) moving->command.id = 0;
    draft.state.phase = phase::Interrupted{std::move(next), "stopped by the operator"};
    std::erase_if(draft.effects, [](const Effect& effect) {
        return !std::holds_alternative<effect::SaveTable>(effect);
    });
}

}  // namespace gripscan
