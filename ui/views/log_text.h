// Which lines of the log are shown, and how. Pure.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ui/theme/state.h"
#include "ui/views/snapshot.h"

namespace gripscan::ui {

struct LogFilter {
    LogLevel least = LogLevel::kInformation;
    std::string search;  ///< in code and text, whatever the case; empty: all
};

/// Indices of the lines that pass, in order.
[[nodiscard]] std::vector<std::size_t> filtered(std::span<const LogLine> log,
                                                const LogFilter& filter);
/// "14:22:09", local time.
[[nodiscard]] std::string clock_text(std::chrono::system_clock::time_point when);
[[nodiscard]] State state_of(LogLevel level);
/// The lines for the clipboard: time, level, code, text, one a line.
[[nodiscard]] std::string log_for_clipboard(std::span<const LogLine> log, const LogFilter& filter);
/// "all levels", "warnings", "errors".
[[nodiscard]] std::string_view word_at_least(LogLevel level);
/// The level of the worst line; for the mark on a tab.
[[nodiscard]] LogLevel worst_of(std::span<const LogLine> log);

}  // namespace gripscan::ui
