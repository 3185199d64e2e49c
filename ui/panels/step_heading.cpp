#include "ui/panels/step_heading.h"

#include <algorithm>

#include "ui/views/step_text.h"
#include "ui/widgets/closure_dial.h"
#include "ui/widgets/draw.h"

namespace gripscan::ui {
namespace {

constexpr float kTitle = 1.86F;
constexpr float kLine = 1.21F;

/// Smaller where the reason of a rejection needs the room, and in a small window.
float dial_em(const Snapshot& snapshot, const Detail& detail) {
    if (cause_of(snapshot)) return 6.0F;
    return detail.full_right_column ? 5.86F : 7.0F;
}

void draw_line_of(const Ui& ui, int x, int right, float y, const HeadingLine& line) {
    draw_text(ui, static_cast<float>(x), y, FontRole::kTable, ui.theme.text_second, line.label);
    const float value = static_cast<float>(x) + ui.scale.em(5.43F);
    const float end = draw_text(ui, value, y, FontRole::kNumberTable, ui.theme.text, line.value) +
                      ui.scale.em(0.57F);
    draw_text(ui, end, y, FontRole::kNumberTable, ui.theme.text_third,
              fitted(ui, FontRole::kNumberTable, line.note, static_cast<float>(right) - end));
}

}  // namespace

int draw_step_heading(const Ui& ui, int x, int y, int width, const Snapshot& snapshot,
                      const Detail& detail) {
    const int side = ui.em(dial_em(snapshot, detail));
    const DialText dial = dial_of(snapshot);
    draw_closure_dial(
        ui, {x, y, side, side},
        {dial.turned_deg, dial.next_deg, dial.refused_deg, dial.robot_deg, dial.whole_deg});
    StepHeading heading = heading_of(snapshot);
    // In a small window there is room for three lines: the expected error goes.
    if (detail.full_right_column && heading.lines.size() > 3) {
        heading.lines.erase(heading.lines.begin() + 2);
    }
    const int left = x + side + ui.em(1.21F);
    const int lines = static_cast<int>(heading.lines.size());
    const int block = ui.em(kTitle) + lines * ui.em(kLine);
    int top = y + std::max(0, (side - block) / 2);
    const float title_y = static_cast<float>(top) + 0.5F * ui.scale.em(kTitle);
    const float end = draw_text(ui, static_cast<float>(left), title_y, FontRole::kTitle,
                                ui.theme.text, heading.title);
    draw_text(ui, end + ui.scale.em(0.36F), title_y, FontRole::kTitleLight, ui.theme.text_third,
              heading.of);
    top += ui.em(kTitle);
    for (const HeadingLine& line : heading.lines) {
        draw_line_of(ui, left, x + width, static_cast<float>(top) + 0.5F * ui.scale.em(kLine),
                     line);
        top += ui.em(kLine);
    }
    return side;
}

}  // namespace gripscan::ui
