#include "ui/memory/session_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/procedure/engine.h"
#include "core/procedure/journal_codec.h"
#include "core/report/results_folder.h"
#include "core/report/table1.h"
#include "core/session/resume.h"
#include "core/session/session.h"

namespace gripscan::ui {
namespace {
namespace fs = std::filesystem;
using End = RecentSession::End;

std::string cell_name(const std::string& cell) {
    return cell == "sim" ? "SIM" : fs::path(cell).stem().string();
}

std::string field(const JournalFields& fields, std::string_view name) {
    const auto found = std::find_if(fields.begin(), fields.end(),
                                    [&](const auto& entry) { return entry.first == name; });
    return found == fields.end() ? std::string() : found->second;
}

/// What the journal leads to, as far as it can be read; it also names the cell.
std::optional<ProcedureState> remembered(const fs::path& folder, std::string& cell) {
    const auto memory = open_memory(folder);
    if (!memory) return std::nullopt;
    std::optional<TurnPlan> plan;
    std::vector<Input> inputs;
    for (const JournalEntry& entry : memory->entries) {
        if (entry.event == "cell") {
            cell = cell_name(field(entry.fields, "cell"));
        } else if (entry.event == "plan") {
            auto read = decode_plan(entry.fields);
            if (!read) return std::nullopt;
            plan = *read;
        } else if (auto input = decode_input(entry.event, entry.fields); !input) {
            return std::nullopt;
        } else if (*input) {
            inputs.push_back(std::move(**input));
        }
    }
    if (!plan) return std::nullopt;
    ProcedureState first;
    first.plan = *plan;
    first.data.step_rad = plan->step_rad;
    auto state = replay_inputs(first, inputs);
    if (!state) return std::nullopt;
    return *std::move(state);
}

int steps_of(double total_rad, double step_rad) {
    return step_rad > 0.0 ? static_cast<int>(std::lround(total_rad / step_rad)) : 0;
}

/// Steps done, and what is left at the size of the next one.
void take_progress(RecentSession& line, const ProcedureState& state) {
    const auto used = state.data.used();
    line.steps_done = std::max(0, static_cast<int>(used.size()) - 1);
    double turned_rad = 0.0;
    if (!used.empty()) turned_rad = state.data.captures[used.back()].commanded_rad;
    const double step_rad = state.data.step_rad > 0.0 ? state.data.step_rad : state.plan.step_rad;
    line.steps_total =
        line.steps_done + std::max(0, steps_of(state.plan.total_rad - turned_rad, step_rad));
}

void take_interruption(RecentSession& line, const ProcedureState& state) {
    line.end = End::kInterrupted;
    if (const auto* deciding = std::get_if<phase::Deciding>(&state.phase)) {
        line.sentence = deciding->advice.sentence;
    } else if (state.data.captures.empty()) {
        line.sentence = "begun, nothing captured yet";
    } else {
        line.sentence = fmt::format("step {} is next, nothing is lost", line.steps_done + 1);
    }
}

void take_results(RecentSession& line, const TurnReport& report) {
    const TurnSummary summary = summary_of(report);
    line.steps_done = static_cast<int>(summary.steps);
    line.steps_total = std::max(line.steps_total, line.steps_done);
    if (report.closure_after) {
        line.closure_deg = deg_from_rad(report.closure_after->angle_rad);
        line.closure_mm = report.closure_after->shift_m * kMmPerM;
    }
    const auto first = [&](Verdict verdict) {
        return std::find_if(report.steps.begin(), report.steps.end(),
                            [&](const TurnStep& s) { return s.verdict == verdict; });
    };
    if (summary.rejected > 0) {
        line.end = End::kRejected;
        const TurnStep& step = *first(Verdict::kReject);
        line.sentence = step.cause == Cause::kNone
                            ? fmt::format("step {} rejected", step.index)
                            : fmt::format("step {} rejected: {}", step.index, word(step.cause));
    } else if (summary.checks > 0) {
        line.end = End::kCheck;
        line.sentence = summary.checks == 1
                            ? fmt::format("step {} to be checked", first(Verdict::kCheck)->index)
                            : fmt::format("{} steps to be checked", summary.checks);
    } else {
        line.end = End::kComplete;
        line.sentence = "complete";
    }
    std::replace(line.sentence.begin(), line.sentence.end(), '_', ' ');
}

void take_table(RecentSession& line, const Session& session) {
    const auto used =
        std::count_if(session.table.rows.begin(), session.table.rows.end(),
                      [](const CaptureRow& row) { return row.status == CaptureStatus::kUsed; });
    line.steps_done = line.steps_total = std::max(0, static_cast<int>(used) - 1);
    line.end = End::kComplete;
    line.sentence = "recorded, not computed yet";
}

RecentSession missing(RecentSession line, std::string why) {
    line.end = End::kMissing;
    line.sentence = std::move(why);
    return line;
}

std::string name_of(const fs::path& folder) {
    return (folder.has_filename() ? folder : folder.parent_path()).filename().string();
}

}  // namespace

RecentSession session_line(const fs::path& folder) {
    RecentSession line;
    line.folder = folder;
    line.name = name_of(folder);
    std::error_code code;
    if (!fs::is_directory(folder, code)) return missing(line, "the folder is gone");
    const auto session = open_session(folder);
    const auto state = remembered(folder, line.cell);
    if (!session && !state) return missing(line, session.error().message);
    if (session) {
        line.kind = word(session->spec.kind);
        take_table(line, *session);
    }
    if (state) {
        take_progress(line, *state);
        if (!std::holds_alternative<phase::Finished>(state->phase)) {
            take_interruption(line, *state);
            return line;
        }
    }
    if (const auto results = load_results(folder / "results"); results) {
        take_results(line, results->report);
    }
    return line;
}

}  // namespace gripscan::ui
