#include "ui/widgets/notices.h"

#include <fmt/format.h>

#include <algorithm>

#include "ui/widgets/draw.h"
#include "ui/widgets/interact.h"

namespace gripscan::ui {
namespace {

constexpr float kBar = 5.71F;
constexpr float kCancel = 4.29F;

std::string time_text(double seconds) {
    const int whole = std::max(0, static_cast<int>(seconds));
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

std::string percent_text(double part) {
    if (part < 0.0) return "  … %";
    return fmt::format("{:3.0f} %", 100.0 * std::min(part, 1.0));
}

}  // namespace

bool link(const Ui& ui, const Rect& rect, std::string_view id, std::string_view label, Icon icon) {
    const auto [event, attention] = interact(ui, rect, id, label, {}, {});
    const float y = static_cast<float>(rect.y) + 0.5F * static_cast<float>(rect.height);
    const Colour& colour = attention.hovered ? ui.theme.text : ui.theme.accent_text;
    const float icon_width = icon == Icon::kNone ? 0.0F : ui.scale.em(1.21F);
    const float words = text_width(ui, FontRole::kTable, label);
    const float x = static_cast<float>(rect.right()) - words;
    draw_icon(ui, x - 0.5F * icon_width - ui.scale.px(2), y, icon, colour, FontRole::kIconSmall);
    draw_text(ui, x, y, FontRole::kTable, colour, label);
    if (attention.focused) draw_focus_ring(ui, rect, 0.0F);
    return event.clicked;
}

int toast_height(const Ui& ui) {
    return ui.em(4.0F);
}

bool draw_toast(const Ui& ui, const Rect& rect, const Toast& toast) {
    const float radius = ui.scale.em(0.36F);
    fill(rect, ui.theme.panel, radius);
    outline(rect, ui.theme.line2, ui.scale.line(), radius);
    fill({rect.x, rect.y, ui.em(0.21F), rect.height}, colour_of(ui.theme, toast.state));
    const float middle = static_cast<float>(rect.y) + 0.5F * static_cast<float>(rect.height);
    draw_state(ui, static_cast<float>(rect.x + ui.em(1.57F)), middle, toast.state, 1.14F,
               ui.theme.panel);
    const auto left = static_cast<float>(rect.x + ui.em(2.71F));
    const float action = toast.action.empty()
                             ? 0.0F
                             : text_width(ui, FontRole::kTable, toast.action) + ui.scale.em(1.0F);
    const float room = static_cast<float>(rect.right()) - left - action - ui.scale.em(0.86F);
    const float apart = ui.scale.em(0.64F);
    draw_text(ui, left, middle - apart, FontRole::kTextStrong, ui.theme.text,
              fitted(ui, FontRole::kTextStrong, toast.title, room));
    draw_text(ui, left, middle + apart, FontRole::kSmall, ui.theme.text_second,
              fitted(ui, FontRole::kSmall, toast.text, room));
    if (toast.action.empty()) return false;
    const int width = static_cast<int>(action) - ui.em(1.0F);
    return link(ui,
                {rect.right() - ui.em(0.86F) - width, rect.y + ui.em(0.86F), width,
                 rect.height - 2 * ui.em(0.86F)},
                toast.id + ".action", toast.action);
}

int job_bar_width(const Ui& ui, const Job& job) {
    const int name =
        job.name.empty()
            ? 0
            : static_cast<int>(text_width(ui, FontRole::kTable, job.name)) + ui.em(0.64F);
    return name + ui.em(kBar) + ui.em(0.64F) +
           static_cast<int>(text_width(ui, FontRole::kNumberTable, "100 % ")) +
           static_cast<int>(text_width(ui, FontRole::kNumberTable, time_text(job.elapsed_s))) +
           ui.em(0.64F) + (job.can_cancel ? ui.em(kCancel) : 0);
}

bool job_bar(const Ui& ui, int x, float y, const Job& job, int* end_x) {
    auto at = static_cast<float>(x);
    if (!job.name.empty()) {
        at = draw_text(ui, at, y, FontRole::kTable, ui.theme.text_second, job.name) +
             ui.scale.em(0.64F);
    }
    const int height = ui.px(5);
    const Rect bar{static_cast<int>(at), static_cast<int>(y) - height / 2, ui.em(kBar), height};
    const float radius = 0.5F * static_cast<float>(height);
    fill(bar, ui.theme.hover, radius);
    Rect done = bar;
    done.width = static_cast<int>(std::clamp(job.part, 0.0, 1.0) * bar.width);
    fill(done, ui.theme.accent_text, std::min(radius, 0.5F * static_cast<float>(done.width)));
    at = static_cast<float>(bar.right()) + ui.scale.em(0.64F);
    at = draw_text(ui, at, y, FontRole::kNumberTable, ui.theme.text, percent_text(job.part));
    at = draw_text(ui, at + text_width(ui, FontRole::kNumberTable, " "), y, FontRole::kNumberTable,
                   ui.theme.text_third, time_text(job.elapsed_s)) +
         ui.scale.em(0.64F);
    const Rect cancel{static_cast<int>(at), static_cast<int>(y) - ui.em(0.86F), ui.em(kCancel),
                      2 * ui.em(0.86F)};
    if (end_x != nullptr) *end_x = job.can_cancel ? cancel.right() : cancel.x;
    if (!job.can_cancel) return false;
    return link(ui, cancel, std::string(job.id) + ".cancel", "Cancel", Icon::kClose);
}

}  // namespace gripscan::ui
