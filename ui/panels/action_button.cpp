#include "ui/panels/action_button.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace gripscan::ui {
namespace {

struct IconOf {
    std::string_view action;
    Icon icon;
};
constexpr std::array<IconOf, 25> kIconsOfActions{
    {{"step.connect", Icon::kLink},      {"step.check_cell", Icon::kTarget},
     {"step.warm_up", Icon::kProcedure}, {"step.capture", Icon::kCamera},
     {"step.step", Icon::kStep},         {"step.retry", Icon::kRetry},
     {"step.accept", Icon::kCheck},      {"step.back", Icon::kBack},
     {"step.run", Icon::kPlay},          {"step.pause", Icon::kPause},
     {"step.stop", Icon::kStop},         {"step.resume", Icon::kPlay},
     {"step.finish", Icon::kCube},       {"step.undo", Icon::kUndo},
     {"step.redo", Icon::kRedo},         {"table.copy", Icon::kCopy},
     {"table.csv", Icon::kDownload},     {"window.export", Icon::kExport},
     {"window.report", Icon::kChart},    {"window.screenshot", Icon::kCamera},
     {"window.theme", Icon::kTheme},     {"window.settings", Icon::kSettings},
     {"window.keys", Icon::kHelp},       {"page.procedure", Icon::kProcedure},
     {"page.template", Icon::kCube}}};

}  // namespace

Icon icon_of(const Action& action) {
    const auto found =
        std::find_if(kIconsOfActions.begin(), kIconsOfActions.end(),
                     [&](const IconOf& entry) { return entry.action == action.name; });
    return found == kIconsOfActions.end() ? Icon::kNone : found->icon;
}

void action_button(const Ui& ui, const Rect& rect, const Action& action, const Snapshot& snapshot,
                   const ActionLook& look, Requests& out) {
    const auto why = action.refusal(snapshot);
    const std::string why_disabled = why.value_or(std::string());
    const bool next = look.look == ButtonLook::kNext;
    const bool pressed =
        button(ui, rect,
               {.id = action.name,
                .label = look.label.empty() ? action.label : look.label,
                .icon = look.icon ? icon_of(action) : Icon::kNone,
                .key = next ? std::string_view("Space") : key_of(action, snapshot.preferences),
                .look = look.look,
                .why_disabled = why_disabled,
                .tooltip = action.tooltip})
            .clicked;
    if (pressed) out.push_back(action.request(snapshot));
}

void action_icon(const Ui& ui, const Rect& rect, const Action& action, const Snapshot& snapshot,
                 Requests& out) {
    const auto why = action.refusal(snapshot);
    const std::string why_disabled = why.value_or(std::string());
    const std::string_view key = key_of(action, snapshot.preferences);
    const std::string tooltip =
        key.empty() ? std::string(action.label) : fmt::format("{} ({})", action.label, key);
    const bool pressed = icon_button(ui, rect,
                                     {.id = action.name,
                                      .label = {},
                                      .icon = icon_of(action),
                                      .why_disabled = why_disabled,
                                      .tooltip = tooltip})
                             .clicked;
    if (pressed) out.push_back(action.request(snapshot));
}

}  // namespace gripscan::ui
