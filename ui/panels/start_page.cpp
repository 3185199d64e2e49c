#include "ui/panels/start_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "ui/panels/panel_parts.h"
#include "ui/panels/recent_card.h"
#include "ui/views/start_view.h"
#include "ui/widgets/button.h"
#include "ui/widgets/closure_dial.h"
#include "ui/widgets/interact.h"
#include "ui/widgets/notices.h"
#include "ui/widgets/rich_text.h"
#include "ui/widgets/scroll_area.h"
#include "ui/widgets/state_shape.h"

namespace gripscan::ui {
namespace {

constexpr float kCard = 5.14F;  // an action
constexpr float kGap = 0.86F;
constexpr float kHeading = 7.2F;

struct Action {
    std::string_view id;
    std::string_view title;
    std::string_view text;
    Icon icon;
    char key;
};

constexpr std::array<Action, 4> kActions{
    {{"start.simulated", "Simulated cell", "Robot, camera and parts, no hardware", Icon::kFlask,
      'S'},
     {"start.open", "Open recording", "A session folder or a point cloud", Icon::kFolder, 'O'},
     {"start.new_cell", "New cell", "Connect a robot and a stereo camera", Icon::kPlus, 'N'},
     {"start.tour", "Guided tour", "A whole turn in the simulated cell, explained on the way",
      Icon::kSchool, 'G'}}};

Request request_of(std::size_t action) {
    switch (action) {
        case 0:
            return request::Begin{simulated_wish()};
        case 1:
            return request::Show{Dialog::kOpen};
        case 2:
            return request::Show{Dialog::kNewSession, true};
        default:
            return request::Tour{};
    }
}

/// A card that is a button; the first one may be what Space presses.
bool draw_action(const Ui& ui, const Rect& card, const Action& action, bool next, Requests& out) {
    const Theme& t = ui.theme;
    const bool has_options = action.key == 'S';
    const int options = has_options ? ui.em(6.0F) : 0;
    const int key = next ? ui.em(4.6F) : ui.em(3.0F);
    Rect pressed = card;
    pressed.width -= options > 0 ? options + key : 0;
    const auto [event, attention] = interact(ui, pressed, action.id, action.title, {}, {});
    const bool lit = attention.hovered || attention.held;
    draw_card(ui, card, lit ? t.raised : t.panel);
    if (next) outline(card, t.accent, 2.0F * ui.scale.line(), ui.scale.em(0.43F));
    const float y = middle_of(card);
    const auto left = static_cast<float>(card.x);
    draw_icon(ui, left + ui.scale.em(1.9F), y, action.icon, next ? t.accent_text : t.text_second);
    const float x = left + ui.scale.em(3.7F);
    const float room = static_cast<float>(card.right() - key - options) - x;
    draw_text(ui, x, y - ui.scale.em(0.64F), FontRole::kNextAction, t.text, action.title);
    draw_text(ui, x, y + ui.scale.em(0.64F), FontRole::kSmall, t.text_second,
              fitted(ui, FontRole::kSmall, action.text, room));
    const std::string cap = next ? std::string("Space") : std::string(1, action.key);
    draw_key_cap(ui, static_cast<float>(card.right()) - ui.scale.em(1.29F), y, cap, t.text_third);
    if (attention.focused) draw_focus_ring(ui, card, ui.scale.em(0.43F));
    if (has_options && link(ui,
                            {card.right() - key - options, card.y + ui.em(1.2F),
                             options - ui.em(0.57F), card.height - 2 * ui.em(1.2F)},
                            "start.options", "Options…")) {
        out.push_back(request::Show{Dialog::kNewSession});
    }
    return event.clicked;
}

void draw_picture(const Ui& ui, const Rect& area, const RecentSession& session) {
    fill(area, ui.theme.view_bottom, ui.scale.em(0.36F));
    fill({area.x, area.y + area.height / 2, area.width, area.height - area.height / 2},
         ui.theme.view_bottom);
    const int side = area.height - 2 * ui.em(1.0F);
    const double part = session.steps_total > 0
                            ? static_cast<double>(session.steps_done) / session.steps_total
                            : 0.0;
    DialState dial;
    dial.turned_deg = 360.0 * part;
    dial.robot_deg = dial.turned_deg;
    if (session.steps_total > 0) dial.next_deg = 360.0 / session.steps_total;
    draw_closure_dial(ui, {area.x + (area.width - side) / 2, area.y + ui.em(1.0F), side, side},
                      dial);
    const float x = static_cast<float>(area.x) + ui.scale.em(1.8F);
    const float y = static_cast<float>(area.y) + ui.scale.em(1.5F);
    Ui still = ui;
    still.time_s = 0.0;
    draw_state(still, x, y, State::kRunning, 0.93F, ui.theme.view_bottom);
    draw_text(ui, x + ui.scale.em(0.93F), y, FontRole::kSmall, ui.theme.text,
              fmt::format("step {} of {}", session.steps_done, session.steps_total));
}

/// What can be gone on with; returns the height.
int draw_resume(const Ui& ui, const Rect& at, const RecentSession& session, int picture_height,
                bool space, Requests& out) {
    const Theme& t = ui.theme;
    const int side = ui.em(1.14F);
    const int text_width_px = at.width - 2 * side;
    const TextStyle small{FontRole::kTable, FontRole::kNumberTable, 1.55F};
    const int sentence = rich_text_height(ui, text_width_px, session.sentence, small);
    const int button_height = ui.row(3.43F);
    const Rect card{at.x, at.y, at.width,
                    picture_height + ui.em(2.9F) + sentence + ui.em(0.86F) + button_height + side};
    draw_card(ui, card, t.panel);
    const int line = static_cast<int>(ui.scale.line());
    draw_picture(ui, {card.x + line, card.y + line, card.width - 2 * line, picture_height - line},
                 session);
    draw_separator(ui, card.x, card.y + picture_height, card.width);
    const float y = static_cast<float>(card.y + picture_height) + ui.scale.em(1.55F);
    const std::string when = "stopped " + day_and_time(session.last_used);
    const float when_left = static_cast<float>(card.right() - side) -
                            text_width(ui, FontRole::kSmall, when) - ui.scale.em(0.86F);
    float x = static_cast<float>(card.x + side);
    x = draw_text(ui, x, y, FontRole::kTitle, t.text,
                  fitted(ui, FontRole::kTitle, session.name, 0.7F * (when_left - x)));
    x += ui.scale.em(0.71F);
    const std::string what = session.kind + (session.cell.empty() ? "" : ", " + session.cell);
    draw_text(ui, x, y, FontRole::kTable, t.text_second,
              fitted(ui, FontRole::kTable, what, when_left - x));
    draw_text(ui, static_cast<float>(card.right() - side), y, FontRole::kSmall, t.text_third, when,
              Align::kRight);
    const int below = card.y + picture_height + ui.em(2.9F);
    draw_rich_text(ui, card.x + side, below, text_width_px, t.text_second, session.sentence, small);
    const int look = std::min(ui.em(8.2F), text_width_px / 3);
    const Rect resume{card.x + side, below + sentence + ui.em(0.86F),
                      text_width_px - look - ui.em(0.57F), button_height};
    const std::string label = resume_label(session);
    if (button(ui, resume,
               {.id = "start.resume",
                .label = label,
                .icon = Icon::kPlay,
                .key = "Space",
                .look = ButtonLook::kNext}) ||
        space) {
        out.push_back(request::Resume{session.folder});
    }
    if (button(ui, {resume.right() + ui.em(0.57F), resume.y, look, button_height},
               {.id = "start.look", .label = "Look only"})) {
        out.push_back(request::Open{session.folder});
    }
    return card.height;
}

void take_keys(const Snapshot& snapshot, const StartPageState& local, Requests& out) {
    if (snapshot.dialog != Dialog::kNone || local.menu) return;
    for (std::size_t i = 0; i < kActions.size(); ++i) {
        if (letter_typed(kActions[i].key)) out.push_back(request_of(i));
    }
}

/// Where the two columns stand; one below the other in a narrow window.
struct Columns {
    Rect left;
    Rect right;
    bool stacked = false;
};

Columns columns_of(const Ui& ui, const Rect& page) {
    const int margin = std::clamp(page.width * 3 / 40, ui.em(1.14F), ui.em(8.57F));
    const int width = std::min(page.width - 2 * margin, ui.em(97.0F));
    const int x = page.x + (page.width - width) / 2;
    const int gap = ui.em(2.3F);
    Columns at;
    at.stacked = width < ui.em(68.0F);
    if (at.stacked) {
        at.left = at.right = {x, page.y, width, 0};
    } else {
        const int left = (width - gap) * 42 / 100;
        at.left = {x, page.y, left, 0};
        at.right = {x + left + gap, page.y, width - left - gap, 0};
    }
    return at;
}

int draw_left(const Ui& ui, Rect at, const Snapshot& snapshot, int picture_height, Requests& out) {
    const RecentSession* last = resumable(snapshot.recent);
    const bool space = snapshot.dialog == Dialog::kNone && space_pressed();
    int y = at.y;
    if (last != nullptr) {
        at.y = y;
        y += draw_resume(ui, at, *last, picture_height, space, out) + ui.em(kGap);
    }
    for (std::size_t i = 0; i < kActions.size(); ++i) {
        const bool next = last == nullptr && i == 0;
        const Rect card{at.x, y, at.width, ui.row(kCard)};
        if (draw_action(ui, card, kActions[i], next, out) || (next && space)) {
            out.push_back(request_of(i));
        }
        y = card.bottom() + ui.em(kGap);
    }
    return y - ui.em(kGap);
}

}  // namespace

void draw_start_page(const Ui& ui, const Rect& rect, const Snapshot& snapshot,
                     StartPageState& local, Requests& out) {
    fill(rect, ui.theme.bg0);
    const bool resume = resumable(snapshot.recent) != nullptr;
    const int actions = 4 * ui.row(kCard) + 3 * ui.em(kGap);
    const int resume_text = ui.em(9.4F) + ui.row(3.43F);
    const int spare = rect.height - ui.em(kHeading) - actions - resume_text - ui.em(5.0F);
    const int picture = std::clamp(spare, ui.em(8.6F), ui.em(14.6F));
    const int body = actions + (resume ? resume_text + picture : ui.em(6.0F));
    const int top = std::clamp((rect.height - ui.em(kHeading) - body) / (resume ? 2 : 3),
                               ui.em(1.7F), ui.em(8.0F));

    ScrollArea scroll(ui, rect, "start.page");
    Columns at = columns_of(ui, scroll.rect());
    const int y = scroll.rect().y + top;
    const auto x = static_cast<float>(at.left.x);
    draw_text(ui, x, static_cast<float>(y) + ui.scale.em(1.5F), FontRole::kHeading, ui.theme.text,
              resume || !snapshot.recent.empty() ? "Commission a cell" : "Welcome to gripscan");
    draw_text(ui, x, static_cast<float>(y) + ui.scale.em(3.75F), FontRole::kText,
              ui.theme.text_second,
              fitted(ui, FontRole::kText,
                     "Scan the gripper, then each object, with the robot’s own angle as the "
                     "witness.",
                     static_cast<float>(rect.right()) - x - ui.scale.em(1.0F)));
    at.left.y = at.right.y = y + ui.em(kHeading) - ui.em(1.0F);
    int bottom = draw_left(ui, at.left, snapshot, picture, out);
    if (at.stacked) {
        at.right.y = bottom + ui.em(kGap);
        at.right.height = ui.em(32.0F);
    } else {
        at.right.height = std::max(bottom - at.right.y, ui.em(22.0F));
    }
    draw_recent_card(ui, at.right, snapshot, local, out);
    bottom = std::max(bottom, at.right.bottom());
    scroll.end(bottom + ui.em(1.7F));
    take_keys(snapshot, local, out);
}

}  // namespace gripscan::ui
