#include "ui/views/key_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace gripscan::ui {
namespace {

std::string lower(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

/// Keys that always mean the same.
constexpr std::array<std::string_view, 3> kReserved{"Esc", "Tab", "Enter"};

}  // namespace

std::vector<KeyGroup> key_groups(std::span<const KeyBinding> keys, std::string_view search) {
    std::vector<KeyGroup> groups;
    const std::string wanted = lower(search);
    for (const KeyBinding& key : keys) {
        const std::string text = lower(key.label + "\n" + key.key + "\n" + key.group);
        if (text.find(wanted) == std::string::npos) continue;
        auto group = std::find_if(groups.begin(), groups.end(),
                                  [&](const KeyGroup& g) { return g.name == key.group; });
        if (group == groups.end()) group = groups.insert(groups.end(), {key.group, {}});
        group->keys.push_back(&key);
    }
    return groups;
}

std::string key_problem(std::span<const KeyBinding> keys, std::string_view action,
                        std::string_view key) {
    if (std::find(kReserved.begin(), kReserved.end(), key) != kReserved.end()) {
        return fmt::format("{} always means the same", key);
    }
    for (const KeyBinding& other : keys) {
        if (other.action != action && other.key == key) {
            return fmt::format("{} is the key of \"{}\"", key, other.label);
        }
    }
    return {};
}

}  // namespace gripscan::ui
