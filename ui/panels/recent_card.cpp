#include "ui/panels/recent_card.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "ui/panels/panel_parts.h"
#include "ui/views/start_view.h"
#include "ui/widgets/interact.h"
#include "ui/widgets/popup_menu.h"
#include "ui/widgets/rich_text.h"
#include "ui/widgets/scroll_area.h"
#include "ui/widgets/state_shape.h"
#include "ui/widgets/text_input.h"

namespace gripscan::ui {
namespace {

constexpr float kRow = 4.71F;
constexpr std::string_view kMenu = "recent.menu";

/// Right or left ends of the columns in a list so wide; 0: no room for it.
struct Columns {
    float name = 0;
    float name_end = 0;
    float kind = 0;
    float cell = 0;
    float steps = 0;
    float closure = 0;
    float used = 0;
};

Columns columns_of(const Ui& ui, const Rect& list) {
    const auto em = [&](float length) { return ui.scale.em(length); };
    const float side = em(1.29F);
    Columns at;
    at.name = static_cast<float>(list.x) + side + em(2.0F);
    at.used = static_cast<float>(list.right()) - side;
    const bool wide = list.width >= ui.em(46.0F);
    const bool middling = list.width >= ui.em(34.0F);
    at.closure = at.used - em(8.0F);
    at.steps = middling ? at.closure - em(8.7F) : at.closure;
    if (!middling) at.closure = 0;
    at.cell = at.steps - em(9.7F);
    if (wide) at.kind = at.cell - em(7.4F);
    at.name_end = (wide ? at.kind : at.cell) - em(1.0F);
    return at;
}

State state_of(RecentSession::End end) {
    using End = RecentSession::End;
    switch (end) {
        case End::kComplete:
            return State::kAccept;
        case End::kCheck:
            return State::kCheck;
        case End::kRejected:
            return State::kReject;
        case End::kInterrupted:
            return State::kRunning;
        case End::kMissing:
            break;
    }
    return State::kWaiting;
}

const Colour& sentence_colour(const Theme& theme, RecentSession::End end) {
    using End = RecentSession::End;
    return end == End::kCheck      ? theme.check
           : end == End::kRejected ? theme.reject
                                   : theme.text_third;
}

/// The ring of an interrupted session stands still: nothing runs.
void draw_shape(const Ui& ui, float x, float y, State state, const Colour& mark) {
    Ui still = ui;
    still.time_s = 0.0;
    draw_state(still, x, y, state, 1.14F, mark);
}

void draw_header(const Ui& ui, const Rect& row, const Columns& at) {
    const float y = middle_of(row);
    const Colour& colour = ui.theme.text_second;
    const auto words = [&](float x, std::string_view text, Align align) {
        if (x > 0) draw_text(ui, x, y, FontRole::kCaption, colour, text, align);
    };
    words(static_cast<float>(row.x) + ui.scale.em(1.29F), "session", Align::kLeft);
    words(at.kind, "kind", Align::kLeft);
    words(at.cell, "cell", Align::kLeft);
    words(at.steps, "steps", Align::kRight);
    words(at.closure, "closure", Align::kRight);
    words(at.used, "last used", Align::kRight);
    draw_separator(ui, row.x, row.bottom() - static_cast<int>(ui.scale.line()), row.width);
}

void draw_closure(const Ui& ui, float right, float y, const RecentSession& session) {
    const ClosureText text = closure_text(session);
    draw_text(ui, right, y, FontRole::kNumberTable, ui.theme.text_third, text.shift, Align::kRight);
    const float width =
        text.shift.empty() ? 0.0F
                           : text_width(ui, FontRole::kNumberTable, text.shift) + ui.scale.em(0.5F);
    draw_text(ui, right - width, y, FontRole::kNumberTable,
              text.shift.empty() ? ui.theme.text_third : ui.theme.text, text.angle, Align::kRight);
}

void draw_line(const Ui& ui, const Rect& row, const Columns& at, const RecentSession& session,
               bool hovered) {
    const Theme& t = ui.theme;
    if (hovered) fill(row, t.raised);
    draw_separator(ui, row.x, row.bottom() - static_cast<int>(ui.scale.line()), row.width);
    const float y = middle_of(row);
    const float apart = ui.scale.em(0.61F);
    const float room = at.name_end - at.name;
    draw_shape(ui, static_cast<float>(row.x) + ui.scale.em(1.93F), y, state_of(session.end),
               hovered ? t.raised : t.panel);
    const bool gone = session.end == RecentSession::End::kMissing;
    draw_text(ui, at.name, y - apart, FontRole::kTextStrong, gone ? t.text_third : t.text,
              fitted(ui, FontRole::kTextStrong, session.name, room));
    draw_text(ui, at.name, y + apart, FontRole::kSmall, sentence_colour(t, session.end),
              fitted(ui, FontRole::kSmall, session.sentence, room));
    if (at.kind > 0) {
        draw_text(ui, at.kind, y, FontRole::kTable, t.text_second, session.kind);
    }
    const bool sim = session.cell == "SIM";
    draw_text(ui, at.cell, y, sim ? FontRole::kTableStrong : FontRole::kTable,
              sim ? t.sim : t.text_second,
              fitted(ui, FontRole::kTable, session.cell, ui.scale.em(5.4F)));
    draw_text(ui, at.steps, y, FontRole::kNumberTable, t.text, steps_text(session), Align::kRight);
    if (at.closure > 0) draw_closure(ui, at.closure, y, session);
    draw_text(ui, at.used, y, FontRole::kNumberTable, t.text_second,
              day_and_time(session.last_used), Align::kRight);
}

void draw_menu(const Ui& ui, const Snapshot& snapshot, StartPageState& local, Requests& out) {
    if (!local.menu) return;
    const auto it = std::find_if(snapshot.recent.begin(), snapshot.recent.end(),
                                 [&](const auto& s) { return s.folder == *local.menu; });
    if (it == snapshot.recent.end()) {
        local.menu.reset();
        return;
    }
    using End = RecentSession::End;
    const std::string_view gone = it->end == End::kMissing ? "The folder is gone." : "";
    const std::string_view done =
        it->end == End::kInterrupted ? "" : "It has come to its end: nothing is left to do in it.";
    const std::array<MenuItem, 3> items{
        {{"recent.look", "Look only", Icon::kFolder, gone},
         {"recent.resume", "Resume", Icon::kPlay, gone.empty() ? done : gone},
         {"recent.forget", "Forget (the folder stays)", Icon::kClose}}};
    bool open = false;
    const auto chosen = popup_menu(ui, kMenu, items, &open);
    if (chosen == 0U) out.push_back(request::Open{it->folder});
    if (chosen == 1U) out.push_back(request::Resume{it->folder});
    if (chosen == 2U) out.push_back(request::Forget{it->folder});
    if (!open) local.menu.reset();
}

void draw_empty(const Ui& ui, const Rect& area, bool searching) {
    const Theme& t = ui.theme;
    const float x = static_cast<float>(area.x) + 0.5F * static_cast<float>(area.width);
    const float y = middle_of(area);
    draw_icon(ui, x, y - ui.scale.em(1.7F), searching ? Icon::kMagnify : Icon::kHistory,
              t.text_third);
    draw_text(ui, x, y, FontRole::kTextStrong, t.text_second,
              searching ? "No session matches" : "No sessions yet", Align::kCentre);
    draw_text(ui, x, y + ui.scale.em(1.4F), FontRole::kSmall, t.text_third,
              searching ? "Names, kinds, cells and states are searched."
                        : "What you record or open is listed here.",
              Align::kCentre);
}

void draw_rows(const Ui& ui, const Rect& area, const Columns& at, const Snapshot& snapshot,
               StartPageState& local, Requests& out) {
    const auto lines = found(snapshot.recent, local.search);
    if (lines.empty()) {
        draw_empty(ui, area, !snapshot.recent.empty());
        return;
    }
    const int height = ui.row(kRow);
    ScrollArea scroll(ui, area, "recent.list");
    int y = scroll.rect().y;
    bool wants_menu = false;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const RecentSession& session = *lines[i];
        const Rect row{area.x, y, area.width, height};
        y += height;
        if (row.bottom() < area.y || row.y > area.bottom()) continue;
        const bool gone = session.end == RecentSession::End::kMissing;
        const auto [event, attention] =
            interact(ui, row, fmt::format("recent.row{}", i), session.name, {},
                     gone ? session.sentence : std::string());
        if (event.clicked) {
            for (Request& r : requests_of_click(session)) out.push_back(std::move(r));
        }
        if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
            local.menu = session.folder;
            wants_menu = true;
        }
        const bool marked = attention.hovered || local.menu == session.folder;
        draw_line(ui, row, at, session, marked && !gone);
        if (attention.focused) draw_focus_ring(ui, row.shrunk(ui.px(4)), 0.0F);
    }
    scroll.end(y);
    if (wants_menu) open_menu(kMenu);
}

void draw_drop_target(const Ui& ui, const Rect& rect) {
    const Theme& t = ui.theme;
    dashed_outline(ui, rect, t.line2, 4.0F, 3.0F);
    const float width = text_width(ui, FontRole::kTextStrong,
                                   "Drop a session folder or a PCD, PLY or XYZ file here");
    const float y = middle_of(rect);
    const float x = static_cast<float>(rect.x) + 0.5F * (static_cast<float>(rect.width) - width) +
                    ui.scale.em(1.1F);
    const float left = std::max(x, static_cast<float>(rect.x) + ui.scale.em(3.0F));
    const float room = static_cast<float>(rect.right()) - left - ui.scale.em(0.57F);
    draw_icon(ui, left - ui.scale.em(1.6F), y, Icon::kDownload, t.text_third);
    draw_text(ui, left, y - ui.scale.em(0.6F), FontRole::kTextStrong, t.text,
              fitted(ui, FontRole::kTextStrong,
                     "Drop a session folder or a PCD, PLY or XYZ file here", room));
    draw_text(ui, left, y + ui.scale.em(0.6F), FontRole::kSmall, t.text_third,
              "opened for reading, never changed");
}

}  // namespace

void draw_recent_card(const Ui& ui, const Rect& card, const Snapshot& snapshot,
                      StartPageState& local, Requests& out) {
    draw_card(ui, card, ui.theme.panel);
    const int side = ui.em(1.29F);
    const Rect top{card.x, card.y, card.width, ui.em(3.71F)};
    draw_text(ui, static_cast<float>(card.x + side), middle_of(top), FontRole::kVerdict,
              ui.theme.text, "Recent");
    if (!snapshot.recent.empty()) {
        const int width = std::min(ui.em(15.7F), card.width / 2);
        const int height = ui.em(2.14F);
        (void)text_input(
            ui, {card.right() - side - width, top.y + (top.height - height) / 2, width, height},
            {.id = "recent.search",
             .label = "Search",
             .placeholder = "name, kind or cell",
             .icon = Icon::kMagnify},
            local.search);
    }
    draw_separator(ui, card.x, top.bottom(), card.width);
    const Rect drop{card.x + side, card.bottom() - side - ui.em(5.2F), card.width - 2 * side,
                    ui.em(5.2F)};
    const int line = static_cast<int>(ui.scale.line());
    Rect list{card.x + line, top.bottom() + line, card.width - 2 * line, 0};
    const Columns at = columns_of(ui, list);
    if (!snapshot.recent.empty()) {
        const Rect header{list.x, list.y, list.width, ui.em(1.86F)};
        draw_header(ui, header, at);
        list.y = header.bottom();
    }
    list.height = std::max(0, drop.y - ui.em(0.86F) - list.y);
    draw_rows(ui, list, at, snapshot, local, out);
    draw_drop_target(ui, drop);
    draw_menu(ui, snapshot, local, out);
}

}  // namespace gripscan::ui
