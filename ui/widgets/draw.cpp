#include "ui/widgets/draw.h"

#include <cmath>
#include <numbers>

namespace gripscan::ui {
namespace {

/// Capitals of Inter and JetBrains Mono, in em.
constexpr float kCapHeight = 0.728F;

ImDrawList& canvas() {
    return *ImGui::GetWindowDrawList();
}

std::string utf8(unsigned code) {
    return {static_cast<char>(0xE0U | code >> 12U), static_cast<char>(0x80U | (code >> 6U & 0x3FU)),
            static_cast<char>(0x80U | (code & 0x3FU))};
}

}  // namespace

float text_width(const Ui& ui, FontRole role, std::string_view text) {
    if (text.empty()) return 0.0F;  // without a pointer Dear ImGui would look for the end
    const ImFont* font = ui.fonts[role];
    return font->CalcTextSizeA(font->FontSize, 1e9F, 0.0F, text.data(), text.data() + text.size())
        .x;
}

float draw_text(const Ui& ui, float x, float y, FontRole role, const Colour& colour,
                std::string_view text, Align align) {
    if (text.empty()) return x;
    const float width = text_width(ui, role, text);
    if (align == Align::kCentre) x -= 0.5F * width;
    if (align == Align::kRight) x -= width;
    const ImFont* font = ui.fonts[role];
    const float baseline = std::round(y + 0.5F * kCapHeight * ui.fonts.em_px(role));
    const ImVec2 at{std::round(x), baseline - font->Ascent};
    canvas().AddText(font, font->FontSize, at, colour.packed(), text.data(),
                     text.data() + text.size());
    return std::round(x) + width;
}

std::string fitted(const Ui& ui, FontRole role, std::string_view text, float width) {
    if (text_width(ui, role, text) <= width) return std::string(text);
    const std::string dots = "…";
    std::size_t length = text.size();
    while (length > 0) {
        --length;
        while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U) --length;
        const std::string cut = std::string(text.substr(0, length)) + dots;
        if (text_width(ui, role, cut) <= width) return cut;
    }
    return {};
}

std::string fitted_middle(const Ui& ui, FontRole role, std::string_view text, float width) {
    if (text_width(ui, role, text) <= width) return std::string(text);
    const auto begins = [&](std::size_t i) {
        return i >= text.size() || (static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U;
    };
    // One third in front of the gap, two behind it.
    for (std::size_t kept = text.size(); kept > 0; --kept) {
        std::size_t front = kept / 3;
        std::size_t back = text.size() - (kept - front);
        while (front > 0 && !begins(front)) --front;
        while (!begins(back)) ++back;
        std::string cut = std::string(text.substr(0, front)) + "…" + std::string(text.substr(back));
        if (text_width(ui, role, cut) <= width) return cut;
    }
    return {};
}

void draw_icon(const Ui& ui, float x, float y, Icon icon, const Colour& colour, FontRole size) {
    if (icon == Icon::kNone) return;
    const ImFont* font = ui.fonts[size];
    const ImFontGlyph* glyph = font->FindGlyph(static_cast<ImWchar>(icon));
    if (glyph == nullptr) return;
    const std::string text = utf8(static_cast<unsigned>(icon));
    const ImVec2 at{std::round(x - 0.5F * (glyph->X0 + glyph->X1)),
                    std::round(y - 0.5F * (glyph->Y0 + glyph->Y1))};
    canvas().AddText(font, font->FontSize, at, colour.packed(), text.data(),
                     text.data() + text.size());
}

void fill(const Rect& rect, const Colour& colour, float radius) {
    if (rect.empty()) return;
    canvas().AddRectFilled({static_cast<float>(rect.x), static_cast<float>(rect.y)},
                           {static_cast<float>(rect.right()), static_cast<float>(rect.bottom())},
                           colour.packed(), radius);
}

void outline(const Rect& rect, const Colour& colour, float thickness, float radius) {
    if (rect.empty()) return;
    const float half = 0.5F * thickness;
    // AddRect insets its path by half a pixel by itself.
    canvas().AddRect(
        {static_cast<float>(rect.x) + half - 0.5F, static_cast<float>(rect.y) + half - 0.5F},
        {static_cast<float>(rect.right()) - half + 0.5F,
         static_cast<float>(rect.bottom()) - half + 0.5F},
        colour.packed(), radius, 0, thickness);
}

void draw_line(const Ui& ui, ImVec2 a, ImVec2 b, const Colour& colour, float thickness) {
    canvas().AddLine(a, b, colour.packed(), thickness > 0.0F ? thickness : ui.scale.line());
}

void dashed_line(const Ui& ui, ImVec2 a, ImVec2 b, const Colour& colour, float dash_px,
                 float gap_px) {
    const float length = std::hypot(b.x - a.x, b.y - a.y);
    const float dash = ui.scale.px(dash_px);
    const float period = dash + ui.scale.px(gap_px);
    if (length <= 0.0F || period < 1.0F) return;
    const ImVec2 step{(b.x - a.x) / length, (b.y - a.y) / length};
    for (float s = 0.0F; s < length; s += period) {
        const float e = std::min(s + dash, length);
        draw_line(ui, {a.x + step.x * s, a.y + step.y * s}, {a.x + step.x * e, a.y + step.y * e},
                  colour);
    }
}

void dashed_outline(const Ui& ui, const Rect& rect, const Colour& colour, float dash_px,
                    float gap_px) {
    const float half = 0.5F * ui.scale.line();
    const float left = static_cast<float>(rect.x) + half;
    const float top = static_cast<float>(rect.y) + half;
    const float right = static_cast<float>(rect.right()) - half;
    const float bottom = static_cast<float>(rect.bottom()) - half;
    const float corner = ui.scale.px(3.0F);
    dashed_line(ui, {left + corner, top}, {right - corner, top}, colour, dash_px, gap_px);
    dashed_line(ui, {left + corner, bottom}, {right - corner, bottom}, colour, dash_px, gap_px);
    dashed_line(ui, {left, top + corner}, {left, bottom - corner}, colour, dash_px, gap_px);
    dashed_line(ui, {right, top + corner}, {right, bottom - corner}, colour, dash_px, gap_px);
    const auto arc = [&](float x, float y, float from) {
        canvas().PathArcTo({x, y}, corner, from * std::numbers::pi_v<float>,
                           (from + 0.5F) * std::numbers::pi_v<float>, 6);
        canvas().PathStroke(colour.packed(), 0, ui.scale.line());
    };
    arc(left + corner, top + corner, 1.0F);
    arc(right - corner, top + corner, 1.5F);
    arc(right - corner, bottom - corner, 0.0F);
    arc(left + corner, bottom - corner, 0.5F);
}

}  // namespace gripscan::ui
