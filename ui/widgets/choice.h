// One of a few: segments and tabs; and a check box.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "ui/widgets/ui.h"

namespace gripscan::ui {

struct Option {
    std::string_view id;  ///< "mode.by_hand"
    std::string_view label;
    Icon icon = Icon::kNone;      ///< of tabs
    std::string_view count = {};  ///< of tabs, in grey: "15"
    std::string_view why_disabled = {};
};

/// Segments of equal width; returns the index that was clicked.
[[nodiscard]] std::optional<std::size_t> segments(const Ui& ui, const Rect& rect,
                                                  std::span<const Option> options,
                                                  std::size_t chosen);

/// Tabs from the left of `rect`, each as wide as its words; the chosen one has a line under it.
[[nodiscard]] std::optional<std::size_t> tabs(const Ui& ui, const Rect& rect,
                                              std::span<const Option> options, std::size_t chosen);

/// Returns true when it was clicked.
[[nodiscard]] bool check_box(const Ui& ui, const Rect& rect, std::string_view id,
                             std::string_view label, bool on, std::string_view why_disabled = {});

}  // namespace gripscan::ui
