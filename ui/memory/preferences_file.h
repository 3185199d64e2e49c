// What the user set, kept between runs of the program: preferences.json, gripscan-preferences/1.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "ui/layout/window_layout.h"
#include "ui/views/snapshot.h"

namespace gripscan::ui {

/// $XDG_CONFIG_HOME/gripscan, else ~/.config/gripscan; nothing where neither is known.
[[nodiscard]] std::optional<std::filesystem::path> config_folder();

struct StoredPreferences {
    WindowPreferences preferences;
    Splits splits;
};

struct LoadedPreferences {
    StoredPreferences stored;
    std::vector<std::string> refused;  ///< one sentence for every value that was not taken
};

/// An absent file gives the defaults. A value that is unknown, of the wrong type or absurd is
/// refused by name and has its default; a file of another version is refused as a whole.
[[nodiscard]] LoadedPreferences load_preferences(const std::filesystem::path& file);

[[nodiscard]] Status save_preferences(const std::filesystem::path& file,
                                      const StoredPreferences& stored);

}  // namespace gripscan::ui
