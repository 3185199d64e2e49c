#include "ui/views/stages.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/units.h"
#include "ui/theme/shown_number.h"
#include "ui/views/activity_text.h"
#include "ui/views/step_text.h"

namespace gripscan::ui {
namespace {

template <typename T>
bool in(const ProcedureState& state) {
    return std::holds_alternative<T>(state.phase);
}

template <typename T>
bool doing(const ProcedureState& state) {
    const Activity* activity = activity_of(state);
    return activity != nullptr && std::holds_alternative<T>(*activity);
}
const CellCheckItem* first_with(const CellReport& report, CheckOutcome outcome) {
    const auto found = std::find_if(report.items.begin(), report.items.end(),
                                    [&](const auto& item) { return item.outcome == outcome; });
    return found == report.items.end() ? nullptr : &*found;
}

StageText connect(const ProcedureState& state) {
    StageText stage{"stage.connect", "Connect"};
    stage.page = Page::kCell;
    if (const auto* offline = std::get_if<phase::Offline>(&state.phase)) {
        stage.state = offline->why.empty() ? State::kWaiting : State::kReject;
        stage.criterion = offline->why.empty() ? "robot and camera" : "no link";
        stage.why = offline->why;
        return stage;
    }
    if (in<phase::Connecting>(state)) {
        stage.state = State::kRunning;
        stage.criterion = "opening the link";
        return stage;
    }
    stage.state = State::kAccept;
    stage.criterion = state.robot ? state.robot->model : "camera; the operator turns";
    if (!state.cell) return stage;
    for (const CellCheckItem& item : state.cell->items) {
        if (item.name != "link" || item.outcome == CheckOutcome::kSkipped) continue;
        stage.criterion = fmt::format("link {:.0f} ms ≤ {:.0f} ms", item.value, item.limit);
        stage.why = item.sentence;
    }
    return stage;
}

StageText cell_check(const ProcedureState& state) {
    StageText stage{"stage.cell", "Cell check"};
    stage.page = Page::kCell;
    if (doing<activity::CheckingCell>(state)) {
        stage.state = State::kRunning;
        stage.criterion = "measuring";
        return stage;
    }
    if (!state.cell) {
        stage.criterion = "every item in its limit";
        return stage;
    }
    const CellReport& report = *state.cell;
    const auto count = [&](CheckOutcome outcome) {
        return std::count_if(report.items.begin(), report.items.end(),
                             [&](const auto& item) { return item.outcome == outcome; });
    };
    const auto asked = static_cast<long>(report.items.size()) - count(CheckOutcome::kSkipped);
    stage.criterion = fmt::format("{} of {} in their limits", count(CheckOutcome::kPassed), asked);
    stage.state = State::kAccept;
    if (const CellCheckItem* failed = first_with(report, CheckOutcome::kFailed)) {
        stage.state = state.cell_note.empty() ? State::kReject : State::kCheck;
        stage.criterion = state.cell_note.empty() ? fmt::format("{} failed", failed->name)
                                                  : "failed, accepted with note";
        stage.why = failed->sentence;
    } else if (const CellCheckItem* warned = first_with(report, CheckOutcome::kWarned)) {
        stage.state = State::kCheck;
        stage.criterion += ", " + warned->name;
        stage.why = warned->sentence;
    }
    return stage;
}

/// Left out by many: nothing waits for it.
StageText environment(const Snapshot& s) {
    StageText stage{"stage.environment", "Environment"};
    stage.page = Page::kCell;
    stage.criterion = "not learned, may be left out";
    if (!s.environment) return stage;
    stage.state = State::kAccept;
    stage.criterion = fmt::format("{} views, {} % unknown", s.environment->captures,
                                  shown_number(100.0 * (1.0 - s.environment->known), 1));
    stage.why = s.environment->folder.string();
    return stage;
}

StageText recognise_stage(const Snapshot& s) {
    StageText stage{"stage.recognise", "Recognise"};
    stage.page = Page::kRecognise;
    stage.criterion =
        s.library.empty() ? "needs a template" : fmt::format("{} templates", s.library.size());
    if (!s.recognition) return stage;
    stage.state = s.recognition->found.empty() ? State::kCheck : State::kAccept;
    stage.criterion =
        fmt::format("view {}, {} found", s.recognition->view, s.recognition->found.size());
    return stage;
}

StageText warm_up(const ProcedureState& state) {
    StageText stage{"stage.warm_up", "Axis warm-up"};
    if (warming_up(state)) {
        stage.state = State::kRunning;
        stage.criterion = fmt::format("view {} of {}",
                                      std::min(state.warm_up_shots + 1, state.plan.warm_up_shots),
                                      state.plan.warm_up_shots);
        return stage;
    }
    if (!state.warm_up) {
        stage.criterion = state.data.captures.empty()
                              ? fmt::format("{} small turns", state.plan.warm_up_shots)
                              : "left out";
        return stage;
    }
    stage.why = state.warm_up->sentence;
    if (const auto& axis = state.warm_up->axis) {
        stage.state = State::kAccept;
        stage.criterion =
            fmt::format("axis sd {}°, {} mm", shown_number(deg_from_rad(axis->sd_rad), 2),
                        shown_number(kMmPerM * axis->sd_m, 2));
    } else {
        stage.state = State::kCheck;
        stage.criterion = "the surface does not show it";
    }
    return stage;
}

std::string closure_text(const Snapshot& s) {
    if (!s.solved || !s.solved->report.closure_before) return "turn finished";
    const Closure& closure = *s.solved->report.closure_before;
    return fmt::format("closure {}°, {} mm", shown_number(deg_from_rad(closure.angle_rad), 2),
                       shown_number(kMmPerM * closure.shift_m, 2));
}

StageText gripper(const Snapshot& s) {
    const ProcedureState& state = *s.procedure;
    StageText stage{"stage.gripper", s.session && s.session->object ? "Object" : "Gripper"};
    const auto table = table_of(state);
    const int planned = steps_planned(state);
    if (in<phase::Finished>(state)) {
        const bool all = std::all_of(table.begin(), table.end(), [](const JudgedStep& step) {
            return state_of(step.row.verdict) == State::kAccept;
        });
        stage.state = all ? State::kAccept : State::kCheck;
        stage.criterion = closure_text(s);
        return stage;
    }
    if (state.data.captures.empty()) {
        stage.criterion = fmt::format("{} steps to 360°", planned);
        return stage;
    }
    const std::string count = fmt::format("step {} of {}", table.size(), planned);
    if (in<phase::Deciding>(state) && !table.empty()) {
        stage.state = state_of(table.back().row.verdict);
        stage.criterion =
            count + (stage.state == State::kReject ? " rejected" : " to be looked at");
        stage.why = table.back().row.sentence;
        return stage;
    }
    if (const auto* interrupted = std::get_if<phase::Interrupted>(&state.phase)) {
        stage.state = State::kCheck;
        stage.criterion = count + ", interrupted";
        stage.why = interrupted->why;
        return stage;
    }
    stage.state = State::kRunning;
    stage.criterion = fmt::format("{}, {}°", count, shown_number(dial_of(s).turned_deg, 1));
    return stage;
}

StageText export_stage(const Snapshot& s) {
    StageText stage{"stage.export", "Export"};
    stage.page = Page::kTemplate;
    stage.criterion = "needs the whole turn";
    if (!s.last_export.empty()) {
        stage.state = State::kAccept;
        stage.criterion = "read back equal";
        stage.why = s.last_export;
    } else if (s.solved && s.procedure->solved) {
        stage.criterion = fmt::format(
            "{} points", shown_count(static_cast<long long>(s.procedure->solved->template_points)));
    }
    return stage;
}

std::string_view current_of(const ProcedureState& state) {
    if (in<phase::Offline>(state) || in<phase::Connecting>(state)) return "stage.connect";
    if (in<phase::Finished>(state)) return "stage.export";
    if (!state.data.captures.empty()) return "stage.gripper";
    if (!state.cell || (!state.cell->passed() && state.cell_note.empty())) return "stage.cell";
    const bool turns = state.plan.mode != MotionMode::kManual;
    return turns && !state.warm_up ? "stage.warm_up" : "stage.gripper";
}

}  // namespace

std::vector<StageText> stages_of(const Snapshot& s) {
    if (s.procedure == nullptr) return {};
    const ProcedureState& state = *s.procedure;
    std::vector<StageText> stages{connect(state), cell_check(state), environment(s)};
    if (state.plan.mode != MotionMode::kManual) stages.push_back(warm_up(state));
    stages.push_back(gripper(s));
    stages.push_back(recognise_stage(s));
    stages.push_back(export_stage(s));
    for (StageText& stage : stages) stage.current = stage.id == current_of(state);
    return stages;
}

}  // namespace gripscan::ui
