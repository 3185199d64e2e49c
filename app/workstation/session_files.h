// Where the window keeps things: the user's sessions, which were opened lately, what was set.
#pragma once

#include <filesystem>

namespace gripscan::app {

struct SessionFiles {
    std::filesystem::path sessions;     ///< folder of new sessions
    std::filesystem::path state;        ///< folder of the list of recent sessions
    std::filesystem::path preferences;  ///< file
};

/// New sessions in ~/gripscan, the rest by the XDG base directories.
[[nodiscard]] SessionFiles session_files_of_user();

/// A folder for a new session that is not there yet: `kind` with day and time, and a number where
/// that is taken.
[[nodiscard]] std::filesystem::path new_session_folder(const std::filesystem::path& sessions,
                                                       const std::string& kind);

}  // namespace gripscan::app
