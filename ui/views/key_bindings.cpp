#include "ui/views/key_bindings.h"

#include "ui/views/actions.h"
#include "ui/views/view_keys.h"

namespace gripscan::ui {
std::vector<KeyBinding> key_bindings(const WindowPreferences& preferences) {
    std::vector<KeyBinding> keys;
    for (const Action& a : actions()) {
        if (a.key.empty()) continue;
        keys.push_back({std::string(a.name), std::string(a.label),
                        std::string(key_of(a, preferences)), std::string(word(a.group)),
                        std::string(a.key)});
    }
    for (const ViewKey& v : view_keys()) {
        keys.push_back({std::string(v.name), std::string(v.label),
                        std::string(chosen_key(v.name, v.key, preferences)), "3D view",
                        std::string(v.key)});
    }
    return keys;
}

}  // namespace gripscan::ui
