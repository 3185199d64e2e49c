#include "ui/views/key_bindings.h"

#include "ui/views/actions.h"
#include "ui/views/view_keys.h"

namespace gripscan::ui {
namespace {

/// The user's key, where there is one.
std::string chosen_key(std::string_view action, std::string_view standard,
                       const WindowPreferences& preferences) {
    for (const auto& [name, key] : preferences.keys) {
        if (name == action) return key;
    }
    return std::string(standard);
}

}  // namespace

std::vector<KeyBinding> key_bindings(const WindowPreferences& preferences) {
    std::vector<KeyBinding> keys;
    for (const Action& a : actions()) {
        if (a.key.empty()) continue;
        keys.push_back({std::string(a.name), std::string(a.label),
                        chosen_key(a.name, a.key, preferences), std::string(word(a.group)),
                        std::string(a.key)});
    }
    for (const ViewKey& v : view_keys()) {
        keys.push_back({std::string(v.name), std::string(v.label),
                        chosen_key(v.name, v.key, preferences), "3D view", std::string(v.key)});
    }
    return keys;
}

}  // namespace gripscan::ui
