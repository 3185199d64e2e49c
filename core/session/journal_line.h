// A line of the journal as text. For the sources of this folder only.
#pragma once

#include <optional>
#include <string>

#include "core/session/journal_file.h"

namespace gripscan {

/// One JSON object with its check sum, and the line end.
[[nodiscard]] std::string journal_line(const JournalEntry& entry);
/// Nothing if the line (without its end) is not what journal_line() writes.
[[nodiscard]] std::optional<JournalEntry> parse_journal_line(const std::string& line);

}  // namespace gripscan
