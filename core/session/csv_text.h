// Comma-separated values (RFC 4180): quoted cells, both line ends, UTF-8 with or without mark.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace gripscan {

struct CsvLine {
    int line = 0;  ///< in the file, from 1
    std::vector<std::string> cells;
};

/// Empty lines are left out. `file` is for messages only.
[[nodiscard]] Result<std::vector<CsvLine>> parse_csv(std::string_view file, std::string_view text);

/// A cell without the blanks around it.
[[nodiscard]] std::string trimmed(const std::string& text);

/// Cells joined by commas, quoted where needed, with the line end.
[[nodiscard]] std::string csv_line(const std::vector<std::string>& cells);

}  // namespace gripscan
