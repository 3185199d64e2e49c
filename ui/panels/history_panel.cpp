#include "ui/panels/history_panel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/units.h"
#include "ui/views/step_text.h"
#include "ui/widgets/draw.h"
#include "ui/widgets/error_plot.h"

namespace gripscan::ui {
namespace {

constexpr float kHeader = 2.14F;
constexpr float kLeastPlot = 7.29F;

std::vector<PlotPoint> points_of(const Snapshot& snapshot) {
    std::vector<PlotPoint> points;
    for (const JudgedStep& step : table_of(*snapshot.procedure)) {
        const auto deg = [](const std::optional<double>& rad, double otherwise) {
            return rad ? deg_from_rad(*rad) : otherwise;
        };
        points.push_back({deg(step.row.error_rad, std::numeric_limits<double>::quiet_NaN()),
                          deg(step.row.sigma_rad, 0.0), state_of(step.row.verdict)});
    }
    return points;
}

void draw_header(const Ui& ui, const Rect& rect) {
    const float y = static_cast<float>(rect.y) + 0.5F * static_cast<float>(rect.height);
    draw_text(ui, static_cast<float>(rect.x) + ui.scale.em(0.86F), y, FontRole::kPanelTitle,
              ui.theme.text, "Error per step, deg");
    float x = static_cast<float>(rect.right()) - ui.scale.em(0.86F);
    x = x - text_width(ui, FontRole::kCaption, "limit");
    draw_text(ui, x, y, FontRole::kCaption, ui.theme.text_second, "limit");
    x -= ui.scale.em(0.36F);
    dashed_line(ui, {x - ui.scale.em(1.14F), y}, {x, y}, ui.theme.check, 4, 3);
    x -= ui.scale.em(1.14F) + ui.scale.em(0.86F);
    x -= text_width(ui, FontRole::kCaption, "± 1 σ");
    draw_text(ui, x, y, FontRole::kCaption, ui.theme.text_second, "± 1 σ");
    const int box = ui.em(1.14F);
    fill({static_cast<int>(x) - box - ui.em(0.36F), static_cast<int>(y) - ui.px(4), box, ui.px(8)},
         ui.theme.accent.with_alpha(0.4));
}

void draw_plot(const Ui& ui, const Rect& rect, const Snapshot& snapshot, Requests& out) {
    if (snapshot.procedure == nullptr) return;
    const ProcedureState& state = *snapshot.procedure;
    const auto points = points_of(snapshot);
    const double limit = deg_from_rad(state.plan.limits.angle_rad);
    const bool follows = snapshot.follows_last || points.empty();
    ErrorPlot plot{points, static_cast<std::size_t>(std::max(1, steps_planned(state))), limit,
                   limit < 0.095 ? 2 : 1, follows ? 0 : snapshot.selected_row + 1};
    const std::size_t clicked = error_plot(ui, rect, "history.plot", plot);
    if (clicked < points.size()) out.push_back(request::SelectStep{clicked});
}

}  // namespace

void draw_history_panel(const Ui& ui, const Rect& rect, const Snapshot& snapshot,
                        const Detail& detail, LogListState& log, Requests& out) {
    fill(rect, ui.theme.panel);
    const int header = ui.em(kHeader);
    const bool with_log = !detail.log_is_a_tab && rect.height > header + ui.em(kLeastPlot + 4.0F);
    const int plot_height =
        with_log ? std::max(ui.em(kLeastPlot), (rect.height - header) / 2 - ui.em(0.57F))
                 : rect.height - header;
    draw_header(ui, {rect.x, rect.y, rect.width, header});
    draw_plot(ui, {rect.x, rect.y + header, rect.width, plot_height}, snapshot, out);
    if (!with_log) return;
    const int top = rect.y + header + plot_height;
    const int line = static_cast<int>(ui.scale.line());
    fill({rect.x, top, rect.width, line}, ui.theme.line);
    draw_log_list(ui, {rect.x, top + line, rect.width, rect.bottom() - top - line}, snapshot, log,
                  out);
}

}  // namespace gripscan::ui
