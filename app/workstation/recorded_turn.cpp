#include "app/workstation/recorded_turn.h"

#include "app/session_settings.h"
#include "app/turn_session.h"
#include "core/base/units.h"
#include "core/cloud/cloud_file.h"
#include "core/session/capture_joints.h"
#include "core/session/session.h"

namespace gripscan::app {
namespace {
namespace fs = std::filesystem;

CaptureRecord record_of(const CaptureRow& row) {
    CaptureRecord record;
    record.index = row.index;
    record.attempt = row.attempt.value_or(1);
    record.commanded_rad = rad_from_deg(row.commanded_deg.value_or(0.0));
    record.status = row.status;
    record.mode = row.mode;
    record.note = row.note;
    record.t_s = row.t_s.value_or(0.0);
    if (row.j6_after_deg) record.joint6_after_rad = rad_from_deg(*row.j6_after_deg);
    if (const auto joints = joints_rad(row)) record.before.emplace().joints_rad = *joints;
    return record;
}

TurnPlan plan_of(const SessionSpec& spec) {
    TurnPlan plan;
    if (spec.step_deg) plan.step_rad = rad_from_deg(*spec.step_deg);
    plan.limits = turn_limits(spec.limits);
    return plan;
}

/// Of a recording without the journal of a run.
ProcedureState state_of(const Session& session, const TurnReport& report) {
    ProcedureState state;
    state.phase = phase::Finished{};
    state.plan = plan_of(session.spec);
    state.data.step_rad = state.plan.step_rad;
    for (const CaptureRow& row : session.table.rows) {
        state.data.captures.push_back(record_of(row));
    }
    for (const TurnStep& step : report.steps) {
        state.judged[{step.from, step.to}] = JudgedStep{step, {}, {}};
    }
    state.solved = event::Solved{static_cast<int>(trusted_steps(report)),
                                 static_cast<int>(report.steps.size()), report.merged.size()};
    return state;
}

struct Computed {
    std::vector<ui::ShownCapture> captures;
    ComputedTurn turn;
};

Result<Computed> compute(const Session& session, const Progress& progress,
                         const ForEach& for_each) {
    const TurnRecording recording = recording_of(session);
    auto settings = session_settings(session, {});
    if (!settings) return forward_error(settings.error());
    auto workspace = TurnWorkspace::create(recording.rig, recording.region, *settings);
    if (!workspace) return forward_error(workspace.error());
    SeenCaptures seen([] {});
    if (recording.rig) {
        if (Status s = seen.set_rig(*recording.rig); !s) return forward_error(s.error());
    }
    std::vector<const RecordedCapture*> used;
    for (const RecordedCapture& capture : recording.captures) {
        if (capture.used) used.push_back(&capture);
    }
    const auto show = [&](const RecordedCapture& capture, const PreparedCapture& prepared) {
        seen.add(capture, prepared);
    };
    if (Status s = workspace->add_all(used, progress, for_each, show); !s) {
        return forward_error(s.error());
    }
    auto turn = workspace->solve(recording.captures, progress, for_each);
    if (!turn) return forward_error(turn.error());
    return Computed{seen.all(), std::move(*turn)};
}

}  // namespace

void RecordedTurn::show_in(ui::Snapshot& snapshot) const {
    snapshot.session = facts;
    snapshot.procedure = state ? &*state : nullptr;
    snapshot.captures = captures;
    snapshot.solved = solved;
    snapshot.cell = cell;
    snapshot.live.on = false;
    snapshot.live.why_off = "a recording has no camera";
}

Result<RecordedTurn> load_recorded_turn(const fs::path& folder, const Progress& progress,
                                        const ForEach& for_each) {
    auto session = open_session(folder);
    if (!session) return forward_error(session.error());
    const bool object = session->spec.kind == SessionKind::kObject;
    if (session->spec.kind != SessionKind::kGripper && !object) {
        return input_error("{}: a session of kind {} is no turn; kinds gripper and object are",
                           (folder / "session.yaml").string(), word(session->spec.kind));
    }
    auto computed = compute(*session, progress, for_each);
    if (!computed) return forward_error(computed.error());
    RecordedTurn recorded;
    recorded.facts = {folder, folder.filename().string(),    "recording",
                      true,   (folder / "results").string(), object};
    recorded.captures = std::move(computed->captures);
    recorded.solved = std::make_shared<ComputedTurn>(std::move(computed->turn));
    const TurnReport& report = recorded.solved->report;
    recorded.state = state_of(*session, report);
    if (const auto memory = open_memory(folder)) {
        // The cell check and the advice of the run; what it ended in is not going on any more.
        if (auto recalled = recall_session(*memory)) {
            recalled->state.judged = std::move(recorded.state->judged);
            recalled->state.solved = recorded.state->solved;
            recalled->state.phase = phase::Finished{};
            recalled->state.running = false;
            recorded.state = std::move(recalled->state);
        }
    }
    if (session->rig) {
        if (const auto rectifier = Rectifier::create(*session->rig)) {
            recorded.cell.rig = rectifier->rig();
        }
    }
    recorded.cell.region = session->spec.region;
    if (report.axis) {
        recorded.cell.axis = report.axis->axis;
        recorded.cell.axis_sd_rad = report.axis->sd_rad;
        recorded.cell.axis_sd_m = report.axis->sd_m;
    }
    return recorded;
}

Result<RecordedTurn> load_cloud_alone(const fs::path& file) {
    auto cloud = load_cloud(file);
    if (!cloud) return forward_error(cloud.error());
    RecordedTurn recorded;
    recorded.facts = {file, file.filename().string(), "cloud file", true, ""};
    auto turn = std::make_shared<ComputedTurn>();
    turn->report.merged = std::move(*cloud);
    recorded.solved = std::move(turn);
    return recorded;
}

}  // namespace gripscan::app
