#include "core/report/table1_text.h"

#include <algorithm>
#include <array>

#include "core/base/units.h"

namespace gripscan {
namespace {

/// What fits beside each other on a wide terminal; the rest is in the CSV and on the page.
constexpr std::array<std::string_view, 15> kShown{
    "step",      "commanded_deg", "robot_deg", "icp_deg", "error_deg",
    "sigma_deg", "roll_deg",      "pitch_deg", "yaw_deg", "x_m",
    "y_m",       "z_m",           "overlap",   "rms_mm",  "verdict"};

using TextRow = std::array<std::string, kShown.size()>;

std::size_t index_of(const Table1& table, std::string_view name) {
    const auto found = std::find_if(table.columns.begin(), table.columns.end(),
                                    [&](const Table1Column& c) { return c.name == name; });
    return static_cast<std::size_t>(found - table.columns.begin());
}

TextRow text_row(const Table1& table, const Table1Row& row) {
    TextRow text;
    for (std::size_t i = 0; i < kShown.size(); ++i) {
        const std::size_t c = index_of(table, kShown[i]);
        text[i] = shown(table.columns[c], row.cells[c]);
        if (text[i].empty() && row.kind == Table1RowKind::kStep) text[i] = "-";
    }
    if (row.kind == Table1RowKind::kSum) text[0] = "sum";
    return text;
}

std::string rule(const std::array<std::size_t, kShown.size()>& widths) {
    std::size_t length = 0;
    for (const std::size_t width : widths) length += width + 2;
    return std::string(length - 2, '-') + "\n";
}

std::string aligned(const TextRow& row, const std::array<std::size_t, kShown.size()>& widths) {
    std::string text;
    for (std::size_t i = 0; i < row.size(); ++i) {
        if (i > 0) text += "  ";
        text += fmt::format("{:>{}}", row[i], widths[i]);
    }
    return text + "\n";
}

std::string_view why_no_closure(const TurnReport& report) {
    if (summary_of(report).locked > 0) return "some angles are the robot's own, repeated";
    return report.axis ? "the used captures do not go all the way round" : "no axis was found";
}

std::string closure_text(const TurnReport& report) {
    if (!report.closure_before || !report.closure_after) {
        return fmt::format("closure      not known: {}\n", why_no_closure(report));
    }
    const auto one = [](const Closure& c) {
        return fmt::format("{:.3f} deg, {:.3f} mm", deg_from_rad(c.angle_rad), c.shift_m * kMmPerM);
    };
    if (!closed_jointly(report)) {
        return fmt::format("closure      {} from step to step\n", one(*report.closure_before));
    }
    return fmt::format("closure      {} from step to step; {} after the joint solution\n",
                       one(*report.closure_before), one(*report.closure_after));
}

std::string axis_text(const TurnReport& report) {
    if (!report.axis) return "";
    const Eigen::Vector3d& d = report.axis->axis.direction;
    const Eigen::Vector3d& p = report.axis->axis.point_m;
    return fmt::format(
        "axis         direction ({:.5f}, {:.5f}, {:.5f}) sd {:.3f} deg, through ({:.2f}, {:.2f}, "
        "{:.2f}) mm sd {:.3f} mm\n",
        d.x(), d.y(), d.z(), deg_from_rad(report.axis->sd_rad), p.x() * kMmPerM, p.y() * kMmPerM,
        p.z() * kMmPerM, report.axis->sd_m * kMmPerM);
}

std::string bad_steps_text(const TurnReport& report) {
    std::string text;
    for (const auto& step : report.steps) {
        if (step.verdict == Verdict::kAccept) continue;
        text +=
            fmt::format("step {:>3}     {} ({}): captures {} -> {}: {}\n", step.index,
                        word(step.verdict), word(step.cause), step.from, step.to, step.sentence);
    }
    return text;
}

}  // namespace

std::string table1_text(const TurnReport& report, const Table1& table) {
    TextRow titles;
    TextRow units;
    for (std::size_t i = 0; i < kShown.size(); ++i) {
        const Table1Column& column = table.columns[index_of(table, kShown[i])];
        titles[i] = column.title;
        units[i] = column.unit;
    }
    std::vector<TextRow> rows;
    for (const auto& row : table.rows) {
        if (row.kind == Table1RowKind::kStep || row.kind == Table1RowKind::kSum) {
            rows.push_back(text_row(table, row));
        }
    }
    std::array<std::size_t, kShown.size()> widths{};
    for (std::size_t i = 0; i < kShown.size(); ++i) {
        widths[i] = std::max(titles[i].size(), units[i].size());
        for (const auto& row : rows) widths[i] = std::max(widths[i], row[i].size());
    }
    std::string text = aligned(titles, widths) + aligned(units, widths) + rule(widths);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (i + 1 == rows.size()) text += rule(widths);
        text += aligned(rows[i], widths);
    }
    text += "\n" + closure_text(report) + axis_text(report) + bad_steps_text(report);
    return text + fmt::format("verdict      {}\n", summary_sentence(report));
}

bool closed_jointly(const TurnReport& report) {
    if (!report.closure_before || !report.closure_after) return false;
    return report.closure_before->angle_rad != report.closure_after->angle_rad ||
           report.closure_before->shift_m != report.closure_after->shift_m;
}

std::string summary_sentence(const TurnReport& report) {
    const TurnSummary summary = summary_of(report);
    std::string text = fmt::format("{} of {} steps accepted", summary.accepted, summary.steps);
    if (summary.checks > 0) text += fmt::format(", {} to check", summary.checks);
    if (summary.rejected > 0) text += fmt::format(", {} rejected", summary.rejected);
    if (summary.compared > 0) {
        text += fmt::format("; mean |error| {:.3f} deg, worst {:.3f} deg",
                            deg_from_rad(summary.mean_abs_error_rad),
                            deg_from_rad(summary.worst_abs_error_rad));
    }
    if (summary.locked > 0) {
        text += fmt::format("; {} of {} angles are the robot's own, repeated, and no measurement",
                            summary.locked, summary.steps);
    }
    return text;
}

}  // namespace gripscan
