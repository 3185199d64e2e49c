#include "app/workstation/turn_log.h"

#include <fmt/format.h>

#include <utility>

#include "core/base/units.h"

namespace gripscan::app {
namespace {
using ui::LogLevel;

/// Why nothing goes on although it should; empty: nothing is wrong.
std::string trouble_of(const Phase& phase) {
    if (const auto* offline = std::get_if<phase::Offline>(&phase)) return offline->why;
    if (const auto* interrupted = std::get_if<phase::Interrupted>(&phase)) return interrupted->why;
    return {};
}

}  // namespace

std::vector<ui::LogLine> TurnLog::news(const ProcedureState& state) {
    tell_phase(state);
    tell_cell(state);
    if (state.warm_up && !std::exchange(axis_told_, true)) {
        say(state.warm_up->axis ? LogLevel::kInformation : LogLevel::kWarning,
            state.warm_up->axis ? "AXS-001" : "AXS-010", state.warm_up->sentence);
    }
    tell_captures(state);
    tell_steps(state);
    for (; advice_told_ < state.advice.size(); ++advice_told_) {
        say(LogLevel::kWarning, "ADV-001", state.advice[advice_told_].advice.sentence);
    }
    for (; rehearsed_told_ < state.rehearsed_joint6_rad.size(); ++rehearsed_told_) {
        say(LogLevel::kInformation, "RUN-020",
            fmt::format("DRY: would turn joint 6 to {:.3f}°",
                        deg_from_rad(state.rehearsed_joint6_rad[rehearsed_told_])));
    }
    if (state.solved && !solved_told_) {
        say(LogLevel::kInformation, "MRG-001",
            fmt::format("Merged {} points, {} of {} steps accepted", state.solved->template_points,
                        state.solved->accepted, state.solved->steps));
    }
    solved_told_ = state.solved.has_value();
    return std::exchange(news_, {});
}

void TurnLog::say(LogLevel level, std::string_view code, std::string text) {
    news_.push_back({std::chrono::system_clock::now(), level, std::string(code), std::move(text)});
}

void TurnLog::tell_phase(const ProcedureState& state) {
    if (state.robot && !std::exchange(robot_told_, true)) {
        say(LogLevel::kInformation, "LNK-001",
            fmt::format("{}: {} ({})", word(state.plan.mode), state.robot->model,
                        state.robot->protocol));
    }
    std::string trouble = trouble_of(state.phase);
    if (trouble == trouble_told_) return;
    trouble_told_ = std::move(trouble);
    if (trouble_told_.empty()) return;
    if (std::holds_alternative<phase::Offline>(state.phase)) {
        say(LogLevel::kError, "LNK-010", trouble_told_);
    } else {
        say(LogLevel::kWarning, "RUN-010", trouble_told_);
    }
}

void TurnLog::tell_cell(const ProcedureState& state) {
    if (!state.cell) return;
    for (const CellCheckItem& item : state.cell->items) {
        std::string& told = items_told_[item.name];
        const std::string line = fmt::format("{} {}", word(item.outcome), item.sentence);
        // Measured again after the warm-up: what passed before need not be told twice.
        const bool passed_again =
            item.outcome == CheckOutcome::kPassed && told.starts_with(word(item.outcome));
        if (told == line || passed_again) continue;
        told = line;
        if (item.outcome == CheckOutcome::kFailed) {
            say(LogLevel::kError, "CEL-010", item.sentence);
        } else if (item.outcome == CheckOutcome::kWarned) {
            say(LogLevel::kWarning, "CEL-005", item.sentence);
        } else {
            say(LogLevel::kInformation, "CEL-001", item.sentence);
        }
    }
}

void TurnLog::tell_captures(const ProcedureState& state) {
    for (const CaptureRecord& capture : state.data.captures) {
        if (!captures_told_.emplace(capture.index, capture.attempt).second) continue;
        const double joint6_rad =
            capture.before ? capture.before->joints_rad[5] : capture.commanded_rad;
        say(LogLevel::kInformation, "CAP-001",
            fmt::format("Capture {}: {} {:.3f}°, attempt {}", capture.index,
                        capture.before ? "J6" : "told", deg_from_rad(joint6_rad), capture.attempt));
    }
}

void TurnLog::tell_steps(const ProcedureState& state) {
    for (const JudgedStep& step : table_of(state)) {
        const TurnStep& row = step.row;
        std::string& told = steps_told_[{row.from, row.to}];
        if (told == row.sentence) continue;
        told = row.sentence;
        const std::string text = fmt::format("Step {} → {}: {}", row.from, row.to, row.sentence);
        switch (row.verdict) {
            case Verdict::kAccept:
                say(LogLevel::kInformation, "REG-001", text);
                break;
            case Verdict::kAcceptNoted:
                say(LogLevel::kInformation, "REG-002", text);
                break;
            case Verdict::kCheck:
                say(LogLevel::kWarning, "REG-010", text);
                break;
            case Verdict::kReject:
                say(LogLevel::kError, "REG-012", text);
                break;
        }
    }
}

}  // namespace gripscan::app
