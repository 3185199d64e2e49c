#include "core/report/table1.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/base/number_text.h"
#include "core/report/file_units.h"
#include "core/session/csv_text.h"

namespace gripscan {
namespace {

Table1Cell cell_of(const std::optional<double>& value) {
    if (!value || !std::isfinite(*value)) return std::monostate{};
    return *value;
}

Table1Cell deg_cell(const std::optional<double>& rad) {
    if (!rad || !std::isfinite(*rad)) return std::monostate{};
    return file_deg(*rad);
}

Table1Cell mm_cell(const std::optional<double>& metres) {
    if (!metres || !std::isfinite(*metres)) return std::monostate{};
    return file_mm(*metres);
}

/// Of the numbers as the files hold them, so that it is the same when they are read back.
Table1Cell ratio_cell(const std::optional<double>& a, const std::optional<double>& b) {
    if (!a || !b || !(*b > 0.0)) return std::monostate{};
    return rounded_1e12(file_deg(*a) / file_deg(*b));
}

/// A row under construction: the step, its capture, and the turn up to it.
struct StepContext {
    const TurnStep& step;
    const CaptureRow* to = nullptr;  ///< null: not in the table
    std::optional<double> turned_deg;
};

using Make = Table1Cell (*)(const StepContext&);

std::optional<EulerAngles> euler(const TurnStep& step) {
    if (!step.T) return std::nullopt;
    return euler_from_rotation(step.T->linear());
}

template <double EulerAngles::*kAngle>
Table1Cell euler_cell(const StepContext& c) {
    const auto angles = euler(c.step);
    return angles ? deg_cell((*angles).*kAngle) : Table1Cell{};
}

template <int kAxis>
Table1Cell shift_cell(const StepContext& c) {
    if (!c.step.T) return std::monostate{};
    return c.step.T->translation()[kAxis];
}

template <std::optional<double> TurnStep::*kMember>
Table1Cell angle_cell(const StepContext& c) {
    return deg_cell(c.step.*kMember);
}

template <std::optional<double> TurnStep::*kMember>
Table1Cell length_cell(const StepContext& c) {
    return mm_cell(c.step.*kMember);
}

template <std::optional<double> TurnStep::*kMember>
Table1Cell plain_cell(const StepContext& c) {
    return cell_of(c.step.*kMember);
}

struct StepColumn {
    Table1Column column;
    Make make;
};

const std::array kColumns{
    StepColumn{{"step", "step", "", 0},
               [](const StepContext& c) -> Table1Cell { return 1.0 * c.step.index; }},
    StepColumn{{"from", "from", "", 0},
               [](const StepContext& c) -> Table1Cell { return 1.0 * c.step.from; }},
    StepColumn{{"to", "to", "", 0},
               [](const StepContext& c) -> Table1Cell { return 1.0 * c.step.to; }},
    StepColumn{{"attempts", "", "", 0},
               [](const StepContext& c) -> Table1Cell { return 1.0 * c.step.attempts; }},
    StepColumn{{"commanded_deg", "command", "deg", 2}, angle_cell<&TurnStep::commanded_rad>},
    StepColumn{{"robot_deg", "robot", "deg", 3}, angle_cell<&TurnStep::robot_rad>},
    StepColumn{{"icp_deg", "ICP", "deg", 3}, angle_cell<&TurnStep::icp_rad>},
    StepColumn{{"error_deg", "error", "deg", 3}, angle_cell<&TurnStep::error_rad>},
    StepColumn{{"sigma_deg", "sigma", "deg", 3}, angle_cell<&TurnStep::sigma_rad>},
    StepColumn{{"error_sigmas", "", "", 2},
               [](const StepContext& c) { return ratio_cell(c.step.error_rad, c.step.sigma_rad); }},
    StepColumn{{"roll_deg", "roll", "deg", 3}, euler_cell<&EulerAngles::roll_rad>},
    StepColumn{{"pitch_deg", "pitch", "deg", 3}, euler_cell<&EulerAngles::pitch_rad>},
    StepColumn{{"yaw_deg", "yaw", "deg", 3}, euler_cell<&EulerAngles::yaw_rad>},
    StepColumn{{"x_m", "X", "m", 4}, shift_cell<0>},
    StepColumn{{"y_m", "Y", "m", 4}, shift_cell<1>},
    StepColumn{{"z_m", "Z", "m", 4}, shift_cell<2>},
    StepColumn{{"tilt_deg", "tilt", "deg", 2}, angle_cell<&TurnStep::tilt_rad>},
    StepColumn{{"axis_offset_mm", "offset", "mm", 2}, length_cell<&TurnStep::axis_offset_m>},
    StepColumn{{"slip_mm", "slip", "mm", 2}, length_cell<&TurnStep::slip_m>},
    StepColumn{{"overlap", "overlap", "%", 0, 100.0}, plain_cell<&TurnStep::overlap>},
    StepColumn{{"rms_mm", "rms", "mm", 2}, length_cell<&TurnStep::rms_m>},
    StepColumn{{"median_mm", "", "", 2}, length_cell<&TurnStep::median_m>},
    StepColumn{{"p90_mm", "", "", 2}, length_cell<&TurnStep::p90_m>},
    StepColumn{{"observability", "obs.", "", 2}, plain_cell<&TurnStep::observability>},
    StepColumn{{"mode", "", "", 0},
               [](const StepContext& c) -> Table1Cell { return std::string(word(c.step.mode)); }},
    StepColumn{{"independent", "", "", 0},
               [](const StepContext& c) -> Table1Cell {
                   return std::string(c.step.independent ? "true" : "false");
               }},
    StepColumn{
        {"verdict", "verdict", "", 0},
        [](const StepContext& c) -> Table1Cell { return std::string(word(c.step.verdict)); }},
    StepColumn{{"cause", "cause", "", 0},
               [](const StepContext& c) -> Table1Cell { return std::string(word(c.step.cause)); }},
    StepColumn{{"sentence", "", "", 0},
               [](const StepContext& c) -> Table1Cell { return c.step.sentence; }},
    StepColumn{{"cumulative_deg", "", "", 2},
               [](const StepContext& c) { return cell_of(c.turned_deg); }},
    StepColumn{
        {"j6_deg", "", "", 3},
        [](const StepContext& c) { return cell_of(c.to ? c.to->joints_deg[5] : std::nullopt); }},
    StepColumn{
        {"j6_after_deg", "", "", 3},
        [](const StepContext& c) { return cell_of(c.to ? c.to->j6_after_deg : std::nullopt); }},
    StepColumn{{"t_s", "", "", 1},
               [](const StepContext& c) { return cell_of(c.to ? c.to->t_s : std::nullopt); }},
};

std::size_t column_index(std::string_view name) {
    const auto found = std::find_if(kColumns.begin(), kColumns.end(),
                                    [&](const StepColumn& c) { return c.column.name == name; });
    return static_cast<std::size_t>(found - kColumns.begin());
}

/// Sums, too, are of the numbers as the files hold them.
std::optional<double> sum_deg(const TurnReport& report, std::optional<double> TurnStep::*member) {
    double sum = 0.0;
    for (const auto& step : report.steps) {
        if (!(step.*member)) return std::nullopt;
        sum += file_deg(*(step.*member));
    }
    return rounded_1e12(sum);
}

Table1Row summed(const TurnReport& report) {
    Table1Row row{Table1RowKind::kSum, Verdict::kAccept, {}};
    row.cells.resize(kColumns.size());
    const auto put = [&](std::string_view name, std::optional<double> TurnStep::*member) {
        row.cells[column_index(name)] = cell_of(sum_deg(report, member));
    };
    put("commanded_deg", &TurnStep::commanded_rad);
    put("robot_deg", &TurnStep::robot_rad);
    put("icp_deg", &TurnStep::icp_rad);
    put("error_deg", &TurnStep::error_rad);
    std::optional<double> variance = 0.0;
    for (const auto& step : report.steps) {
        if (!step.sigma_rad) variance.reset();
        if (variance) *variance += std::pow(file_deg(*step.sigma_rad), 2);
    }
    if (variance) row.cells[column_index("sigma_deg")] = rounded_1e12(std::sqrt(*variance));
    return row;
}

Table1Row closure_row(Table1RowKind kind, const Closure& closure) {
    Table1Row row{kind, Verdict::kAccept, {}};
    row.cells.resize(kColumns.size());
    row.cells[column_index("error_deg")] = deg_cell(closure.angle_rad);
    row.cells[column_index("axis_offset_mm")] = mm_cell(closure.shift_m);
    return row;
}

}  // namespace

std::string_view word(Table1RowKind kind) {
    constexpr std::array<std::string_view, 4> kWords{"step", "sum", "closure_before",
                                                     "closure_after"};
    return kWords[static_cast<std::size_t>(kind)];
}

Table1 table1_of(const TurnReport& report, const CaptureTable& captures) {
    std::map<int, const CaptureRow*> row_of_index;
    for (const auto& row : captures.rows) row_of_index[row.index] = &row;
    Table1 table;
    for (const auto& column : kColumns) table.columns.push_back(column.column);
    std::optional<double> turned_deg = 0.0;
    for (const auto& step : report.steps) {
        if (!step.icp_rad) turned_deg.reset();
        if (turned_deg) turned_deg = rounded_1e12(*turned_deg + file_deg(*step.icp_rad));
        const auto to = row_of_index.find(step.to);
        const StepContext context{step, to == row_of_index.end() ? nullptr : to->second,
                                  turned_deg};
        Table1Row row{Table1RowKind::kStep, step.verdict, {}};
        for (const auto& column : kColumns) row.cells.push_back(column.make(context));
        table.rows.push_back(std::move(row));
    }
    table.rows.push_back(summed(report));
    if (report.closure_before) {
        table.rows.push_back(closure_row(Table1RowKind::kClosureBefore, *report.closure_before));
    }
    if (report.closure_after) {
        table.rows.push_back(closure_row(Table1RowKind::kClosureAfter, *report.closure_after));
    }
    return table;
}

std::string table1_csv(const Table1& table) {
    std::vector<std::string> cells{"row"};
    for (const auto& column : table.columns) cells.emplace_back(column.name);
    std::string text = csv_line(cells);
    for (const auto& row : table.rows) {
        cells.assign(1, std::string(word(row.kind)));
        for (const auto& cell : row.cells) {
            if (const auto* number = std::get_if<double>(&cell)) {
                cells.push_back(text_from_number(*number));
            } else if (const auto* words = std::get_if<std::string>(&cell)) {
                cells.push_back(*words);
            } else {
                cells.emplace_back();
            }
        }
        text += csv_line(cells);
    }
    return text;
}

std::string shown(const Table1Column& column, const Table1Cell& cell) {
    if (const auto* number = std::get_if<double>(&cell)) {
        const std::string text = fmt::format("{:.{}f}", *number * column.scale, column.decimals);
        // "-0.00" says nothing but raises questions.
        return text.find_first_not_of("-0.") == std::string::npos && text.starts_with('-')
                   ? text.substr(1)
                   : text;
    }
    if (const auto* words = std::get_if<std::string>(&cell)) return *words;
    return "";
}

TurnSummary summary_of(const TurnReport& report) {
    TurnSummary summary;
    summary.steps = report.steps.size();
    for (const auto& step : report.steps) {
        summary.checks += step.verdict == Verdict::kCheck;
        summary.rejected += step.verdict == Verdict::kReject;
        summary.locked += step.mode == TurnMode::kAxisLocked;
        if (!step.error_rad) continue;
        ++summary.compared;
        summary.mean_abs_error_rad += std::abs(*step.error_rad);
        summary.worst_abs_error_rad =
            std::max(summary.worst_abs_error_rad, std::abs(*step.error_rad));
    }
    summary.accepted = summary.steps - summary.checks - summary.rejected;
    if (summary.compared > 0) summary.mean_abs_error_rad /= static_cast<double>(summary.compared);
    return summary;
}

}  // namespace gripscan
