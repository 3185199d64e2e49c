// The keys of the 3D view, remappable like all others.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "ui/views/snapshot.h"

namespace gripscan::ui {

enum class ViewCommand {
    kFitSelection,
    kFitAll,
    kFront,
    kSide,
    kTop,
    kAlongAxis,
    kStereoCamera,
    kMeasure,
    kSideBySide,
    kEyeDome,
    kLarger,
    kSmaller,
};

struct ViewKey {
    ViewCommand command;
    std::string_view name;   ///< "view.fit"
    std::string_view label;  ///< "Fit what is selected"
    std::string_view key;    ///< by default: "F", "Home", "Ctrl+1"
};
[[nodiscard]] std::span<const ViewKey> view_keys();

/// What that key does in the 3D view, with the user's changes; nothing: not a key of it.
[[nodiscard]] std::optional<ViewCommand> view_command(std::string_view key,
                                                      const WindowPreferences& preferences);

}  // namespace gripscan::ui
