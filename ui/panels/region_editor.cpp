#include "ui/panels/region_editor.h"

#include <array>

#include "core/base/units.h"
#include "ui/panels/panel_parts.h"
#include "ui/views/cell_view.h"
#include "ui/widgets/button.h"
#include "ui/widgets/number_input.h"
#include "ui/widgets/rich_text.h"

namespace gripscan::ui {
namespace {

constexpr double kFarthest_mm = 5000.0;
constexpr TextStyle kSmall{FontRole::kSmall, FontRole::kNumberSmall, 1.45F};

/// From, to and the size that follows, of one axis.
void draw_axis(const Ui& ui, const Rect& row, const Box& region, int axis, const std::string& why,
               Requests& out) {
    static constexpr std::array<std::array<std::string_view, 2>, 3> kIds{
        {{"region.x.from", "region.x.to"},
         {"region.y.from", "region.y.to"},
         {"region.z.from", "region.z.to"}}};
    static constexpr std::array<std::string_view, 3> kNames{"x", "y", "z"};
    const std::array<Colour, 3> colours{ui.theme.axis_x, ui.theme.axis_y, ui.theme.axis_z};
    const auto k = static_cast<std::size_t>(axis);
    draw_text(ui, static_cast<float>(row.x), middle_of(row), FontRole::kNumberTable, colours[k],
              kNames[k]);
    const int gap = ui.em(0.5F);
    const int name = ui.em(1.43F);
    const int field = (row.width - name - 2 * gap) / 3;
    for (std::size_t end = 0; end < 2; ++end) {
        const Rect at{row.x + name + static_cast<int>(end) * (field + gap), row.y, field,
                      row.height};
        const double value_m = end == 0 ? region.min_m[axis] : region.max_m[axis];
        const auto event = number_input(ui, at,
                                        {.id = kIds[k][end],
                                         .label = end == 0 ? "From" : "To",
                                         .value = value_m * kMmPerM,
                                         .unit = "mm",
                                         .decimals = 1,
                                         .min = -kFarthest_mm,
                                         .max = kFarthest_mm,
                                         .why_disabled = why});
        if (event.committed) {
            out.push_back(request::SetRegion{
                with_region_end(region, axis, end == 1, *event.committed / kMmPerM)});
        }
    }
    const double size_mm = (region.max_m[axis] - region.min_m[axis]) * kMmPerM;
    const float unit = text_width(ui, FontRole::kNumberCaption, " mm");
    draw_text(ui, static_cast<float>(row.right()), middle_of(row), FontRole::kNumberCaption,
              ui.theme.text_third, " mm", Align::kRight);
    draw_text(ui, static_cast<float>(row.right()) - unit, middle_of(row), FontRole::kNumberTable,
              ui.theme.text_second, shown_number(size_mm, 1), Align::kRight);
}

void draw_buttons(const Ui& ui, const Rect& row, const Snapshot& snapshot, const std::string& why,
                  Requests& out) {
    const std::string nothing =
        snapshot.cell.wished_region ? why : std::string("Nothing was changed.");
    const int gap = ui.em(0.57F);
    const int reset = ui.em(6.0F);
    if (button(ui, {row.x, row.y, reset, row.height},
               {.id = "region.reset",
                .label = "Reset",
                .why_disabled = nothing,
                .tooltip = "The area of this session again"})) {
        out.push_back(request::SetRegion{std::nullopt});
    }
    if (button(ui, {row.x + reset + gap, row.y, row.width - reset - gap, row.height},
               {.id = "region.keep",
                .label = "Keep in the cell file…",
                .why_disabled = nothing,
                .tooltip = "Writes it into " + snapshot.cell.file.string() +
                           " and begins a new session with it"})) {
        out.push_back(request::KeepRegion{});
    }
}

}  // namespace

int draw_region_editor(const Ui& ui, int x, int top, int width, const Snapshot& snapshot,
                       Requests& out) {
    draw_section(ui, x, top, "Registration area");
    int y = top + ui.em(1.86F);
    const std::string why = why_region_is_fixed(snapshot);
    const auto region = edited_region(snapshot.cell);
    const std::string_view words =
        !region        ? "The cell has none: whatever both cameras see is registered."
        : !why.empty() ? std::string_view(why)
                       : "Camera frame. It holds from the next session on; in the 3D view it "
                         "can be dragged by its faces.";
    y += draw_rich_text(ui, x, y, width, ui.theme.text_third, words, kSmall) + ui.em(0.29F);
    if (!region) return y - top;
    for (int axis = 0; axis < 3; ++axis) {
        draw_axis(ui, {x, y, width, ui.em(1.86F)}, *region, axis, why, out);
        y += ui.em(2.21F);
    }
    if (!why.empty()) return y - top;
    draw_buttons(ui, {x, y + ui.em(0.29F), width, ui.row(2.14F)}, snapshot, why, out);
    return y + ui.em(0.29F) + ui.row(2.14F) - top;
}

}  // namespace gripscan::ui
