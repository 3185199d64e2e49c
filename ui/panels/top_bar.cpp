#include "ui/panels/top_bar.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <cmath>
#include <numbers>

#include "ui/panels/action_button.h"
#include "ui/widgets/choice.h"
#include "ui/widgets/draw.h"
#include "ui/widgets/interact.h"

namespace gripscan::ui {
namespace {

float middle_y(const Rect& rect) {
    return static_cast<float>(rect.y) + 0.5F * static_cast<float>(rect.height);
}

/// A ring that is three quarters closed, and the part in its middle.
void draw_logo(const Ui& ui, float x, float y) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float radius = ui.scale.factor() * 7.5F;
    const float stroke = ui.scale.factor() * 3.0F;
    constexpr float kPi = std::numbers::pi_v<float>;
    const auto arc = [&](float from, float to, const Colour& colour) {
        list.PathArcTo({x, y}, radius, from, to, 24);
        list.PathStroke(colour.packed(), 0, stroke);
    };
    arc(0.0F, 2.0F * kPi, ui.theme.line2);
    arc(-0.5F * kPi, kPi, ui.theme.ok);
    arc(kPi, 1.25F * kPi, ui.theme.accent);
    list.AddCircleFilled({x, y}, ui.scale.factor() * 2.2F, ui.theme.text.packed(), 12);
}

struct PageTab {
    Page page;
    std::string_view action;
    Icon icon;
};
constexpr std::array<PageTab, 4> kPages{{{Page::kProcedure, "page.procedure", Icon::kProcedure},
                                         {Page::kTemplate, "page.template", Icon::kCube},
                                         {Page::kRecognise, "page.recognise", Icon::kMagnify},
                                         {Page::kCell, "page.cell", Icon::kTarget}}};

/// Returns where they end.
int draw_pages(const Ui& ui, const Rect& rect, const Snapshot& snapshot, Requests& out) {
    std::array<Option, kPages.size()> options;
    std::array<std::string, kPages.size()> whys;
    std::size_t chosen = kPages.size();
    for (std::size_t i = 0; i < kPages.size(); ++i) {
        const Action& a = action(kPages[i].action);
        whys[i] = a.refusal(snapshot).value_or(std::string());
        options[i] = {a.name, a.label, kPages[i].icon, {}, whys[i]};
        if (snapshot.page == kPages[i].page) chosen = i;
    }
    if (const auto clicked = tabs(ui, rect, options, chosen)) {
        out.push_back(action(kPages[*clicked].action).request(snapshot));
    }
    const auto last = ui.log.find(kPages.back().action);
    return last ? last->rect.right() : rect.x;
}

/// Icons from the right; returns the x left of them.
int draw_tools(const Ui& ui, const Rect& rect, const Snapshot& snapshot, Requests& out) {
    const int side = ui.em(2.14F);
    const int y = rect.y + (rect.height - side) / 2;
    int x = rect.right() - ui.em(0.57F);
    const auto separator = [&] {
        x -= ui.em(0.57F);
        fill({x, y + ui.em(0.29F), static_cast<int>(ui.scale.line()), side - 2 * ui.em(0.29F)},
             ui.theme.line2);
        x -= ui.em(0.57F);
    };
    const auto icon = [&](std::string_view name) {
        x -= side;
        action_icon(ui, {x, y, side, side}, action(name), snapshot, out);
    };
    icon("window.keys");
    icon("window.settings");
    icon("window.theme");
    const std::string scale =
        fmt::format("{:.0f} %", 100.0 * static_cast<double>(ui.scale.factor()));
    const int scale_width =
        static_cast<int>(text_width(ui, FontRole::kNumberTable, scale)) + 2 * ui.em(0.43F);
    x -= scale_width;
    const Rect at{x, y, scale_width, side};
    const auto [event, attention] =
        interact(ui, at, "window.natural_size", scale, {},
                 "Scale of the window; a click brings back the monitor's own (Ctrl+0)");
    if (attention.hovered) fill(at, ui.theme.hover, ui.scale.em(0.29F));
    draw_text(ui, static_cast<float>(x + ui.em(0.43F)), middle_y(rect), FontRole::kNumberTable,
              ui.theme.text_second, scale);
    if (event.clicked) out.push_back(action("window.natural_size").request(snapshot));
    separator();
    icon("window.screenshot");
    separator();
    icon("step.redo");
    icon("step.undo");
    separator();
    return x;
}

void draw_session(const Ui& ui, const Rect& rect, int left, int right, const Snapshot& snapshot,
                  Requests& out) {
    if (!snapshot.session) return;
    const std::string& name = snapshot.session->name;
    const std::string what =
        snapshot.session->recorded ? "recording, only shown" : snapshot.session->cell_name;
    const float icon = ui.scale.em(1.5F);
    const float gap = ui.scale.em(0.57F);
    const float name_width = text_width(ui, FontRole::kTextStrong, name);
    const float room = static_cast<float>(right - left) - 2.0F * gap;
    float total = icon + name_width + gap + text_width(ui, FontRole::kTable, what);
    const bool with_what = total <= room;
    if (!with_what) total = icon + std::min(name_width, room - icon);
    float x = static_cast<float>(right) - gap - total;
    const Rect at{static_cast<int>(x), rect.y, static_cast<int>(total) + 1, rect.height};
    const auto [event, attention] =
        interact(ui, at, "page.start", name, {}, snapshot.session->folder.string());
    if (event.clicked) out.push_back(action("page.start").request(snapshot));
    draw_icon(ui, x + 0.4F * icon, middle_y(rect), Icon::kFolder, ui.theme.text_second,
              FontRole::kIconSmall);
    x = draw_text(ui, x + icon, middle_y(rect), FontRole::kTextStrong,
                  attention.hovered ? ui.theme.accent_text : ui.theme.text,
                  fitted(ui, FontRole::kTextStrong, name, room - icon));
    if (!with_what) return;
    draw_text(ui, x + gap, middle_y(rect), FontRole::kTable, ui.theme.text_second, what);
}

}  // namespace

void draw_top_bar(const Ui& ui, const Rect& rect, const Snapshot& snapshot, Requests& out) {
    fill(rect, ui.theme.panel);
    const int line = static_cast<int>(ui.scale.line());
    fill({rect.x, rect.bottom() - line, rect.width, line}, ui.theme.line);
    draw_logo(ui, static_cast<float>(rect.x + ui.em(1.64F)), middle_y(rect));
    const float name_end = draw_text(ui, static_cast<float>(rect.x + ui.em(2.86F)), middle_y(rect),
                                     FontRole::kVerdict, ui.theme.text, "gripscan");
    const Rect pages{static_cast<int>(name_end) + ui.em(0.86F), rect.y, rect.width,
                     rect.height - line};
    const int pages_end = draw_pages(ui, pages, snapshot, out);
    const Action& report = action("window.report");
    const int report_width =
        static_cast<int>(text_width(ui, FontRole::kPanelTitle, report.label)) + ui.em(3.43F);
    const Option tab{report.name, report.label, Icon::kChart};
    std::string why = report.refusal(snapshot).value_or(std::string());
    Option shown = tab;
    shown.why_disabled = why;
    if (tabs(ui, {pages_end, pages.y, report_width, pages.height}, {&shown, 1}, 1)) {
        out.push_back(report.request(snapshot));
    }
    const int tools = draw_tools(ui, rect, snapshot, out);
    draw_session(ui, rect, pages_end + report_width, tools, snapshot, out);
}

}  // namespace gripscan::ui
