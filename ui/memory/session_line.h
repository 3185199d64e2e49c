// What the start page says about a session, read from its folder.
#pragma once

#include <filesystem>

#include "ui/views/snapshot.h"

namespace gripscan::ui {

/// Reads descriptions, journal and results; writes nothing. A folder that is absent or holds no
/// session is a line too: kMissing, with the reason. `last_used` is left to the caller.
[[nodiscard]] RecentSession session_line(const std::filesystem::path& folder);

}  // namespace gripscan::ui
