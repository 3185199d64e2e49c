#include "ui/panels/step_card.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "core/base/units.h"
#include "ui/panels/action_button.h"
#include "ui/panels/evidence_of.h"
#include "ui/panels/step_heading.h"
#include "ui/views/cell_view.h"
#include "ui/widgets/choice.h"
#include "ui/widgets/draw.h"
#include "ui/widgets/number_input.h"
#include "ui/widgets/rich_text.h"
#include "ui/widgets/tooltip.h"
#include "ui/widgets/verdict_card.h"

namespace gripscan::ui {
namespace {

constexpr float kGap = 0.57F;
constexpr float kButton = 2.57F;
constexpr float kNextButton = 3.43F;
constexpr double kMostJoint6_deg = 720.0;
constexpr double kHoldFill_s = 1.0;  ///< until the button looks full

/// One frame of the card.
struct Card {
    const Ui& ui;
    const Snapshot& snapshot;
    const Detail& detail;
    StepCardState& local;
    Requests& out;
    int left;
    int width;

    [[nodiscard]] int gap() const { return ui.em(kGap); }

    void verdict(int& y) const {
        const VerdictWords words = verdict_of(snapshot);
        y += draw_verdict_card(
            ui, left, y, width,
            {words.state, words.word, words.basis, words.basis_is_number, words.sentence});
    }

    void cause(int& y) const {
        const auto text = cause_of(snapshot);
        if (!text) return;
        y += ui.em(0.71F);
        draw_text(ui, static_cast<float>(left), static_cast<float>(y + ui.em(0.43F)),
                  FontRole::kCaption, ui.theme.text_third, "Likely cause");
        y += ui.em(1.07F);
        constexpr TextStyle kStyle{FontRole::kTextStrong, FontRole::kNumber, 1.36F};
        const Rect line{left, y, width, rich_text_height(ui, width, text->cause, kStyle)};
        y += draw_rich_text(ui, left, y, width, ui.theme.text, text->cause, kStyle);
        ui.log.record({"step.cause", text->cause, line, true, {}});
        if (text->advice.empty()) return;
        ImGui::SetCursorScreenPos({static_cast<float>(line.x), static_cast<float>(line.y)});
        ImGui::Dummy({static_cast<float>(line.width), static_cast<float>(line.height)});
        tooltip(ui, {text->cause, {}, text->advice});
    }

    /// As many rows as there is room for down to `bottom`.
    void evidence(int y, int bottom) const {
        const auto rows = evidence_rows(snapshot);
        if (rows.empty()) return advice_in(y, bottom);
        const EvidenceCaption caption = evidence_caption(snapshot);
        y += ui.em(0.36F);
        const int count = static_cast<int>(rows.size());
        const int caption_height = caption.words.empty() ? 0 : ui.em(1.43F);
        const int height =
            std::clamp((bottom - y - caption_height) / count, ui.em(1.29F), ui.em(1.64F));
        if (!caption.words.empty()) {
            const Rect line{left, y, width, caption_height};
            draw_text(ui, static_cast<float>(left), static_cast<float>(y) + ui.scale.em(0.71F),
                      FontRole::kCaption, ui.theme.text_third, caption.words);
            ui.log.record({"step.evidence_of", caption.words, line, true, {}});
            y += caption_height;
        }
        for (const EvidenceText& e : rows) {
            if (y + height > bottom) break;
            evidence_line({left, y, width, height}, e, caption.past);
            y += height;
        }
        draw_limit_editor(ui, snapshot, local.limit, out);
        if (!shown_step(snapshot)) advice_in(y, bottom);
    }

    void evidence_line(const Rect& row, const EvidenceText& e, bool past) const {
        const std::string fixed = why_limit_is_fixed(snapshot, e.id);
        std::string meaning(e.meaning);
        if (fixed.empty()) {
            meaning += " Click to change the limit.";
        } else if (!limit_fields(e.id).empty()) {
            meaning += " The limit stays: " + fixed;
        }
        Evidence shown = evidence_of(e);
        shown.meaning = meaning;
        shown.past = past;
        if (evidence_row(ui, row, shown)) open_limit_editor(local.limit, snapshot, e.id, row);
    }

    /// Before the first step there is no evidence: what the next action does stands there.
    void advice_in(int y, int bottom) const {
        const Action* next = next_action(snapshot);
        if (next == nullptr || bottom - y < ui.em(3.0F)) return;
        y += ui.em(1.0F);
        draw_text(ui, static_cast<float>(left), static_cast<float>(y + ui.em(0.43F)),
                  FontRole::kCaption, ui.theme.text_third, "Next");
        y += ui.em(1.21F);
        draw_rich_text(ui, left, y, width, ui.theme.text_second, fmt::format("{}.", next->tooltip),
                       {FontRole::kText, FontRole::kNumber, 1.5F});
    }

    /// MANUAL: where joint 6 stands, as the operator reads it. Returns where it begins.
    int told_angle(const Rect& row) const {
        const ToldAngle told = told_angle_of(snapshot);
        const Rect at{row.right() - ui.em(7.4F), row.y, ui.em(7.4F), row.height};
        const float middle = static_cast<float>(row.y) + 0.5F * static_cast<float>(row.height);
        const float label_right = static_cast<float>(at.x) - ui.scale.em(0.43F);
        const std::string_view label = "J6 stands at";
        draw_text(ui, label_right, middle, FontRole::kTable, ui.theme.text_second, label,
                  Align::kRight);
        const auto event = number_input(ui, at,
                                        {.id = "step.told_angle",
                                         .label = told.label,
                                         .value = told.joint6_deg,
                                         .unit = "°",
                                         .decimals = 3,
                                         .min = -kMostJoint6_deg,
                                         .max = kMostJoint6_deg,
                                         .why_disabled = told.why_not});
        if (event.committed) {
            out.push_back(request::Give{command::TellAngle{rad_from_deg(*event.committed)}});
        }
        return static_cast<int>(label_right - text_width(ui, FontRole::kTable, label));
    }

    void run_or_by_hand(const Rect& row) const {
        const bool manual =
            snapshot.procedure != nullptr && snapshot.procedure->plan.mode == MotionMode::kManual;
        const int end = manual ? told_angle(row) : joint_speed(row);
        const int room = end - row.x - ui.em(0.86F);
        const bool running = snapshot.procedure != nullptr && snapshot.procedure->running;
        const Action& run = action("step.run");
        const Action& pause = action("step.pause");
        const std::string why_run =
            running ? std::string() : run.refusal(snapshot).value_or(std::string());
        const std::array<Option, 2> options{
            {{"mode.by_hand", "By hand"}, {"mode.run", run.label, Icon::kNone, {}, why_run}}};
        const auto clicked =
            segments(ui, {row.x, row.y, room, row.height}, options, running ? 1 : 0);
        if (clicked == 1U && !running) out.push_back(run.request(snapshot));
        if (clicked == 0U && running) out.push_back(pause.request(snapshot));
    }

    /// Returns where its words begin.
    int joint_speed(const Rect& row) const {
        const std::string speed =
            snapshot.procedure == nullptr
                ? std::string()
                : fmt::format("{:.0f} %", snapshot.procedure->plan.speed_percent);
        const std::string_view label = "J6 speed";
        const float speed_width = text_width(ui, FontRole::kNumberTable, speed);
        const float label_width = text_width(ui, FontRole::kTable, label);
        const float middle = static_cast<float>(row.y) + 0.5F * static_cast<float>(row.height);
        const auto right = static_cast<float>(row.right());
        draw_text(ui, right, middle, FontRole::kNumberTable, ui.theme.text, speed, Align::kRight);
        draw_text(ui, right - speed_width - ui.scale.em(0.43F), middle, FontRole::kTable,
                  ui.theme.text_second, label, Align::kRight);
        return row.right() - static_cast<int>(speed_width + label_width) - ui.em(0.57F);
    }

    /// LIVE: by hand, motion is allowed only while this is held.
    void hold(const Rect& rect) const {
        const double part = local.holding ? (ui.time_s - local.holding_since_s) / kHoldFill_s : 0.0;
        const bool held = button(ui, rect,
                                 {.id = "live.hold",
                                  .label = "Hold to move",
                                  .look = ButtonLook::kHold,
                                  .tooltip = "Holding it begins the next motion, letting go stops "
                                             "it. Not a safety function",
                                  .held_part = static_cast<float>(std::clamp(part, 0.0, 1.0))})
                              .held;
        if (held == local.holding) return;
        local.holding = held;
        local.holding_since_s = ui.time_s;
        out.push_back(request::HoldToMove{held});
    }
    void let_go() const {
        if (local.holding) out.push_back(request::HoldToMove{false});
        local.holding = false;
    }

    /// The large button: the next action, or what stands there while there is none.
    [[nodiscard]] const Action& large_action() const {
        if (const Action* next = next_action(snapshot)) return *next;
        const bool running = snapshot.procedure != nullptr && snapshot.procedure->running;
        return action(running ? "step.pause" : "step.step");
    }

    void next_row(Rect row) const {
        const bool live = snapshot.procedure != nullptr &&
                          snapshot.procedure->plan.mode == MotionMode::kLive && snapshot.session &&
                          !snapshot.session->recorded;
        if (live) {
            const int hold_width = row.width * 2 / 5;
            hold({row.right() - hold_width, row.y, hold_width, row.height});
            row.width -= hold_width + gap();
        } else {
            let_go();
        }
        const Action& large = large_action();
        const bool is_next = &large == next_action(snapshot);
        const std::string label = next_label(large, snapshot);
        const ButtonLook look = is_next ? ButtonLook::kNext : ButtonLook::kNormal;
        action_button(ui, row, large, snapshot, {look, !live, label}, out);
    }

    /// Six places that never change, but for the one whose action is next: Step takes it.
    void slots(int y) const {
        constexpr std::array<std::string_view, 6> kNames{"step.capture", "step.retry", "step.halve",
                                                         "step.accept",  "step.back",  "step.stop"};
        const Action* second = second_advice(snapshot);
        const Action& large = large_action();
        const int height = ui.row(kButton);
        for (int i = 0; i < 6; ++i) {
            const int column = i % 3;
            const int from = left + (width + gap()) * column / 3;
            const int to = left + (width + gap()) * (column + 1) / 3 - gap();
            const Rect at{from, y + i / 3 * (height + gap()), to - from, height};
            const Action* shown = &action(kNames[static_cast<std::size_t>(i)]);
            if (shown == &large) shown = &action("step.step");
            const ButtonLook look = shown->name == "step.stop" ? ButtonLook::kStop
                                    : shown == second          ? ButtonLook::kSecond
                                                               : ButtonLook::kNormal;
            action_button(ui, at, *shown, snapshot, {look, detail.button_icons}, out);
        }
    }

    void waits(const Rect& line) const {
        const std::string why = why_step_waits(snapshot);
        if (why.empty()) return;
        const float middle = static_cast<float>(line.y) + 0.5F * static_cast<float>(line.height);
        draw_icon(ui, static_cast<float>(line.x) + ui.scale.em(0.57F), middle, Icon::kInformation,
                  ui.theme.text_third, FontRole::kIconSmall);
        const float room = static_cast<float>(line.width) - ui.scale.em(1.57F);
        draw_text(ui, static_cast<float>(line.x) + ui.scale.em(1.57F), middle, FontRole::kSmall,
                  ui.theme.text_second, fitted(ui, FontRole::kSmall, why, room));
        ui.log.record({"step.waits", why, line, true, {}});
    }
};

}  // namespace

void draw_step_card(const Ui& ui, const Rect& rect, const Snapshot& snapshot, const Detail& detail,
                    StepCardState& local, Requests& out) {
    fill(rect, ui.theme.panel);
    const int side = ui.em(1.0F);
    const Card card{ui, snapshot, detail, local, out, rect.x + side, rect.width - 2 * side};

    // From the bottom: what a hand finds without looking.
    int bottom = rect.bottom() - ui.em(0.29F);
    const int waits = ui.em(1.43F);
    card.waits({card.left, bottom - waits, card.width, waits});
    bottom -= waits + ui.em(0.29F) + 2 * ui.row(kButton) + card.gap();
    card.slots(bottom);
    bottom -= card.gap() + ui.row(kNextButton);
    card.next_row({card.left, bottom, card.width, ui.row(kNextButton)});
    bottom -= card.gap() + ui.em(1.86F);
    card.run_or_by_hand({card.left, bottom, card.width, ui.em(1.86F)});
    bottom -= ui.em(0.43F);

    // From the top: what it is about.
    int y = rect.y + ui.em(0.57F);
    y += draw_step_heading(ui, card.left, y, card.width, snapshot, detail);
    y += ui.em(0.43F);
    card.verdict(y);
    card.cause(y);
    card.evidence(y, bottom);
}

}  // namespace gripscan::ui
