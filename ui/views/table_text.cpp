#include "ui/views/table_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/number_text.h"
#include "core/base/units.h"
#include "core/procedure/remedy.h"
#include "core/registration/turn_check.h"
#include "ui/theme/shown_number.h"
#include "ui/views/activity_text.h"
#include "ui/views/step_text.h"

namespace gripscan::ui {
namespace {

/// A column of the screen and the one of Table 1 that it shows.
struct Source {
    std::string_view name;  ///< empty: made here
    int decimals = 0;
    double scale = 1.0;
    Sign sign = Sign::kMinusOnly;
    Emphasis emphasis = Emphasis::kNormal;
};

constexpr std::string_view kAngle = "Angle about J6, deg";
constexpr std::string_view kUnseen = "Not seen by the angle";
constexpr std::string_view kRotation = "Rotation, deg";
constexpr std::string_view kShift = "Shift, mm";

// What leaves first in a narrow window has the smallest number.
constexpr std::array<ColumnText, 17> kAgainstColumns{{{"step", "", 42},
                                                      {"try", "", 36, 1},
                                                      {"plan", kAngle, 56, 2},
                                                      {"robot", kAngle, 66},
                                                      {"ICP", kAngle, 66},
                                                      {"error", kAngle, 122},
                                                      {"err/σ", kAngle, 50, 7},
                                                      {"tilt °", kUnseen, 58, 8},
                                                      {"off mm", kUnseen, 58, 5},
                                                      {"slip mm", kUnseen, 60, 4},
                                                      {"ovl %", "Fit", 50},
                                                      {"RMS", "Fit", 54, 9},
                                                      {"90 %", "Fit", 54, 3},
                                                      {"axis inf", "Evidence", 58, 6},
                                                      {"mode", "Evidence", 58, 10, false, true},
                                                      {"", "Decision", 150, 0, true, true},
                                                      {"ICP °", "Sum", 74, 11}}};
constexpr std::array<Source, 17> kAgainstSources{
    {{"step"},
     {"attempts", 0, 1.0, Sign::kMinusOnly, Emphasis::kThird},
     {"commanded_deg", 2, 1.0, Sign::kMinusOnly, Emphasis::kThird},
     {"robot_deg", 3},
     {"icp_deg", 3},
     {"error_deg", 3, 1.0, Sign::kAlways},
     {"error_sigmas", 1, 1.0, Sign::kMinusOnly, Emphasis::kSecond},
     {"tilt_deg", 3},
     {"axis_offset_mm", 2},
     {"slip_mm", 2, 1.0, Sign::kAlways},
     {"overlap", 0, 100.0},
     {"rms_mm", 2},
     {"p90_mm", 2, 1.0, Sign::kMinusOnly, Emphasis::kSecond},
     {"observability", 2},
     {"mode"},
     {},
     {"cumulative_deg", 2}}};

constexpr std::array<ColumnText, 13> kPoseColumns{{{"step", "", 42},
                                                   {"try", "", 36, 1},
                                                   {"robot", kAngle, 70},
                                                   {"ICP", kAngle, 70},
                                                   {"error", kAngle, 122},
                                                   {"roll", kRotation, 78},
                                                   {"pitch", kRotation, 78},
                                                   {"yaw", kRotation, 78},
                                                   {"X", kShift, 78},
                                                   {"Y", kShift, 78},
                                                   {"Z", kShift, 78},
                                                   {"", "Decision", 150, 0, true, true},
                                                   {"ICP °", "Sum", 74, 2}}};
constexpr std::array<Source, 13> kPoseSources{
    {{"step"},
     {"attempts", 0, 1.0, Sign::kMinusOnly, Emphasis::kThird},
     {"robot_deg", 3},
     {"icp_deg", 3},
     {"error_deg", 3, 1.0, Sign::kAlways},
     {"roll_deg", 3},
     {"pitch_deg", 3},
     {"yaw_deg", 3},
     {"x_m", 2, kMmPerM},
     {"y_m", 2, kMmPerM},
     {"z_m", 2, kMmPerM},
     {},
     {"cumulative_deg", 2}}};

constexpr std::array<ColumnText, 11> kAttemptColumns{
    {{"capture", "", 66},
     {"try", "", 40},
     {"turn °", "Plan", 72},
     {"J6 °", "Robot", 84},
     {"after °", "Robot", 84, 1},
     {"time s", "Robot", 66, 2},
     {"mode", "Robot", 84, 3, false, true},
     {"", "Use", 150, 0, false, true},
     {"error °", "Against the view before", 84},
     {"", "Against the view before", 120, 0, false, true},
     {"", "Note", 120, 4, true, true}}};

struct Layout {
    std::span<const ColumnText> columns;
    std::span<const Source> sources;
};
Layout layout_of(TableView view) {
    if (view == TableView::kPose) return {kPoseColumns, kPoseSources};
    return {kAgainstColumns, kAgainstSources};
}

std::size_t column_in(const Table1& table, std::string_view name) {
    const auto found = std::find_if(table.columns.begin(), table.columns.end(),
                                    [&](const Table1Column& c) { return c.name == name; });
    return static_cast<std::size_t>(found - table.columns.begin());
}

CellText cell_of(const Table1& table, const Table1Row& row, const Source& source) {
    CellText cell;
    cell.emphasis = source.emphasis;
    if (source.name.empty()) return cell;
    const Table1Cell& value = row.cells[column_in(table, source.name)];
    if (const auto* number = std::get_if<double>(&value)) {
        // How many sigmas is asked of the size alone.
        const double shown = source.name == "error_sigmas" ? std::abs(*number) : *number;
        cell.text = shown_number(shown * source.scale, source.decimals, source.sign);
    } else if (const auto* words = std::get_if<std::string>(&value)) {
        cell.text = *words;
        if (!cell.text.empty() && source.name == "mode") {
            cell.text[0] = static_cast<char>(cell.text[0] - 'a' + 'A');
        }
    }
    return cell;
}

/// Places of the columns that are not only numbers.
struct Places {
    std::size_t error;
    std::size_t sigmas;  ///< past the end: not shown
    std::size_t decision;
};
Places places_of(TableView view) {
    return view == TableView::kPose ? Places{4, 99, 11} : Places{5, 6, 15};
}

CellText decision_of(const TurnStep& row) {
    const State state = state_of(row.verdict);
    CellText cell{std::string(word(state))};
    cell.shape = state;
    if (row.verdict == Verdict::kAcceptNoted) cell.note = "with note";
    if (state == State::kAccept) return cell;
    cell.note =
        row.cause == Cause::kNone ? row.sentence : std::string(remedy_for(row.cause).what_is_wrong);
    return cell;
}

void mark(RowText& row, const TurnStep& step, const TurnLimits& limits, TableView view) {
    const Places at = places_of(view);
    const State state = state_of(step.verdict);
    const Emphasis emphasis = state == State::kCheck    ? Emphasis::kCheck
                              : state == State::kReject ? Emphasis::kReject
                                                        : Emphasis::kNormal;
    if (step.error_rad) {
        row.cells[at.error].bar =
            std::clamp(*step.error_rad / angle_limit_rad(step, limits), -1.0, 1.0);
    }
    const bool angle_is_wrong =
        step.error_rad && std::abs(*step.error_rad) > angle_limit_rad(step, limits);
    if (angle_is_wrong) {
        row.cells[at.error].emphasis = emphasis;
        if (at.sigmas < row.cells.size()) row.cells[at.sigmas].emphasis = emphasis;
    }
    if (view == TableView::kRobotAgainstIcp) {
        if (step.tilt_rad && *step.tilt_rad > limits.tilt_rad) row.cells[7].emphasis = emphasis;
        if (step.slip_m && std::abs(*step.slip_m) > limits.slip_m) row.cells[9].emphasis = emphasis;
        if (step.overlap && *step.overlap < limits.overlap) row.cells[10].emphasis = emphasis;
    }
    row.cells[at.decision] = decision_of(step);
    if (state == State::kReject) row.tint = state;
}

/// The step that is going on or waited for; nothing where there is none.
std::optional<RowText> coming_row(const ProcedureState& state, int next, TableView view) {
    const Activity* activity = activity_of(state);
    const bool waits = std::holds_alternative<phase::Deciding>(state.phase);
    if ((activity == nullptr && !waits) || state.data.used().empty()) return std::nullopt;
    if (activity != nullptr && std::holds_alternative<activity::Solving>(*activity)) {
        return std::nullopt;
    }
    RowText row;
    row.cells.resize(layout_of(view).columns.size());
    row.cells[0] = {fmt::format("{}", next), Emphasis::kThird};
    CellText& decision = row.cells[places_of(view).decision];
    if (activity != nullptr) {
        decision.text = activity_word(*activity);
        decision.shape = State::kRunning;
    } else {
        decision = {fmt::format("waits for step {}", next - 1), Emphasis::kThird};
    }
    return row;
}

/// The last step is refused, and what becomes of it is not decided: it is part of no sum.
bool last_is_refused(const ProcedureState& state) {
    if (!std::holds_alternative<phase::Deciding>(state.phase)) return false;
    const auto steps = table_of(state);
    return !steps.empty() && steps.back().row.verdict == Verdict::kReject;
}

auto sum_of(auto&& table) {
    return std::ranges::find(table.rows, Table1RowKind::kSum, &Table1Row::kind);
}

RowText sum_row(const Table1& table, const Snapshot& s, TableView view) {
    const auto [columns, sources] = layout_of(view);
    const Table1Row& sums = *sum_of(table);
    RowText row;
    for (const Source& source : sources) row.cells.push_back(cell_of(table, sums, source));
    row.cells[0] = {"Sum", Emphasis::kStrong};
    const Places at = places_of(view);
    const auto* error = std::get_if<double>(&sums.cells[column_in(table, "error_deg")]);
    const auto* sigma = std::get_if<double>(&sums.cells[column_in(table, "sigma_deg")]);
    if (error != nullptr && sigma != nullptr && *sigma > 0.0 && at.sigmas < row.cells.size()) {
        row.cells[at.sigmas] = {shown_number(std::abs(*error) / *sigma, 1), Emphasis::kSecond};
    }
    const ProcedureState& state = *s.procedure;
    const DialText dial = dial_of(s);
    row.cells[at.decision] = {
        fmt::format("{} of {}, {}° to go",
                    table_of(state).size() - (last_is_refused(state) ? 1 : 0), steps_planned(state),
                    shown_number(dial.whole_deg - dial.turned_deg, 2)),
        Emphasis::kSecond};
    return row;
}

std::string closure_sentence(const Table1& table, const Snapshot& s) {
    if (s.solved && s.solved->report.closure_after) {
        const Closure& after = *s.solved->report.closure_after;
        return fmt::format("solved together {}°, {} mm",
                           shown_number(deg_from_rad(after.angle_rad), 2),
                           shown_number(kMmPerM * after.shift_m, 2));
    }
    double variance_deg2 = 0.0;
    std::size_t known = 0;
    for (const JudgedStep& step : table_of(*s.procedure)) {
        if (step.row.mode == TurnMode::kAxisLocked) return "not measured: locked to the axis";
        if (!step.row.sigma_rad) continue;
        variance_deg2 += std::pow(deg_from_rad(*step.row.sigma_rad), 2);
        ++known;
    }
    if (known == 0 || table.rows.empty()) return "known at 360°";
    const double whole = variance_deg2 / static_cast<double>(known) * steps_planned(*s.procedure);
    return fmt::format("expected ±{}° at 360°", shown_number(std::sqrt(whole), 2));
}

RowText closure_row(const Table1& table, const Snapshot& s, TableView view) {
    RowText row;
    row.cells.resize(layout_of(view).columns.size());
    row.cells[0] = {"Closure", Emphasis::kStrong};
    const Places at = places_of(view);
    if (s.solved && s.solved->report.closure_before) {
        const Closure& before = *s.solved->report.closure_before;
        row.cells[at.error] = {shown_number(deg_from_rad(before.angle_rad), 3, Sign::kAlways)};
        if (view == TableView::kRobotAgainstIcp) {
            row.cells[8] = {shown_number(kMmPerM * before.shift_m, 2)};
        }
    }
    row.cells[at.decision] = {closure_sentence(table, s), Emphasis::kSecond};
    return row;
}

std::string joint6(const std::optional<double>& rad) {
    return rad ? shown_number(deg_from_rad(*rad), 3) : std::string();
}

/// The step that led to a capture, as it was judged last; null: it was not.
const JudgedStep* judged_to(const ProcedureState& state, int index) {
    const JudgedStep* found = nullptr;
    for (const auto& [pair, step] : state.judged) {
        if (pair.second == index) found = &step;
    }
    return found;
}

RowText attempt_row(const ProcedureState& state, const CaptureRecord& capture) {
    RowText row;
    const bool used = capture.status == CaptureStatus::kUsed;
    const Emphasis plain = used ? Emphasis::kNormal : Emphasis::kThird;
    const auto put = [&](std::string text) { row.cells.push_back({std::move(text), plain}); };
    put(fmt::format("{}", capture.index));
    put(fmt::format("{}", capture.attempt));
    put(shown_number(deg_from_rad(capture.commanded_rad), 2));
    put(joint6(capture.before ? std::optional(capture.before->joints_rad[5]) : std::nullopt));
    put(joint6(capture.joint6_after_rad));
    put(shown_number(capture.t_s, 1));
    put(std::string(word(capture.mode)));
    put(std::string(word(capture.status)));
    const JudgedStep* step = judged_to(state, capture.index);
    const bool compared = step != nullptr && step->row.error_rad.has_value();
    put(compared ? shown_number(deg_from_rad(*step->row.error_rad), 3, Sign::kAlways) : "");
    row.cells.push_back({});
    if (step != nullptr) {
        const State verdict = state_of(step->row.verdict);
        row.cells.back() = {std::string(word(verdict)), plain, verdict};
    }
    put(capture.note);
    return row;
}

}  // namespace

Table1 full_table(const Snapshot& s) {
    TurnReport report;
    CaptureTable captures;
    if (s.procedure == nullptr) return table1_of(report, captures);
    report.limits = s.procedure->plan.limits;
    for (const JudgedStep& step : table_of(*s.procedure)) report.steps.push_back(step.row);
    if (s.solved) {
        report.closure_before = s.solved->report.closure_before;
        report.closure_after = s.solved->report.closure_after;
    }
    captures.columns = all_capture_columns();
    for (const CaptureRecord& record : s.procedure->data.captures) {
        captures.rows.push_back(row_of(record));
    }
    Table1 table = table1_of(report, captures);
    if (last_is_refused(*s.procedure)) {
        report.steps.pop_back();
        const Table1 without = table1_of(report, captures);
        *sum_of(table) = *sum_of(without);
    }
    return table;
}

TableText table_text(const Snapshot& s, TableView view) {
    const auto [columns, sources] = layout_of(view);
    TableText text{columns, {}, {}};
    if (s.procedure == nullptr) return text;
    const Table1 table = full_table(s);
    const auto steps = table_of(*s.procedure);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        RowText row;
        for (const Source& source : sources) {
            row.cells.push_back(cell_of(table, table.rows[i], source));
        }
        mark(row, steps[i].row, s.procedure->plan.limits, view);
        text.rows.push_back(std::move(row));
    }
    const int next = static_cast<int>(steps.size()) + 1;
    if (auto coming = coming_row(*s.procedure, next, view)) text.rows.push_back(*std::move(coming));
    text.last_rows = {sum_row(table, s, view), closure_row(table, s, view)};
    return text;
}

TableText attempts_text(const Snapshot& s) {
    TableText text{kAttemptColumns, {}, {}};
    if (s.procedure == nullptr) return text;
    for (const CaptureRecord& capture : s.procedure->data.captures) {
        text.rows.push_back(attempt_row(*s.procedure, capture));
    }
    return text;
}

std::string table_for_clipboard(const Snapshot& s) {
    const Table1 table = full_table(s);
    std::string text = "row";
    for (const Table1Column& column : table.columns) {
        text += '\t';
        text += column.name;
    }
    text += "\n";
    for (const Table1Row& row : table.rows) {
        text += word(row.kind);
        for (const Table1Cell& cell : row.cells) {
            text += '\t';
            if (const auto* number = std::get_if<double>(&cell)) text += text_from_number(*number);
            if (const auto* words = std::get_if<std::string>(&cell)) text += *words;
        }
        text += "\n";
    }
    return text;
}

}  // namespace gripscan::ui
