#include "core/procedure/cell_effects.h"

#include "core/procedure/cell_check.h"
#include "core/procedure/measure_cell.h"
#include "core/procedure/robot_effects.h"

namespace gripscan {
namespace {

/// As the window and the journal keep it.
JudgedStep judged_step_of(const StepResult& result) {
    JudgedStep judged;
    judged.row = result.step;
    if (result.evidence.foreign_object && result.evidence.unexplained) {
        const Unexplained& part = *result.evidence.unexplained;
        judged.foreign = ForeignObject{part.centre_m, part.area_m2 * kMmPerM * kMmPerM};
    }
    for (const bool exceeded : {true, false}) {
        for (const EvidenceLine& line : result.lines) {
            if (line.exceeded != exceeded) continue;
            judged.evidence.push_back(fmt::format("{}: {}{}{}", line.what, line.value,
                                                  line.limit.empty() ? "" : ", limit ",
                                                  line.limit));
        }
    }
    return judged;
}

}  // namespace

/// One effect, with what it needs at hand.
struct CellEffects::Doing {
    CellEffects& self;
    const ProcedureState& state;
    const Progress& progress;

    Event operator()(const effect::OpenLink&) const { return open_link(self.cell_.robot); }
    Event operator()(const effect::MeasureCell&) const {
        auto report = self.checked(state, {}, progress);
        if (!report) return event::WorkFailed{report.error().message};
        return event::CellChecked{std::move(*report)};
    }
    Event operator()(const effect::Turn& e) const {
        return turn(self.cell_.robot, e.command, progress.stop);
    }
    Event operator()(const effect::LogTurn&) const { return event::TurnLogged{}; }
    Event operator()(const effect::Expose& e) const { return self.expose_shot(e.shot, progress); }
    Event operator()(const effect::Judge& e) const { return self.judge(e, state, progress); }
    Event operator()(const effect::EstimateAxis&) const { return self.estimate(state, progress); }
    Event operator()(const effect::Solve&) const { return self.solve(state, progress); }
    Event operator()(const effect::SaveTable&) const { return no_work(); }
    Event operator()(const effect::SavePlan&) const { return no_work(); }
    Event operator()(const effect::Halt&) const { return no_work(); }
    static Event no_work() { return event::WorkFailed{"the worker was given no work of its own"}; }
};

CellEffects::CellEffects(CellEquipment equipment, TurnWorkspace workspace, CaptureStore& store,
                         ResultKeeper& results, ForEach for_each)
    : cell_(std::move(equipment)),
      workspace_(std::move(workspace)),
      store_(store),
      results_(results),
      for_each_(std::move(for_each)) {}

Event CellEffects::run(const Effect& effect, const ProcedureState& state, std::stop_token stop) {
    const Progress progress{std::move(stop), report_};
    return std::visit(Doing{*this, state, progress}, effect);
}

void CellEffects::halt() {
    // Its outcome is told by the turn that it ends; where nothing moves there is nothing to stop.
    if (cell_.robot != nullptr) (void)cell_.robot->stop();
}

Result<CellReport> CellEffects::checked(const ProcedureState& state, const WarmUpAxis& warm_up,
                                        const Progress& progress) {
    std::vector<WarmUpView> views;
    for (const RecordedCapture& shot : warm_up_) {
        const PreparedView* view = workspace_.view(shot.index);
        if (warm_up.found.axis && view != nullptr && shot.joint6_rad) {
            views.push_back({&view->cloud, warm_up.sense * *shot.joint6_rad});
        }
    }
    const CellUnderTest cell{.robot = cell_.robot,
                             .source = cell_.source,
                             .rig = cell_.rig,
                             .region = cell_.region,
                             .session = cell_.session,
                             .T_robot_camera = cell_.T_robot_camera,
                             .axis = warm_up.found.axis,
                             .warm_up = views,
                             .settle_s = cell_.exposure.settle_s,
                             .compute_s = std::nullopt};
    const auto facts = measure_cell(cell, progress, for_each_);
    if (!facts) return forward_error(facts.error());
    if (facts->link && !facts->link->answers) {
        return device_error("the robot stopped answering during the cell check: {}",
                            facts->link->trouble);
    }
    return assess(*facts, state.plan);
}

Event CellEffects::expose_shot(const Shot& shot, const Progress& progress) {
    auto exposure =
        expose(cell_.robot, cell_.source, shot, cell_.differs, cell_.exposure, progress.stop);
    if (!exposure) return event::ExposureFailed{exposure.error().message};
    const CaptureRecord record = record_of(shot, *exposure);
    if (shot.purpose == ShotPurpose::kWarmUp) {
        if (shot.index == -1) warm_up_.clear();
        RecordedCapture capture = store_.recorded({&record, 1}).front();
        capture.load_images = [frame = std::move(exposure->frame)]() -> Result<StereoFrame> {
            return frame;
        };
        warm_up_.push_back(std::move(capture));
        return event::Exposed{record};
    }
    if (Status stored = store_.store_images(shot.index, shot.attempt, exposure->frame); !stored) {
        return event::ExposureFailed{stored.error().message};
    }
    return event::Exposed{record};
}

Status CellEffects::prepare(const std::vector<RecordedCapture>& captures,
                            const Progress& progress) {
    std::vector<const RecordedCapture*> missing;
    for (const RecordedCapture& capture : captures) {
        const auto held = prepared_attempts_.find(capture.index);
        const bool there = held != prepared_attempts_.end() && held->second == capture.attempts;
        if (capture.used && !there) missing.push_back(&capture);
    }
    return workspace_.add_all(missing, progress, for_each_,
                              [&](const RecordedCapture& capture, const PreparedCapture& prepared) {
                                  if (prepared_) prepared_(capture, prepared);
                                  prepared_attempts_[capture.index] = capture.attempts;
                              });
}

Status CellEffects::load(const TurnData& data, const Progress& progress) {
    return prepare(store_.recorded(data.captures), progress);
}

Event CellEffects::judge(const effect::Judge& pair, const ProcedureState& state,
                         const Progress& progress) {
    std::vector<RecordedCapture> so_far;
    for (RecordedCapture& capture : store_.recorded(state.data.captures)) {
        if (capture.used && capture.index <= pair.to) so_far.push_back(std::move(capture));
    }
    if (Status ready = prepare(so_far, progress); !ready) {
        return event::WorkFailed{ready.error().message};
    }
    workspace_.set_plan(state.plan.limits, state.plan.step_rad);
    workspace_.set_known_axis(state.warm_up ? state.warm_up->axis : std::nullopt);
    auto result = workspace_.last_step(so_far, progress, for_each_);
    if (!result) return event::WorkFailed{result.error().message};
    return event::Judged{judged_step_of(*result)};
}

Event CellEffects::estimate(const ProcedureState& state, const Progress& progress) {
    auto warm_up = find_axis(warm_up_, workspace_, cell_.axis_hint, progress, for_each_);
    if (!warm_up) return event::WorkFailed{warm_up.error().message};
    auto report = checked(state, *warm_up, progress);
    if (!report) return event::WorkFailed{report.error().message};
    warm_up->found.cell = std::move(*report);
    return warm_up->found;
}

Event CellEffects::solve(const ProcedureState& state, const Progress& progress) {
    const std::vector<RecordedCapture> captures = store_.recorded(state.data.captures);
    if (Status ready = prepare(captures, progress); !ready) {
        return event::WorkFailed{ready.error().message};
    }
    // A replay knows nothing of the warm-up, and must find the same.
    workspace_.set_known_axis(std::nullopt);
    workspace_.set_plan(state.plan.limits, state.plan.step_rad);
    auto computed = workspace_.solve(captures, progress, for_each_);
    if (!computed) return event::WorkFailed{computed.error().message};
    if (Status kept = results_.keep(*computed); !kept) {
        return event::WorkFailed{kept.error().message};
    }
    const TurnReport& report = computed->report;
    return event::Solved{static_cast<int>(trusted_steps(report)),
                         static_cast<int>(report.steps.size()), report.merged.size()};
}

}  // namespace gripscan
