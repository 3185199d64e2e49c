// A menu at the mouse, as a right click opens it.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "ui/widgets/ui.h"

namespace gripscan::ui {

struct MenuItem {
    std::string_view id;  ///< "recent.forget"
    std::string_view label;
    Icon icon = Icon::kNone;
    std::string_view why_disabled = {};
};

/// Opens the menu of that id at the mouse.
void open_menu(std::string_view menu_id);

/// Draws it while it is open; the index that was chosen, which closes it. `is_open` tells whether
/// it is shown.
[[nodiscard]] std::optional<std::size_t> popup_menu(const Ui& ui, std::string_view menu_id,
                                                    std::span<const MenuItem> items,
                                                    bool* is_open = nullptr);

}  // namespace gripscan::ui
