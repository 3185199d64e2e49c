// What can be done with one row of Table 1. Pure.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ui/views/request.h"
#include "ui/views/snapshot.h"

namespace gripscan::ui {

struct RowCommand {
    std::string_view id;  ///< "row.retake"
    std::string label;    ///< "Take capture 14 again"
    std::string_view tooltip;
    Request request;
    std::optional<std::string> why_not;
};

/// Of a row of table_of; empty for a row that is not there.
[[nodiscard]] std::vector<RowCommand> row_commands(const Snapshot& snapshot, std::size_t row);

}  // namespace gripscan::ui
