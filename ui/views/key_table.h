// The keys of the window as tables: grouped, searched, and whether a new one may be taken.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ui/views/snapshot.h"

namespace gripscan::ui {

struct KeyGroup {
    std::string name;
    std::vector<const KeyBinding*> keys;  ///< in their order
};
/// In order of their first key; those whose label, key or group holds the search.
[[nodiscard]] std::vector<KeyGroup> key_groups(std::span<const KeyBinding> keys,
                                               std::string_view search = {});

/// Why the action cannot have this key; empty: it can.
[[nodiscard]] std::string key_problem(std::span<const KeyBinding> keys, std::string_view action,
                                      std::string_view key);

}  // namespace gripscan::ui
