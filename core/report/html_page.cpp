#include "core/report/html_page.h"

#include <algorithm>

#include "core/base/units.h"
#include "core/report/error_plot.h"
#include "core/report/html_style.h"
#include "core/report/table1_text.h"

namespace gripscan {
namespace {

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

std::string_view overall(const TurnSummary& summary) {
    if (summary.rejected > 0) return "reject";
    return summary.checks > 0 ? "check" : "accept";
}

std::string figure(std::string_view name, const std::string& value, std::string_view unit = "") {
    return fmt::format("<div><dt>{}</dt><dd>{} <small>{}</small></dd></div>\n", name, value, unit);
}

std::string deg3(double rad) {
    return fmt::format("{:.3f}", deg_from_rad(rad));
}

std::string closure_figure(std::string_view name, const std::optional<Closure>& closure) {
    if (!closure) return "";
    return figure(name, deg3(closure->angle_rad),
                  fmt::format("deg, {:.3f} mm", closure->shift_m * kMmPerM));
}

std::string turned(const TurnReport& report) {
    double sum = 0.0;
    for (const auto& step : report.steps) {
        if (!step.icp_rad || step.mode == TurnMode::kAxisLocked) return "";
        sum += *step.icp_rad;
    }
    return deg3(sum);
}

std::string figures(const HtmlPageInput& input) {
    const TurnReport& report = input.report;
    const TurnSummary summary = summary_of(report);
    std::string text = "<dl class=\"figures\">\n";
    text += figure("Steps accepted", fmt::format("{}", summary.accepted),
                   fmt::format("of {}", summary.steps));
    if (summary.compared > 0) {
        text += figure("Mean |error|", deg3(summary.mean_abs_error_rad), "deg");
        text += figure("Worst |error|", deg3(summary.worst_abs_error_rad), "deg");
    }
    if (const std::string sum = turned(report); !sum.empty()) {
        text += figure("Sum of the ICP angles", sum, "deg");
    }
    text += closure_figure("Closure, step by step", report.closure_before);
    if (closed_jointly(report)) {
        text += closure_figure("Closure, joint solution", report.closure_after);
    }
    if (report.axis) {
        text += figure("Axis known to", deg3(report.axis->sd_rad),
                       fmt::format("deg, {:.3f} mm", report.axis->sd_m * kMmPerM));
    }
    text += figure("Template", fmt::format("{}", input.template_points), "points");
    return text + "</dl>\n";
}

std::string plot(const TurnReport& report) {
    const std::string svg = error_plot_svg(report);
    if (svg.empty()) {
        return "<p class=\"note\">No angle of the robot or of the command is known, so there is "
               "nothing to compare the scans with.</p>\n";
    }
    const bool predicted = std::any_of(report.steps.begin(), report.steps.end(),
                                       [](const TurnStep& s) { return s.sigma_rad.has_value(); });
    std::string text = "<div class=\"scroll\">" + svg + "</div>\n";
    text += "<p class=\"legend\">Disc: accepted, triangle: to check, cross: rejected. ";
    if (predicted) {
        text += fmt::format(
            "Dark band: predicted standard deviation of the step, light band: {:g} times that. ",
            report.limits.sigmas);
    }
    return text +
           fmt::format("Dashed: limit {:g} deg.</p>\n", deg_from_rad(report.limits.angle_rad));
}

std::string table_html(const Table1& table) {
    std::string text = "<div class=\"scroll\"><table>\n<thead><tr>";
    for (const auto& column : table.columns) {
        if (!column.title.empty())
            text += fmt::format("<th>{}<br><small>{}</small></th>", escaped(column.title),
                                escaped(column.unit));
    }
    text += "</tr></thead>\n<tbody>\n";
    for (const auto& row : table.rows) {
        if (row.kind != Table1RowKind::kStep && row.kind != Table1RowKind::kSum) continue;
        const bool sum = row.kind == Table1RowKind::kSum;
        text += fmt::format("<tr class=\"{}\">", sum ? "sum" : word(row.verdict));
        for (std::size_t i = 0; i < table.columns.size(); ++i) {
            if (table.columns[i].title.empty()) continue;
            const bool label = sum && table.columns[i].name == "step";
            text += fmt::format("<td>{}</td>",
                                label ? "sum" : escaped(shown(table.columns[i], row.cells[i])));
        }
        text += "</tr>\n";
    }
    return text + "</tbody></table></div>\n";
}

std::string causes(const TurnReport& report) {
    std::string text;
    for (const auto& step : report.steps) {
        if (step.verdict == Verdict::kAccept) continue;
        text += fmt::format("<li><b class=\"{}\">{}</b> step {}, captures {} to {} ({}): {}</li>\n",
                            word(step.verdict), word(step.verdict), step.index, step.from, step.to,
                            word(step.cause), escaped(step.sentence));
    }
    if (text.empty()) return "";
    return "<h2>Steps that were not accepted</h2>\n<ul class=\"causes\">\n" + text + "</ul>\n";
}

std::string_view sign_note(SignSource source) {
    switch (source) {
        case SignSource::kAxisHint:
            return "the axis hint of the session";
        case SignSource::kJoint:
            return "the joint angles";
        case SignSource::kAssumed:
            break;
    }
    return "an assumption: nothing tells it";
}

std::string notes(const TurnReport& report) {
    const TurnLimits& limits = report.limits;
    std::string text = fmt::format(
        "<h2>Limits and conventions</h2>\n<p class=\"note\">A step is accepted if |error| is at "
        "most {:g} deg or {:g} sigma, the overlap at least {:g} %, the slip along the axis at most "
        "{:g} mm, the tilt of its axis at most {:g} deg, and the turn is observable and found "
        "independently of the robot. Up to twice a limit it is to be checked, beyond that it is "
        "rejected and its view is not merged.</p>\n",
        deg_from_rad(limits.angle_rad), limits.sigmas, limits.overlap * 100.0,
        limits.slip_m * kMmPerM, deg_from_rad(limits.tilt_rad));
    text += fmt::format(
        "<p class=\"note\">Error: ICP angle minus the robot's, or the commanded one where the "
        "robot told none. Roll, pitch, yaw (R = Rz Ry Rx) and X, Y, Z are of the transform between "
        "consecutive captures in the frame of the rectified left camera. The sign of the turn "
        "comes from {}.</p>\n",
        sign_note(report.sign_source));
    if (report.angle_scale) {
        text +=
            fmt::format("<p class=\"note\">Estimated scale of the robot's angles: {:.5f}.</p>\n",
                        *report.angle_scale);
    }
    return text;
}

}  // namespace

std::string html_page(const HtmlPageInput& input) {
    const std::string name = escaped(input.session_name);
    std::string text = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n"
        "<title>Turn report: {}</title>\n<style>{}</style>\n</head>\n<body>\n<main>\n",
        name, kHtmlStyle);
    text += fmt::format(
        "<header><div><p class=\"kicker\">gripscan turn report</p><h1>{}</h1></div>"
        "<div class=\"verdict {}\">{}</div></header>\n",
        name, overall(summary_of(input.report)), escaped(summary_sentence(input.report)));
    text += figures(input);
    text += "<h2>Error of every step</h2>\n" + plot(input.report) + causes(input.report);
    text += "<section><h2>Table 1</h2>\n" + table_html(input.table) + "</section>\n" +
            notes(input.report);
    return text + fmt::format("<footer>gripscan {}</footer>\n</main>\n</body>\n</html>\n",
                              escaped(input.version));
}

}  // namespace gripscan
