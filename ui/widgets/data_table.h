// A table of numbers: grouped columns, a header that stays, rows that scroll, last rows that stay.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ui/widgets/draw.h"
#include "ui/widgets/state_shape.h"

namespace gripscan::ui {

struct TableColumn {
    std::string_view title;
    std::string_view group = {};  ///< over it; a new one begins where it changes
    float width_px = 50.0F;       ///< at 100 %; the one `fills` column gets what is left
    bool fills = false;
    bool words = false;  ///< left-aligned words; else right-aligned numbers
    int drop = 0;        ///< in a narrow window columns with the smallest drop > 0 go first
};

enum class Tone { kNormal, kSecond, kThird, kStrong, kCheck, kReject };

struct TableCell {
    std::string text = {};
    Tone tone = Tone::kNormal;
    std::optional<State> shape = std::nullopt;  ///< before the words
    std::string note = {};                      ///< after them, in grey
    std::optional<double> bar = std::nullopt;   ///< centred on zero, −1 … 1 is the limit
};

struct TableRow {
    std::vector<TableCell> cells;  ///< one a column
    std::optional<State> tint = std::nullopt;
};

struct TableSpec {
    std::string_view id;
    std::span<const TableColumn> columns;
    std::span<const TableRow> rows;
    std::span<const TableRow> last_rows = {};  ///< stay at the bottom
    std::optional<std::size_t> selected = std::nullopt;
    bool follow_end = false;  ///< scroll to the last row when one was added
};

struct TableEvent {
    std::optional<std::size_t> clicked;
    std::optional<std::size_t> menu;  ///< right-clicked
};

[[nodiscard]] TableEvent data_table(const Ui& ui, const Rect& rect, const TableSpec& spec);

/// Indices of the columns that have room, in order.
[[nodiscard]] std::vector<std::size_t> columns_with_room(std::span<const TableColumn> columns,
                                                         float width_px);

}  // namespace gripscan::ui
