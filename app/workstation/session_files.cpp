#include "app/workstation/session_files.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <cstdlib>
#include <ctime>

#include "ui/memory/preferences_file.h"
#include "ui/memory/recent_sessions.h"

namespace gripscan::app {
namespace fs = std::filesystem;

SessionFiles session_files_of_user() {
    const char* home_variable = std::getenv("HOME");
    const fs::path home = home_variable != nullptr ? home_variable : "";
    const fs::path own = (home.is_absolute() ? home : fs::temp_directory_path()) / "gripscan";
    return {own, ui::state_folder().value_or(own),
            ui::config_folder().value_or(own) / "preferences.json"};
}

fs::path new_session_folder(const fs::path& sessions, const std::string& kind) {
    const std::time_t now = std::time(nullptr);
    const std::string name = fmt::format("{}-{:%Y-%m-%d-%H%M}", kind, fmt::localtime(now));
    fs::path folder = sessions / name;
    std::error_code code;
    for (int n = 2; fs::exists(folder, code); ++n) {
        folder = sessions / fmt::format("{}-{}", name, n);
    }
    return folder;
}

}  // namespace gripscan::app
