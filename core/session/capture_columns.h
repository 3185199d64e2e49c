// The columns of captures.csv as a table: name, how a cell is read, how it is written. For the
// sources of this folder only.
#pragma once

#include <span>
#include <string_view>

#include "core/session/capture_table.h"

namespace gripscan {

struct CaptureColumn {
    std::string_view name;
    /// Says what is wrong with a cell that is not empty; nothing if it was taken.
    std::optional<std::string> (*read)(CaptureRow& row, const std::string& cell);
    std::string (*write)(const CaptureRow& row);
};

[[nodiscard]] std::span<const CaptureColumn> capture_columns();
/// Null for a column the contract does not know.
[[nodiscard]] const CaptureColumn* find_capture_column(std::string_view name);

}  // namespace gripscan
