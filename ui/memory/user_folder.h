// Where the user's files lie, after the XDG base directory specification.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace gripscan::ui {

/// The folder gripscan/ under $`variable` where that is an absolute path, else under
/// $HOME/`beside_home`; nothing where neither is set.
[[nodiscard]] std::optional<std::filesystem::path> user_folder(const char* variable,
                                                               std::string_view beside_home);

}  // namespace gripscan::ui
