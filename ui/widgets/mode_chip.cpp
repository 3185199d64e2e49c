#include "ui/widgets/mode_chip.h"

#include <array>

#include "ui/widgets/draw.h"

namespace gripscan::ui {

std::string_view word(RobotMode mode) {
    constexpr std::array<std::string_view, 4> kWords{"SIM", "DRY", "LIVE", "MANUAL"};
    return kWords[static_cast<std::size_t>(mode)];
}

std::string_view sentence(RobotMode mode) {
    constexpr std::array<std::string_view, 4> kSentences{"simulated cell, no robot moves",
                                                         "robot linked, no motion", "robot moves",
                                                         "the operator turns joint 6"};
    return kSentences[static_cast<std::size_t>(mode)];
}

int draw_mode_chip(const Ui& ui, int x, float y, RobotMode mode) {
    const Theme& t = ui.theme;
    const std::string_view name = word(mode);
    const int height = ui.em(1.57F);
    const int width = ui.em(2.29F) +
                      static_cast<int>(text_width(ui, FontRole::kTableStrong, name)) + ui.em(0.57F);
    const Rect chip{x, static_cast<int>(y) - height / 2, width, height};
    Colour colour = t.text;
    Icon icon = Icon::kPause;
    if (mode == RobotMode::kSim) {
        colour = t.sim;
        icon = Icon::kFlask;
        fill(chip, t.sim_bg, ui.scale.em(0.21F));
        dashed_outline(ui, chip, t.sim, 3.0F, 2.0F);
    } else if (mode == RobotMode::kDry || mode == RobotMode::kManual) {
        if (mode == RobotMode::kManual) icon = Icon::kStep;
        fill(chip, t.raised, ui.scale.em(0.21F));
        outline(chip, t.text_second, ui.scale.line(), ui.scale.em(0.21F));
    } else {
        colour = t.live_on;
        icon = Icon::kFlash;
        fill(chip, t.live, ui.scale.em(0.21F));
    }
    draw_icon(ui, static_cast<float>(x + ui.em(1.21F)), y, icon, colour, FontRole::kIconSmall);
    draw_text(ui, static_cast<float>(x + ui.em(2.14F)), y, FontRole::kTableStrong, colour, name);
    return chip.right();
}

}  // namespace gripscan::ui
