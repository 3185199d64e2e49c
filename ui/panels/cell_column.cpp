#include "ui/panels/cell_column.h"

#include <fmt/format.h>

#include <array>

#include "core/base/units.h"
#include "ui/panels/action_button.h"
#include "ui/panels/mode_of.h"
#include "ui/panels/panel_parts.h"
#include "ui/panels/plan_field.h"
#include "ui/panels/region_editor.h"
#include "ui/views/cell_view.h"
#include "ui/widgets/rich_text.h"
#include "ui/widgets/scroll_area.h"
#include "ui/widgets/state_shape.h"

namespace gripscan::ui {
namespace {

struct Column {
    const Ui& ui;
    const Snapshot& snapshot;
    Requests& out;
    int x;
    int width;
    int y;

    Rect row(float height_em) {
        const Rect at{x, y, width, ui.em(height_em)};
        y = at.bottom();
        return at;
    }
    void value(std::string_view label, const std::string& text, std::string_view unit = {}) {
        draw_value_row(ui, row(1.57F), label, text, unit);
    }
    void separate() {
        y += ui.em(0.71F);
        draw_separator(ui, x - ui.em(1.0F), y, width + 2 * ui.em(1.0F));
        y += ui.em(0.57F);
    }
};

void draw_mode(Column& c, const TurnPlan& plan) {
    const Ui& ui = c.ui;
    const Rect row = c.row(2.0F);
    const float y = middle_of(row);
    const RobotMode mode = mode_of(plan.mode);
    const int end = draw_mode_chip(ui, row.x, y, mode);
    draw_text(ui, static_cast<float>(end) + ui.scale.em(0.71F), y, FontRole::kTable,
              ui.theme.text_second, sentence(mode));
}

/// Six numbers in two columns.
void draw_six(Column& c, const std::array<std::string_view, 6>& names,
              const std::array<std::string, 6>& numbers,
              const std::array<std::string_view, 2>& units) {
    const Ui& ui = c.ui;
    const int gap = ui.em(1.71F);
    const int half = (c.width - gap) / 2;
    for (std::size_t i = 0; i < 3; ++i) {
        const Rect row = c.row(1.57F);
        draw_value_row(ui, {row.x, row.y, half, row.height}, names[i], numbers[i], units[0]);
        draw_value_row(ui, {row.x + half + gap, row.y, half, row.height}, names[i + 3],
                       numbers[i + 3], units[1]);
    }
}

void draw_robot(Column& c) {
    const Ui& ui = c.ui;
    const ProcedureState* state = c.snapshot.procedure;
    const LinkText link = link_text(state);
    const Rect head = c.row(1.86F);
    draw_section(ui, head.x, head.y, "Robot");
    const Colour& colour = link.up ? ui.theme.text_second : ui.theme.check;
    const float words = text_width(ui, FontRole::kTable, link.word);
    draw_text(ui, static_cast<float>(head.right()), middle_of(head), FontRole::kTable, colour,
              link.word, Align::kRight);
    draw_state(ui, static_cast<float>(head.right()) - words - ui.scale.em(0.86F), middle_of(head),
               link.up ? State::kAccept : State::kWaiting, 0.93F, ui.theme.panel);
    if (!link.why.empty()) {
        c.y += draw_rich_text(ui, c.x, c.y, c.width, ui.theme.check, link.why,
                              {FontRole::kSmall, FontRole::kNumberSmall, 1.45F});
    }
    if (state == nullptr) return;
    draw_mode(c, state->plan);
    c.value("Model", state->robot ? state->robot->model : "–");
    c.value("Protocol", state->robot ? state->robot->protocol : "–");
    if (c.snapshot.cell.controller) {
        c.value("Controller", controller_text(*c.snapshot.cell.controller));
    }
    std::array<std::string, 6> joints;
    std::array<std::string, 6> tool;
    joints.fill("–");
    tool.fill("–");
    if (state->reading) {
        const auto pose = tool_numbers(state->reading->T_world_tool);
        for (std::size_t i = 0; i < 6; ++i) {
            joints[i] = shown_number(deg_from_rad(state->reading->joints_rad[i]), 3);
            tool[i] = shown_number(pose[i], i < 3 ? 2 : 3);
        }
    }
    c.y += ui.em(0.43F);
    draw_six(c, {"J1", "J2", "J3", "J4", "J5", "J6"}, joints, {"°", "°"});
    c.y += ui.em(0.43F);
    draw_six(c, {"X", "Y", "Z", "W", "P", "R"}, tool, {"mm", "°"});
}

void draw_camera(Column& c) {
    draw_section(c.ui, c.x, c.y, "Camera");
    c.y += c.ui.em(1.86F);
    const CellFrame& cell = c.snapshot.cell;
    if (!cell.rig) {
        c.value("Rectified pair", "not known yet");
        return;
    }
    c.value("Baseline", shown_number(cell.rig->baseline_m * kMmPerM, 2), "mm");
    c.value("Focal length", shown_number(cell.rig->f_px, 1), "px");
    c.value("Image", fmt::format("{} × {}", cell.rig->image.width, cell.rig->image.height), "px");
    c.value("Aligned to the robot", cell.T_robot_camera ? "yes" : "no");
}

void draw_environment(Column& c) {
    const Ui& ui = c.ui;
    draw_section(ui, c.x, c.y, "Environment");
    c.y += ui.em(1.86F);
    if (const auto& known = c.snapshot.environment) {
        c.value("Learned from", fmt::format("{} views", known->captures));
        c.value("Known of the image", shown_number(100.0 * known->known, 1), "%");
    } else {
        c.y += draw_rich_text(ui, c.x, c.y, c.width, ui.theme.text_third,
                              "Not learned. What comes into the registration area is then told "
                              "from the views alone.",
                              {FontRole::kSmall, FontRole::kNumberSmall, 1.45F});
    }
    c.y += ui.em(0.43F);
    action_button(ui, c.row(2.14F), action("environment.learn"), c.snapshot, {}, c.out);
}

void draw_limits(Column& c) {
    const Ui& ui = c.ui;
    draw_section(ui, c.x, c.y, "Limits, step and speed");
    c.y += ui.em(1.86F);
    const std::string why = why_plan_is_fixed(c.snapshot);
    if (!why.empty()) {
        c.y += draw_rich_text(ui, c.x, c.y, c.width, ui.theme.text_third, why,
                              {FontRole::kSmall, FontRole::kNumberSmall, 1.45F});
        c.y += ui.em(0.29F);
    }
    const TurnPlan plan = c.snapshot.procedure != nullptr ? c.snapshot.procedure->plan : TurnPlan{};
    const std::string why_speed = why_speed_is_fixed(c.snapshot);
    for (std::size_t i = 0; i < kPlanFields; ++i) {
        draw_plan_field(ui, c.row(2.0F), plan, i, i == kSpeedField ? why_speed : why, c.out);
    }
}

}  // namespace

void draw_cell_column(const Ui& ui, const Rect& column, const Snapshot& snapshot, Requests& out) {
    fill(column, ui.theme.panel);
    const int side = ui.em(1.0F);
    ScrollArea scroll(ui, column, "cell.column");
    Column c{ui,
             snapshot,
             out,
             column.x + side,
             column.width - 2 * side,
             scroll.rect().y + ui.em(0.57F)};
    draw_robot(c);
    c.separate();
    draw_camera(c);
    c.separate();
    c.y += draw_region_editor(ui, c.x, c.y, c.width, snapshot, out);
    c.separate();
    draw_environment(c);
    c.separate();
    draw_limits(c);
    scroll.end(c.y + ui.em(0.86F));
}

}  // namespace gripscan::ui
