#include "ui/widgets/number_input.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/number_text.h"
#include "ui/widgets/draw.h"
#include "ui/widgets/interact.h"
#include "ui/widgets/tooltip.h"

namespace gripscan::ui {
namespace {

std::string replaced(std::string text, std::string_view from, std::string_view to) {
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
    }
    return text;
}

void draw_frame(const Ui& ui, const Rect& rect, InputLook look) {
    const Theme& t = ui.theme;
    const Colour& border = look == InputLook::kWrong     ? t.reject
                           : look == InputLook::kEditing ? t.accent
                                                         : t.edge;
    const float line = look == InputLook::kNormal ? ui.scale.line() : 2.0F * ui.scale.line();
    fill(rect, t.input, ui.scale.em(0.29F));
    outline(rect, border, line, ui.scale.em(0.29F));
}

float middle_y(const Rect& rect) {
    return static_cast<float>(rect.y) + 0.5F * static_cast<float>(rect.height);
}

/// Where the number ends and the unit begins.
float number_right(const Ui& ui, const Rect& rect, std::string_view unit) {
    const float unit_width =
        unit.empty() ? 0.0F : text_width(ui, FontRole::kNumberCaption, unit) + ui.scale.em(0.43F);
    return static_cast<float>(rect.right()) - ui.scale.em(0.57F) - unit_width;
}

void draw_unit(const Ui& ui, const Rect& rect, std::string_view unit) {
    draw_text(ui, static_cast<float>(rect.right()) - ui.scale.em(0.57F), middle_y(rect),
              FontRole::kNumberCaption, ui.theme.text_third, unit, Align::kRight);
}

/// The input of Dear ImGui without its frame; its text shows only while somebody edits.
std::string text_field(const Ui& ui, const Rect& rect, const std::string& id,
                       const std::string& shown, bool editing, const NumberSpec& spec) {
    std::array<char, 48> buffer{};
    std::copy_n(shown.data(), std::min(shown.size(), buffer.size() - 1), buffer.data());
    ImFont* font = ui.fonts[FontRole::kNumberTable];
    const float pad = std::floor(0.5F * (static_cast<float>(rect.height) - font->FontSize));
    ImGui::PushFont(font);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui.scale.em(0.43F), pad});
    ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 0.0F);
    ImGui::PushStyleColor(ImGuiCol_FrameBg, 0);
    ImGui::PushStyleColor(ImGuiCol_Text, editing ? ui.theme.text.packed() : 0);
    ImGui::BeginDisabled(!spec.why_disabled.empty());
    ImGui::SetCursorScreenPos({static_cast<float>(rect.x), static_cast<float>(rect.y)});
    ImGui::SetNextItemWidth(number_right(ui, rect, spec.unit) - static_cast<float>(rect.x) +
                            ui.scale.em(0.21F));
    ImGui::InputText(id.c_str(), buffer.data(), buffer.size(), ImGuiInputTextFlags_AutoSelectAll);
    ImGui::EndDisabled();
    ImGui::PopStyleColor(2);
    ImGui::PopStyleVar(2);
    ImGui::PopFont();
    return buffer.data();
}

}  // namespace

NumberEvent typed_number(std::string_view text, const NumberSpec& spec) {
    std::string plain = replaced(std::string(text), "−", "-");
    plain = replaced(replaced(replaced(plain, "\u2009", ""), "\u00a0", ""), ",", ".");
    if (!spec.unit.empty() && plain.ends_with(spec.unit)) {
        plain.resize(plain.size() - spec.unit.size());
    }
    const auto number = number_from_text(plain);
    if (number && *number >= spec.min && *number <= spec.max) return {number, {}};
    return {std::nullopt, fmt::format("{} to {} {}", text_from_number(spec.min),
                                      text_from_number(spec.max), spec.unit)};
}

void draw_input(const Ui& ui, const Rect& rect, std::string_view text, std::string_view unit,
                InputLook look) {
    draw_frame(ui, rect, look);
    draw_text(ui, number_right(ui, rect, unit), middle_y(rect), FontRole::kNumberTable,
              look == InputLook::kWrong ? ui.theme.reject : ui.theme.text, text, Align::kRight);
    draw_unit(ui, rect, unit);
}

NumberEvent number_input(const Ui& ui, const Rect& rect, const NumberSpec& spec) {
    const std::string shown = shown_number(spec.value, spec.decimals);
    const std::string hidden = "##" + std::string(spec.id);
    const ImGuiID id = ImGui::GetID(hidden.c_str());
    const bool editing = ImGui::GetActiveID() == id;
    ui.log.record({std::string(spec.id), std::string(spec.label), rect, spec.why_disabled.empty(),
                   std::string(spec.why_disabled), editing});
    if (!spec.why_disabled.empty()) {
        dashed_outline(ui, rect, ui.theme.line2, 3.0F, 3.0F);
        draw_text(ui, number_right(ui, rect, spec.unit), middle_y(rect), FontRole::kNumberTable,
                  ui.theme.text_third, shown, Align::kRight);
        draw_unit(ui, rect, spec.unit);
    } else if (editing) {
        draw_frame(ui, rect, InputLook::kEditing);
        draw_unit(ui, rect, spec.unit);
    } else {
        draw_input(ui, rect, shown, spec.unit, InputLook::kNormal);
    }
    const std::string typed = text_field(ui, rect, hidden, shown, editing, spec);
    if (!spec.why_disabled.empty()) {
        tooltip(ui, {fmt::format("{} is not possible", spec.label), {}, spec.why_disabled});
    }
    const bool left_it = ImGui::IsItemDeactivatedAfterEdit();
    if (ImGui::GetActiveID() != id && !left_it) return {};
    if (typed == shown) return {};  // untouched, or taken back by Escape
    NumberEvent event = typed_number(typed, spec);
    if (!left_it) event.committed.reset();
    if (!event.problem.empty()) {
        outline(rect, ui.theme.reject, 2.0F * ui.scale.line(), ui.scale.em(0.29F));
    }
    return event;
}

std::optional<double> slider(const Ui& ui, const Rect& rect, const NumberSpec& spec) {
    const auto [event, attention] = interact(ui, rect, spec.id, spec.label, spec.why_disabled, {});
    const int half = ui.px(5);
    const double room = std::max(1, rect.width - 2 * half);
    std::optional<double> moved;
    if (event.held) {
        const double part = (static_cast<double>(ImGui::GetIO().MousePos.x) - rect.x - half) / room;
        const double step = std::pow(10.0, -spec.decimals);
        const double value = spec.min + std::clamp(part, 0.0, 1.0) * (spec.max - spec.min);
        moved = std::clamp(std::round(value / step) * step, spec.min, spec.max);
    }
    const double value = moved.value_or(spec.value);
    const double part = spec.max > spec.min
                            ? std::clamp((value - spec.min) / (spec.max - spec.min), 0.0, 1.0)
                            : 0.0;
    const int x = rect.x + half + static_cast<int>(part * room);
    const int y = static_cast<int>(middle_y(rect));
    const int bar = ui.px(4);
    const bool enabled = spec.why_disabled.empty();
    fill({rect.x, y - bar / 2, rect.width, bar}, ui.theme.hover, 0.5F * ui.scale.px(4));
    fill({rect.x, y - bar / 2, x - rect.x, bar}, enabled ? ui.theme.accent : ui.theme.line2,
         0.5F * ui.scale.px(4));
    const Rect knob{x - half, y - ui.px(8), 2 * half, ui.px(16)};
    fill(knob, enabled ? ui.theme.text : ui.theme.text_third, ui.scale.px(3));
    if (attention.focused) draw_focus_ring(ui, knob, ui.scale.px(3));
    return moved && *moved != spec.value ? moved : std::nullopt;
}

}  // namespace gripscan::ui
