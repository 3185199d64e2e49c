#include "tests/render/widget_gallery.h"

#include <array>
#include <vector>

#include "ui/widgets/button.h"
#include "ui/widgets/choice.h"
#include "ui/widgets/closure_dial.h"
#include "ui/widgets/data_table.h"
#include "ui/widgets/draw.h"
#include "ui/widgets/error_plot.h"
#include "ui/widgets/evidence_row.h"
#include "ui/widgets/interact.h"
#include "ui/widgets/legend.h"
#include "ui/widgets/mode_chip.h"
#include "ui/widgets/notices.h"
#include "ui/widgets/number_input.h"
#include "ui/widgets/tooltip.h"
#include "ui/widgets/verdict_card.h"

namespace gripscan::test {
namespace {

using namespace gripscan::ui;

/// Places of the page, in px at 100 %.
struct Page {
    const Ui& ui;

    [[nodiscard]] Rect rect(int x, int y, int width, int height) const {
        return {ui.px(static_cast<float>(x)), ui.px(static_cast<float>(y)),
                ui.px(static_cast<float>(width)), ui.px(static_cast<float>(height))};
    }
    void words(int x, int y, FontRole role, const Colour& colour, std::string_view text,
               Align align = Align::kLeft) const {
        draw_text(ui, ui.scale.px(static_cast<float>(x)), ui.scale.px(static_cast<float>(y)), role,
                  colour, text, align);
    }
    void heading(int x, int y, std::string_view text) const {
        words(x, y, FontRole::kTextStrong, ui.theme.text, text);
    }
    void caption(int x, int y, std::string_view text, Align align = Align::kLeft) const {
        words(x, y, FontRole::kCaption, ui.theme.text_second, text, align);
    }
};

void buttons(const Page& page) {
    const Ui& ui = page.ui;
    page.heading(40, 38, "Buttons");
    const ButtonSpec retry{.id = "g.retry", .label = "Retry", .icon = Icon::kRetry, .key = "R"};
    ButtonSpec second = retry;
    second.look = ButtonLook::kSecond;
    const ButtonSpec disabled{.id = "g.step",
                              .label = "Step",
                              .icon = Icon::kStep,
                              .why_disabled = "6 must be accepted or taken back first."};
    const ButtonSpec stop{.id = "g.stop",
                          .label = "Stop",
                          .icon = Icon::kStop,
                          .key = "Esc",
                          .look = ButtonLook::kStop};
    struct Shown {
        ButtonSpec spec;
        Attention attention;
        const char* name;
    };
    const std::array<Shown, 7> row{{{retry, {}, "default"},
                                    {retry, {.hovered = true}, "hover"},
                                    {retry, {.hovered = true, .held = true}, "active, pressed"},
                                    {retry, {.focused = true}, "keyboard focus"},
                                    {second, {}, "second advice"},
                                    {disabled, {}, "disabled"},
                                    {stop, {}, "stop, never disabled"}}};
    int x = 40;
    for (const Shown& shown : row) {
        draw_button(ui, page.rect(x, 60, 132, 36), shown.spec, shown.attention);
        page.caption(x + 66, 108, shown.name, Align::kCentre);
        x += 144;
    }
    draw_button(ui, page.rect(1048, 60, 262, 48),
                {.id = "g.next",
                 .label = "Step +10° and capture",
                 .icon = Icon::kStep,
                 .key = "Space",
                 .look = ButtonLook::kNext},
                {});
    page.caption(1179, 120, "next action, one per window", Align::kCentre);
    draw_button(ui, page.rect(1322, 60, 190, 48),
                {.id = "g.hold",
                 .label = "Hold to move",
                 .icon = Icon::kStep,
                 .look = ButtonLook::kHold,
                 .held_part = 0.4F},
                {});
    page.caption(1417, 120, "LIVE, moves only while held", Align::kCentre);
}

void notices(const Page& page) {
    const Ui& ui = page.ui;
    const auto card = [&](int x, int width, const TooltipText& text) {
        const Rect at = page.rect(x, 152, width, 0);
        draw_tooltip(ui, at.x, at.y, at.width, text);
    };
    card(40, 330, {"Step is not possible", {}, "6 must be accepted or taken back first."});
    page.caption(40, 228, "tooltip of a disabled button: what, then why");
    card(400, 380,
         {"Axis tilt", "0.056°",
          "Angle between the axis of this step and the axis of all accepted steps. Limit "
          "`0.200`°."});
    page.caption(400, 246, "tooltip of a number: value, formula in words, limit");
    const Toast toast{"g.toast", State::kAccept, "Exported and read back",
                      "valve-T20_v3.pcd, 369 090 points", "Open folder"};
    const Rect place = page.rect(812, 152, 392, 56);
    (void)draw_toast(ui, place, toast);
    page.caption(812, 222, "toast: bottom right of the 3D view, 6 s, takes no focus");
    const Rect job = page.rect(1224, 172, 0, 0);
    (void)job_bar(ui, job.x, static_cast<float>(job.y), {"g.job", "Joint refinement", 0.62, 4.4});
    page.caption(1224, 200, "job over 0.3 s");
}

void states(const Page& page) {
    const Ui& ui = page.ui;
    page.heading(40, 266, "States: word, shape, colour");
    int x = 40;
    for (const State state :
         {State::kAccept, State::kCheck, State::kReject, State::kRunning, State::kWaiting}) {
        const Rect at = page.rect(x + 10, 298, 0, 0);
        draw_state(ui, static_cast<float>(at.x), static_cast<float>(at.y), state, 1.43F,
                   ui.theme.panel);
        page.words(x + 28, 298, FontRole::kTextStrong, colour_of(ui.theme, state), word(state));
        x += 138;
    }
    int number = 0;
    for (const RobotMode mode :
         {RobotMode::kSim, RobotMode::kDry, RobotMode::kLive, RobotMode::kManual}) {
        const Rect at = page.rect(812 + 380 * (number / 2), 284 + 32 * (number % 2), 0, 0);
        ++number;
        const int end = draw_mode_chip(ui, at.x, static_cast<float>(at.y), mode);
        draw_text(ui, static_cast<float>(end) + ui.scale.em(0.43F), static_cast<float>(at.y),
                  FontRole::kSmall, ui.theme.text_second, sentence(mode));
    }
}

void verdicts(const Page& page) {
    page.heading(40, 350, "Verdicts");
    const std::array<VerdictText, 4> cards{
        {{State::kAccept,
          {},
          "Free, 8 of 8 starts agree",
          false,
          "ICP turned `9.977°`, the robot `9.998°`: error `−0.021°` is inside the limit of "
          "`±0.100°`."},
         {State::kCheck,
          {},
          {},
          false,
          "Error `+0.089°` is close to its limit of `±0.100°`. Usable, but look at the overlay "
          "first."},
         {State::kReject,
          {},
          "REG-012",
          true,
          "ICP turned `24.299°`, the robot `10.001°`: error `+14.298°`, limit `±0.100°`."},
         {State::kRunning, "Aligning", "0.6 s", true,
          "Step 15, start 5 of 8. The last verdict stays in the table below."}}};
    int x = 40;
    for (const VerdictText& card : cards) {
        const Rect at = page.rect(x, 372, 372, 0);
        draw_verdict_card(page.ui, at.x, at.y, at.width, card);
        x += 388;
    }
}

void evidence(const Page& page) {
    page.heading(40, 502, "Evidence and rows");
    const std::array<Evidence, 4> rows{{
        {"g.e1", "Angle error", -0.021, "°", 3, true, 0.1, 3, LimitKind::kAtMost, State::kAccept},
        {"g.e2", "Angle error", 0.089, "°", 3, true, 0.1, 3, LimitKind::kAtMost, State::kCheck},
        {"g.e3", "Axis tilt", 1.291, "°", 3, false, 0.2, 3, LimitKind::kAtMost, State::kReject},
        {"g.e4", "Overlap", 41, "%", 0, false, 60, 0, LimitKind::kAtLeast, State::kReject},
    }};
    int y = 520;
    for (const Evidence& row : rows) {
        (void)evidence_row(page.ui, page.rect(40, y, 352, 23), row);
        y += 23;
    }
}

TableRow table_row(State state, std::vector<std::string> numbers, double bar, std::string note) {
    TableRow row;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        row.cells.push_back({numbers[i], i == 1 || i == 2 ? Tone::kThird : Tone::kNormal});
    }
    const Tone tone = state == State::kCheck    ? Tone::kCheck
                      : state == State::kReject ? Tone::kReject
                                                : Tone::kNormal;
    row.cells[5].bar = bar;
    row.cells[5].tone = row.cells[6].tone = tone;
    TableCell decision{std::string(word(state))};
    decision.shape = state;
    decision.note = std::move(note);
    row.cells.insert(row.cells.begin() + 15, decision);
    if (state == State::kReject) row.tint = state;
    return row;
}

void table(const Page& page) {
    const std::array<TableColumn, 17> columns{{{"step", "", 42},
                                               {"try", "", 36},
                                               {"plan", "Angle about J6, deg", 56},
                                               {"robot", "Angle about J6, deg", 66},
                                               {"ICP", "Angle about J6, deg", 66},
                                               {"error", "Angle about J6, deg", 122},
                                               {"err/σ", "Angle about J6, deg", 46},
                                               {"tilt °", "Not seen by the angle", 58},
                                               {"off mm", "Not seen by the angle", 56},
                                               {"slip mm", "Not seen by the angle", 58},
                                               {"ovl %", "Fit", 50},
                                               {"RMS", "Fit", 54},
                                               {"90 %", "Fit", 54},
                                               {"axis inf", "Evidence", 56},
                                               {"mode", "Evidence", 52, false, true},
                                               {"", "Decision", 120, true, true},
                                               {"ICP °", "Sum", 74}}};
    const std::vector<TableRow> rows{
        table_row(State::kAccept,
                  {"10", "1", "10.00", "9.999", "9.994", "−0.005", "0.2", "0.035", "0.08", "−0.05",
                   "85", "0.21", "0.37", "0.88", "Free", "100.06"},
                  -0.05, ""),
        table_row(State::kCheck,
                  {"11", "1", "10.00", "10.002", "10.091", "+0.089", "2.4", "0.022", "0.04",
                   "−0.15", "80", "0.24", "0.33", "0.76", "Free", "110.15"},
                  0.89, "error close to its limit"),
        table_row(State::kAccept,
                  {"14", "1", "10.00", "9.998", "9.977", "−0.021", "0.7", "0.056", "0.09", "+0.09",
                   "88", "0.21", "0.38", "0.92", "Free", "140.07"},
                  -0.21, ""),
        table_row(State::kReject,
                  {"6", "1", "10.00", "10.001", "24.299", "+14.298", "34.9", "1.291", "4.86",
                   "+0.01", "41", "0.20", "0.37", "0.74", "Free", "59.97"},
                  1.0, "step too large")};
    TableRow sum;
    sum.cells.resize(17);
    sum.cells[0] = {"Sum", Tone::kStrong};
    sum.cells[3] = {"140.001"};
    sum.cells[4] = {"140.070"};
    sum.cells[5] = {"+0.069"};
    sum.cells[15] = {"14 of 36 steps, 220.00° to go", Tone::kSecond};
    const std::vector<TableRow> last{sum};
    (void)data_table(page.ui, page.rect(428, 490, 1132, 168), {"g.table", columns, rows, last, 2});
}

void inputs(const Page& page) {
    const Ui& ui = page.ui;
    page.heading(40, 648, "Inputs");
    draw_input(ui, page.rect(40, 672, 96, 26), "10.0", "deg", InputLook::kNormal);
    draw_input(ui, page.rect(148, 672, 96, 26), "10.0", "deg", InputLook::kEditing);
    draw_input(ui, page.rect(256, 672, 96, 26), "400", "deg", InputLook::kWrong);
    page.words(362, 685, FontRole::kSmall, ui.theme.reject, "0.5 to 90 deg");
    const std::array<Option, 2> modes{{{"g.hand", "By hand"}, {"g.run", "Run to 360°"}}};
    (void)segments(ui, page.rect(452, 672, 176, 26), modes, 0);
    (void)check_box(ui, page.rect(640, 672, 60, 26), "g.on", "on", true);
    (void)check_box(ui, page.rect(700, 672, 60, 26), "g.off", "off", false);
    const NumberSpec size{.id = "g.size",
                          .label = "Seen in at least",
                          .value = 4,
                          .decimals = 0,
                          .min = 1,
                          .max = 24};
    (void)slider(ui, page.rect(40, 710, 200, 26), size);
    (void)number_input(ui, page.rect(256, 710, 96, 26),
                       {.id = "g.number",
                        .label = "Seen in at least",
                        .value = 4,
                        .unit = "steps",
                        .decimals = 0,
                        .min = 1,
                        .max = 24});
    const std::array<Option, 3> pages{{{"g.t1", "Table 1", Icon::kTable},
                                       {"g.t2", "Step images", Icon::kImages},
                                       {"g.t3", "Attempts", Icon::kHistory, "15"}}};
    (void)tabs(ui, page.rect(440, 706, 400, 34), pages, 0);
}

void surfaces_and_type(const Page& page) {
    const Ui& ui = page.ui;
    page.heading(40, 770, "Surfaces");
    const std::array<std::pair<const char*, Colour>, 8> surfaces{
        {{"bg0 gaps", ui.theme.bg0},
         {"panel", ui.theme.panel},
         {"raised", ui.theme.raised},
         {"hover", ui.theme.hover},
         {"line", ui.theme.line},
         {"line2", ui.theme.line2},
         {"select", ui.theme.select},
         {"accent.bg", ui.theme.accent_bg}}};
    int x = 40;
    for (const auto& [name, colour] : surfaces) {
        fill(page.rect(x, 786, 84, 32), colour, ui.scale.em(0.21F));
        outline(page.rect(x, 786, 84, 32), ui.theme.line, ui.scale.line(), ui.scale.em(0.21F));
        page.caption(x, 830, name);
        x += 96;
    }
    page.heading(40, 862, "Type");
    page.words(40, 892, FontRole::kTitle, ui.theme.text, "Title 1.43 em");
    page.words(182, 892, FontRole::kVerdict, ui.theme.text, "Verdict 1.14");
    page.words(290, 892, FontRole::kText, ui.theme.text, "Text 1.00");
    page.words(368, 892, FontRole::kTable, ui.theme.text, "Table 0.89");
    page.words(444, 892, FontRole::kSmall, ui.theme.text_second, "Small 0.86");
    page.words(516, 892, FontRole::kCaption, ui.theme.text_third, "Caption 0.79");
    page.words(600, 892, FontRole::kNumberTable, ui.theme.text, "0123456789 −±≤≥°½×Δσ→");
    page.words(40, 924, FontRole::kSmall, ui.theme.text_second,
               "Inter for words, JetBrains Mono for every number that can change.");
    page.words(40, 960, FontRole::kHeading, ui.theme.text, "Commission a cell");
    int icon_x = 440;
    for (const Icon icon : kIcons) {
        const Rect at = page.rect(icon_x % 836, 930 + 26 * (icon_x / 836), 0, 0);
        draw_icon(ui, static_cast<float>(at.x), static_cast<float>(at.y), icon,
                  ui.theme.text_second);
        icon_x += 26;
        if (icon_x % 836 < 440) icon_x += 440 - icon_x % 836;
    }
}

void maps(const Page& page) {
    const Ui& ui = page.ui;
    page.heading(880, 692, "Colour maps");
    const std::array<std::tuple<const char*, ColourMap, const char*, const char*>, 4> rows{
        {{"Step", ColourMap::kStep, "1", "36"},
         {"Seen count", ColourMap::kSeen, "1", "24"},
         {"Residual, mm", ColourMap::kResidual, "0.0", "1.0"},
         {"Depth, disparity", ColourMap::kDepth, "900", "590 mm"}}};
    int y = 718;
    for (const auto& [name, map, low, high] : rows) {
        page.words(880, y, FontRole::kTable, ui.theme.text_second, name);
        page.words(1046, y, FontRole::kNumberTable, ui.theme.text_second, low, Align::kRight);
        draw_map_bar(ui, page.rect(1056, y - 5, 160, 10), map);
        page.words(1226, y, FontRole::kNumberTable, ui.theme.text_second, high);
        y += 26;
    }
    draw_legend(ui, page.rect(1300, 684, 260, 58), {"Step", "best view of each point", "1", "36"},
                ColourMap::kStep, 36, 14);
    draw_legend(ui, page.rect(1300, 754, 260, 58),
                {"Residual", "to the merged surface", "0.0", "1.0 mm"}, ColourMap::kResidual);
}

void dials_and_plot(const Page& page) {
    const Ui& ui = page.ui;
    page.heading(880, 838, "Closure dial, error plot, sparkline");
    draw_closure_dial(ui, page.rect(880, 862, 116, 116), {.next_deg = 10.0});
    draw_closure_dial(ui, page.rect(1010, 862, 116, 116),
                      {.turned_deg = 140.0, .next_deg = 10.0, .robot_deg = 140.0});
    draw_closure_dial(ui, page.rect(1140, 862, 116, 116),
                      {.turned_deg = 250.0, .refused_deg = 10.0, .robot_deg = 260.0});
    std::vector<PlotPoint> points;
    for (int i = 0; i < 14; ++i) {
        const double value = 0.012 * ((i * 7) % 9 - 4);
        points.push_back({value, 0.025 + 0.002 * (i % 3), State::kAccept});
    }
    points[6] = {0.4, 0.03, State::kReject};
    points[10] = {0.089, 0.03, State::kCheck};
    (void)error_plot(ui, page.rect(1272, 854, 288, 126), "g.plot", {points, 36, 0.1, 1, 0});
    draw_sparkline(ui, page.rect(1180, 828, 76, 20), points, 0.1);
}

}  // namespace

void draw_widget_gallery(const Ui& ui) {
    const Page page{ui};
    buttons(page);
    notices(page);
    states(page);
    verdicts(page);
    evidence(page);
    table(page);
    inputs(page);
    surfaces_and_type(page);
    maps(page);
    dials_and_plot(page);
}

}  // namespace gripscan::test
