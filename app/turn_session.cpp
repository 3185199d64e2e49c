#include "app/turn_session.h"

#include <array>

#include "core/base/units.h"
#include "core/procedure/engine.h"
#include "core/procedure/journal_codec.h"
#include "core/robot/joint6_limits.h"
#include "core/session/alignment_file.h"

namespace gripscan::app {
namespace {

constexpr std::string_view kCellEntry = "cell";

TurnPlan plan_of(const CellOptions& options, const Cell& cell) {
    TurnPlan plan;
    plan.mode = options.mode();
    plan.step_rad = rad_from_deg(options.step_deg);
    plan.speed_percent = cell.speed_percent;
    plan.largest_move_rad = rad_from_deg(kPieceOfTurn_deg);
    plan.limits = turn_limits(cell.limits);
    return plan;
}

ProcedureState first_state(const TurnPlan& plan) {
    ProcedureState state;
    state.plan = plan;
    state.data.step_rad = plan.step_rad;
    return state;
}

/// Cell, plan and inputs, in the order of the journal.
struct Entries {
    std::optional<CellOptions> options;
    std::optional<TurnPlan> plan;
    std::vector<Input> inputs;
};

Status read_entry(const JournalEntry& entry, Entries& read) {
    if (entry.event == kCellEntry) {
        auto options = cell_options_from(entry.fields);
        if (!options) return forward_error(options.error());
        read.options = std::move(*options);
        return {};
    }
    if (entry.event == "plan") {
        auto plan = decode_plan(entry.fields);
        if (!plan) return forward_error(plan.error());
        read.plan = std::move(*plan);
        return {};
    }
    auto input = decode_input(entry.event, entry.fields);
    if (!input) return forward_error(input.error());
    if (*input) read.inputs.push_back(std::move(**input));
    return {};
}

}  // namespace

Status keep_alignment(const std::filesystem::path& folder, const Cell& cell) {
    if (!cell.T_robot_camera) return {};
    AlignmentFile file;
    file.T_robot_camera = cell.T_robot_camera;
    file.method = cell.simulated != nullptr ? "simulated cell" : "cell file";
    return save_alignment(folder / "alignment.yaml", file);
}

Result<TurnSession> begin_session(const std::filesystem::path& folder, const CellOptions& options,
                                  const Cell& cell,
                                  const std::optional<std::string>& gripper_template) {
    SessionSpec spec;
    if (gripper_template) spec.kind = SessionKind::kObject;
    spec.gripper_template = gripper_template;
    spec.step_deg = options.step_deg;
    spec.region = cell.region;
    spec.axis_hint = cell.axis_hint;
    spec.limits = cell.limits;
    const TurnPlan plan = plan_of(options, cell);
    const std::array opening{JournalRecord{std::string(kCellEntry), journal_fields(options)},
                             encode(plan)};
    auto store = SessionStore::create(folder, spec, cell.rig, GRIPSCAN_VERSION, opening);
    if (!store) return forward_error(store.error());
    if (Status kept = keep_alignment(folder, cell); !kept) return forward_error(kept.error());
    return TurnSession{std::move(*store), spec, first_state(plan)};
}

Result<RecalledSession> recall_session(const SessionMemory& memory) {
    const auto journal = memory.folder / "journal";
    Entries read;
    for (const JournalEntry& entry : memory.entries) {
        if (Status s = read_entry(entry, read); !s) {
            return input_error("{}:{}: {}", journal.string(), entry.number, s.error().message);
        }
    }
    if (!read.options || !read.plan) {
        return input_error(
            "{}: the journal does not begin with cell and plan, so it is none of a run; what was "
            "recorded can be computed: gripscan replay",
            journal.string());
    }
    auto state = replay_inputs(first_state(*read.plan), read.inputs);
    if (!state) return input_error("{}: {}", journal.string(), state.error().message);
    return RecalledSession{*read.options, std::move(*state)};
}

Result<RememberedSession> remember_session(const std::filesystem::path& folder) {
    auto resumed = resume_session(folder);
    if (!resumed) return forward_error(resumed.error());
    auto recalled = recall_session(resumed->memory);
    if (!recalled) return forward_error(recalled.error());
    if (Status s = resumed->store.save_table(recalled->state.data.captures); !s) {
        return forward_error(s.error());
    }
    if (Status s = resumed->store.save_plan(recalled->state.plan); !s) {
        return forward_error(s.error());
    }
    return RememberedSession{std::move(resumed->store), resumed->memory.spec,
                             std::move(recalled->options), std::move(recalled->state)};
}

}  // namespace gripscan::app
