#include "ui/panels/status_bar.h"

#include <fmt/format.h>

#include "ui/panels/mode_of.h"
#include "ui/widgets/draw.h"
#include "ui/widgets/notices.h"
#include "ui/widgets/state_shape.h"

namespace gripscan::ui {
namespace {

std::string_view sentence_of(const Snapshot& snapshot) {
    if (snapshot.session->recorded) return "recording, nothing moves";
    return sentence(mode_of(snapshot.procedure->plan.mode));
}

/// Parts from the left, a separator between them; what has no room is left out.
struct Left {
    const Ui& ui;
    float y;
    float x;
    float end;

    [[nodiscard]] bool room(float width) const { return x + width <= end; }
    void separator() {
        x += ui.scale.em(0.71F);
        fill({static_cast<int>(x), static_cast<int>(y - ui.scale.em(0.64F)),
              static_cast<int>(ui.scale.line()), ui.em(1.29F)},
             ui.theme.line2);
        x += ui.scale.em(0.71F);
    }
    void words(std::string_view text, FontRole role, const Colour& colour, float gap_em = 0.5F) {
        if (text.empty() || !room(text_width(ui, role, text))) return;
        x = draw_text(ui, x, y, role, colour, text) + ui.scale.em(gap_em);
    }
};

void draw_robot(const Ui& ui, Left& left, const Snapshot& snapshot, const Detail& detail) {
    const StatusText status = status_of(snapshot);
    left.separator();
    draw_state(ui, left.x + ui.scale.em(0.5F), left.y, status.robot_state, 0.93F, ui.theme.panel);
    left.x += ui.scale.em(1.29F);
    left.words(status.robot, FontRole::kTable, ui.theme.text);
    ui.log.record({"status.robot", status.robot, {}, true, {}});
    if (status.joint6.empty()) return;
    left.separator();
    left.words("J6", FontRole::kTable, ui.theme.text_second);
    left.words(status.joint6, FontRole::kNumberTable, ui.theme.text);
    const bool tells_others = status.others_moved || !detail.full_right_column;
    if (!tells_others) return;
    left.words(status.other_joints, FontRole::kTable,
               status.others_moved ? ui.theme.check : ui.theme.text_second);
}

void draw_cursor(const Ui& ui, Left& left, const CursorReading& cursor) {
    const std::string text = cursor_text(cursor);
    const float width = text_width(ui, FontRole::kNumberTable, text) + ui.scale.em(3.0F);
    if (!left.room(width)) return;
    left.separator();
    draw_icon(ui, left.x + ui.scale.em(0.5F), left.y, Icon::kCursor, ui.theme.text_second,
              FontRole::kIconSmall);
    left.x += ui.scale.em(1.43F);
    left.words(text, FontRole::kNumberTable, ui.theme.text);
}

/// From the right; returns the x left of it.
float draw_count(const Ui& ui, float x, float y, State state, int count, std::string_view what) {
    if (count == 0) return x;
    const std::string text = fmt::format("{} {}", count, what);
    x -= text_width(ui, FontRole::kTable, text);
    draw_text(ui, x, y, FontRole::kTable, colour_of(ui.theme, state), text);
    x -= ui.scale.em(0.86F);
    draw_state(ui, x, y, state, 0.93F, ui.theme.panel);
    return x - ui.scale.em(1.0F);
}

float draw_job(const Ui& ui, float right, float y, const Snapshot& snapshot, const Detail& detail,
               Requests& out) {
    if (!snapshot.job) {
        const std::string_view text = "no jobs";
        right -= text_width(ui, FontRole::kTable, text);
        draw_text(ui, right, y, FontRole::kTable, ui.theme.text_third, text);
        return right - ui.scale.em(1.0F);
    }
    const ShownJob& shown = *snapshot.job;
    const std::string_view name = detail.full_right_column ? "" : std::string_view(shown.name);
    const Job job{"job", name, shown.part, shown.elapsed_s, shown.can_cancel};
    const int x = static_cast<int>(right) - job_bar_width(ui, job);
    if (job_bar(ui, x, y, job)) out.push_back(request::CancelJob{});
    return static_cast<float>(x) - ui.scale.em(1.0F);
}

}  // namespace

void draw_status_bar(const Ui& ui, const Rect& rect, const Snapshot& snapshot, const Detail& detail,
                     const std::optional<CursorReading>& cursor, Requests& out) {
    fill(rect, ui.theme.panel);
    const bool moves = snapshot.procedure != nullptr && snapshot.session &&
                       !snapshot.session->recorded &&
                       snapshot.procedure->plan.mode == MotionMode::kLive;
    const int line = moves ? ui.px(2) : static_cast<int>(ui.scale.line());
    fill({rect.x, rect.y, rect.width, line}, moves ? ui.theme.live : ui.theme.line);
    const float y = static_cast<float>(rect.y) + 0.5F * static_cast<float>(rect.height);

    float right = static_cast<float>(rect.right()) - ui.scale.em(0.86F);
    const StatusText status = status_of(snapshot);
    right = draw_count(ui, right, y, State::kCheck, status.checks,
                       status.checks == 1 ? "check" : "checks");
    right = draw_count(ui, right, y, State::kReject, status.rejected, "rejected");
    right = draw_job(ui, right, y, snapshot, detail, out);

    Left left{ui, y, static_cast<float>(rect.x + ui.em(0.57F)), right};
    if (snapshot.procedure == nullptr || !snapshot.session) {
        left.words("No session is open", FontRole::kTable, ui.theme.text_second);
        return;
    }
    left.x = static_cast<float>(draw_mode_chip(ui, static_cast<int>(left.x), y,
                                               mode_of(snapshot.procedure->plan.mode))) +
             ui.scale.em(0.57F);
    ui.log.record({"status.mode", std::string(word(snapshot.procedure->plan.mode)), {}, true, {}});
    if (!detail.full_right_column) {
        left.words(sentence_of(snapshot), FontRole::kTable, ui.theme.text_second);
    }
    draw_robot(ui, left, snapshot, detail);
    if (cursor) draw_cursor(ui, left, *cursor);
}

}  // namespace gripscan::ui
