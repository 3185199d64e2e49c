#include "ui/panels/open_dialog.h"

#include <fmt/format.h>

#include <array>

#include "ui/panels/panel_parts.h"
#include "ui/widgets/dialog_frame.h"
#include "ui/widgets/interact.h"
#include "ui/widgets/text_input.h"

namespace gripscan::ui {
namespace {

constexpr float kRow = 1.86F;
constexpr float kList = 16.0F;

std::string_view word(PathKind kind) {
    return kind == PathKind::kSession ? "session" : kind == PathKind::kCloud ? "cloud" : "";
}

Icon icon_of(PathKind kind) {
    return kind == PathKind::kSession ? Icon::kProcedure
           : kind == PathKind::kCloud ? Icon::kCube
                                      : Icon::kFolder;
}

/// The text of the field once the entry was chosen: a folder is gone into.
std::string typed_of(const PathEntry& entry) {
    return entry.path.string() + (entry.kind == PathKind::kFolder ? "/" : "");
}

bool draw_entry(const Ui& ui, const Rect& row, const std::string& id, const PathEntry& entry) {
    const Theme& t = ui.theme;
    const auto [event, attention] = interact(ui, row, id, entry.name, {}, {});
    if (attention.hovered || attention.focused) fill(row, t.hover, ui.scale.em(0.21F));
    const float y = middle_of(row);
    const bool session = entry.kind == PathKind::kSession;
    draw_icon(ui, static_cast<float>(row.x) + ui.scale.em(1.2F), y, icon_of(entry.kind),
              session ? t.accent_text : t.text_third, FontRole::kIconSmall);
    const float x = static_cast<float>(row.x) + ui.scale.em(2.4F);
    const FontRole role = session ? FontRole::kTableStrong : FontRole::kTable;
    draw_text(
        ui, x, y, role, t.text,
        fitted(ui, role, entry.name, static_cast<float>(row.right()) - x - ui.scale.em(5.0F)));
    draw_text(ui, static_cast<float>(row.right()) - ui.scale.em(0.86F), y, FontRole::kCaption,
              t.text_third, word(entry.kind), Align::kRight);
    return event.clicked;
}

/// The entry that was clicked.
std::optional<PathEntry> draw_list(const Ui& ui, const Rect& area, const PathListing& listing) {
    fill(area, ui.theme.bg0, ui.scale.em(0.36F));
    outline(area, ui.theme.line2, ui.scale.line(), ui.scale.em(0.36F));
    const Rect inside = area.shrunk(ui.em(0.29F));
    if (listing.entries.empty()) {
        draw_text(
            ui, static_cast<float>(area.x) + 0.5F * static_cast<float>(area.width), middle_of(area),
            FontRole::kTable, ui.theme.text_third,
            fitted(ui, FontRole::kTable,
                   listing.problem.empty() ? "No folder and no PCD, PLY or XYZ file begins so."
                                           : listing.problem,
                   static_cast<float>(inside.width)),
            Align::kCentre);
        return std::nullopt;
    }
    std::optional<PathEntry> clicked;
    ScrollArea scroll(ui, inside, "open.list");
    int y = scroll.rect().y;
    const int height = ui.row(kRow);
    for (std::size_t i = 0; i < listing.entries.size(); ++i) {
        const Rect row{inside.x, y, inside.width - ui.em(0.86F), height};
        if (row.bottom() >= inside.y && row.y <= inside.bottom() &&
            draw_entry(ui, row, fmt::format("open.entry{}", i), listing.entries[i])) {
            clicked = listing.entries[i];
        }
        y += height;
    }
    if (listing.cut) {
        draw_text(ui, static_cast<float>(inside.x) + ui.scale.em(2.4F),
                  static_cast<float>(y) + 0.5F * static_cast<float>(height), FontRole::kSmall,
                  ui.theme.text_third, "There are more: type the beginning of the name.");
        y += height;
    }
    scroll.end(y);
    return clicked;
}

void set_path(OpenDialogState& local, std::string path) {
    local.path = std::move(path);
    local.listing = list_paths(local.path);
}

}  // namespace

void draw_open_dialog(const Ui& ui, const Rect& screen, const Snapshot&, OpenDialogState& local,
                      Requests& out) {
    DialogFrame frame(ui, screen,
                      {.id = "dialog.open",
                       .title = "Open recording",
                       .width_em = 44.0F,
                       .body_height = ui.em(kList + 6.5F)});
    if (frame.appeared()) set_path(local, local.path.empty() ? "~/" : local.path);
    Form form(ui, frame.body());
    form.words("A session folder, or a cloud as PCD, PLY or XYZ. It is read, never changed.",
               ui.theme.text_second);
    form.gap(0.57F);
    const TextEvent typed = text_input(ui, form.row({}),
                                       {.id = "open.path",
                                        .label = "Path",
                                        .placeholder = "path of a folder or file",
                                        .icon = Icon::kFolder,
                                        .numbers = true,
                                        .take_keyboard = frame.appeared()},
                                       local.path);
    if (typed.changed) set_path(local, local.path);
    form.y -= ui.em(0.14F);
    const auto clicked = draw_list(ui, form.row({}, kList), local.listing);
    frame.end_body(form.y);

    const std::string problem = open_problem(local.path);
    draw_text(ui, static_cast<float>(frame.footer().x), middle_of(frame.footer()), FontRole::kSmall,
              ui.theme.text_third,
              fitted(ui, FontRole::kSmall, problem,
                     static_cast<float>(frame.footer().width) - ui.scale.em(18.0F)));
    const std::array<ButtonSpec, 2> buttons{{{.id = "open.cancel", .label = "Cancel"},
                                             {.id = "open.open",
                                              .label = "Open",
                                              .icon = Icon::kFolder,
                                              .key = "Enter",
                                              .look = ButtonLook::kNext,
                                              .why_disabled = problem}}};
    const auto pressed = dialog_buttons(ui, frame, buttons);
    frame.end();
    if (clicked) set_path(local, typed_of(*clicked));
    const bool open = pressed == 1U || (typed.entered && problem.empty());
    if (open) out.push_back(request::Open{expanded(local.path)});
    if (open || pressed == 0U || frame.closed()) out.push_back(request::Show{Dialog::kNone});
}

}  // namespace gripscan::ui
