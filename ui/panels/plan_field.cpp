#include "ui/panels/plan_field.h"

#include "ui/panels/panel_parts.h"
#include "ui/widgets/notices.h"
#include "ui/widgets/number_input.h"

namespace gripscan::ui {

void draw_plan_field(const Ui& ui, const Rect& row, const TurnPlan& plan, std::size_t index,
                     const std::string& why_fixed, Requests& out) {
    const PlanField field = plan_fields(plan)[index];
    const float y = middle_of(row);
    draw_text(ui, static_cast<float>(row.x), y, FontRole::kTable, ui.theme.text_second,
              field.label);
    const int width = ui.em(6.0F);
    const int right = ui.em(6.2F);
    const Rect at{row.right() - right - width, row.y + ui.em(0.07F), width, ui.em(1.86F)};
    const auto event = number_input(ui, at,
                                    {.id = field.id,
                                     .label = field.label,
                                     .value = field.value,
                                     .unit = field.unit,
                                     .decimals = field.decimals,
                                     .min = field.min,
                                     .max = field.max,
                                     .why_disabled = why_fixed});
    std::optional<double> wanted = event.committed;
    const std::string standard = shown_number(field.standard, field.decimals);
    if (field.changed() && why_fixed.empty()) {
        if (link(ui, {at.right() + ui.em(0.43F), row.y, right - ui.em(0.43F), row.height},
                 std::string(field.id) + ".reset", "reset " + standard)) {
            wanted = field.standard;
        }
    } else {
        draw_text(ui, static_cast<float>(row.right()), y, FontRole::kSmall, ui.theme.text_third,
                  "default " + standard, Align::kRight);
    }
    if (wanted) out.push_back(request::SetPlan{with_plan_field(plan, index, *wanted)});
}

}  // namespace gripscan::ui
