// Everything that can be done by a button or a key: the one table behind the buttons, the keyboard,
// the key overlay and the settings. Pure.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "ui/views/request.h"
#include "ui/views/snapshot.h"

namespace gripscan::ui {

enum class ActionGroup { kProcedure, kResults, kWindow };
/// "Procedure", "Results", "Window": headings of the key overlay.
[[nodiscard]] std::string_view word(ActionGroup group);

struct Action {
    std::string_view name;     ///< "step.capture": also the id of its button
    std::string_view label;    ///< "Capture"
    std::string_view key;      ///< by default: "C", "Ctrl+Z", "F1", "Esc"; empty: none
    std::string_view tooltip;  ///< what it does, one sentence
    ActionGroup group = ActionGroup::kProcedure;
    Request (*request)(const Snapshot&) = nullptr;
    /// Why it cannot be done now; nothing: it can.
    std::optional<std::string> (*refusal)(const Snapshot&) = nullptr;
};

/// In the order in which the overlay lists them. Commands of the procedure are named
/// "step." + word(command).
[[nodiscard]] std::span<const Action> actions();
/// Throws std::out_of_range for a name that is not in the table: names are written in the code.
[[nodiscard]] const Action& action(std::string_view name);
/// The action that gives a command; null for those that need an argument (exclude, retake, tell).
[[nodiscard]] const Action* action_of(const Command& command);

/// The action that is highlighted and that Space presses; null: there is none.
[[nodiscard]] const Action* next_action(const Snapshot& snapshot);
/// What its button says: "Step +10° and capture", "Halve to 5° and capture".
[[nodiscard]] std::string next_label(const Action& action, const Snapshot& snapshot);
/// The action that the advisor would take after the next one; null: there is none.
[[nodiscard]] const Action* second_advice(const Snapshot& snapshot);

/// The user's key of what is called `name`, else its standard one.
[[nodiscard]] std::string_view chosen_key(std::string_view name, std::string_view standard,
                                          const WindowPreferences& preferences);
/// The key of an action: the user's, else the default.
[[nodiscard]] std::string_view key_of(const Action& action, const WindowPreferences& preferences);
/// Who has that key; null: nobody. Space belongs to the next action whatever the user set.
[[nodiscard]] const Action* owner_of(std::string_view key, const WindowPreferences& preferences);

/// What a press of that key asks for; nothing for a key without an action and for an action that
/// cannot be done now.
[[nodiscard]] Requests requests_for_key(std::string_view key, const Snapshot& snapshot);

}  // namespace gripscan::ui
